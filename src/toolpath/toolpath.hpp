#pragma once
// The passes between the interpreter and the planner, in their order.

#include "toolpath/axis_motion.hpp"
#include "toolpath/corner_override.hpp"
#include "toolpath/corner_rounding.hpp"
#include "toolpath/normal_line_pass.hpp"
#include "toolpath/polar_pass.hpp"
#include "toolpath/radius_compensation.hpp"
#include "toolpath/travel_limits.hpp"

namespace kerf {

/// The toolpath of an upstream whose `next()` gives the actions of a program (nullptr at the end, and again
/// after it): corners rounded, compensated, slowed before inner
/// corners, with the axis of normal line control, checked against the travel of the axes,
/// and made moves of the axes. Allocates nothing after construction.
/// Too large for a small stack (about 100 kB).
template <class Upstream>
class Toolpath {
 public:
  /// Upstream must outlive the toolpath.
  Toolpath(Upstream& upstream, const Machine& machine, const ToolpathPolicy& policy)
      : rounded_{&upstream, CornerRounding(policy.normal_line)},
        compensated_{&rounded_, RadiusCompensationPass(policy.compensation)},
        slowed_{&compensated_, CornerOverridePass(policy.corner_override)},
        turned_{&slowed_, NormalLinePass(machine, policy.normal_line)},
        polar_{&turned_, PolarPass(policy.polar)},
        limited_{&polar_, TravelLimitPass(machine, policy.limits)},
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
    if constexpr (requires { rounded_.upstream->recover(); }) rounded_.upstream->recover();
  }

  /// Back to the start, for a program that begins anew.
  void reset() {
    rounded_.pass.reset();
    compensated_.pass.reset();
    slowed_.pass.reset();
    turned_.pass.reset();
    polar_.pass.reset();
    limited_.pass.reset();
    axes_.reset();
    stopped_ = false;
  }

 private:
  /// A pass with what stands in front of it.
  template <class Before, class Pass>
  struct Stage {
    Before* upstream;
    Pass pass;
    const Action* next() { return pass.next(*upstream); }
  };
  using Rounded = Stage<Upstream, CornerRounding>;
  using Compensated = Stage<Rounded, RadiusCompensationPass>;
  using Slowed = Stage<Compensated, CornerOverridePass>;
  using Turned = Stage<Slowed, NormalLinePass>;
  using Polar = Stage<Turned, PolarPass>;
  using Limited = Stage<Polar, TravelLimitPass>;

  Rounded rounded_;
  Compensated compensated_;
  Slowed slowed_;
  Turned turned_;
  Polar polar_;
  Limited limited_;
  AxisMotionPass axes_;
  bool stopped_ = false;
};

}  // namespace kerf
