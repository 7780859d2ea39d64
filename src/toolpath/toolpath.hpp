#pragma once
// The passes between the interpreter and the planner, in their order.

#include "toolpath/axis_motion.hpp"
#include "toolpath/radius_compensation.hpp"
#include "toolpath/travel_limits.hpp"

namespace kerf {

/// The toolpath of an upstream whose `next()` gives the actions of a program (nullptr at the end, and again
/// after it): compensated, checked against the travel of the axes,
/// and made moves of the axes. Allocates nothing after construction.
/// Too large for a small stack (about 100 kB).
template <class Upstream>
class Toolpath {
 public:
  /// Upstream must outlive the toolpath.
  Toolpath(Upstream& upstream, const Machine& machine, const ToolpathPolicy& policy)
      : compensated_{&upstream, RadiusCompensationPass(policy.compensation)},
        limited_{&compensated_, TravelLimitPass(machine, policy.limits)},
        axes_(machine) {}

  Toolpath(const Toolpath&) = delete;
  Toolpath& operator=(const Toolpath&) = delete;

  /// The next action, valid until the following call; nullptr at the end. An alarm, of the upstream or of a
  /// pass, is the last action unless recover() is called.
  const Action* next() {
    if (stopped_) return nullptr;
    const Action* action = axes_.next(limited_);
    stopped_ = action != nullptr && stops_program(*action);
    return action;
  }

  /// After an alarm: goes on with the next block.
  void recover() {
    stopped_ = false;
    if constexpr (requires { compensated_.upstream->recover(); }) compensated_.upstream->recover();
  }

  /// Back to the start, for a program that begins anew.
  void reset() {
    compensated_.pass.reset();
    limited_.pass.reset();
    axes_.reset();
    stopped_ = false;
  }

 private:
  struct Compensated {
    Upstream* upstream;
    RadiusCompensationPass pass;
    const Action* next() { return pass.next(*upstream); }
  };

  struct Limited {
    Compensated* upstream;
    TravelLimitPass pass;
    const Action* next() { return pass.next(*upstream); }
  };

  Compensated compensated_;
  Limited limited_;
  AxisMotionPass axes_;
  bool stopped_ = false;
};

}  // namespace kerf
