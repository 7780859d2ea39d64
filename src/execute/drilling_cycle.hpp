#pragma once
// Fixed cycles for holes along Z, given one short step after another so that neither thousands of repetitions
// nor thousands of pecks need memory.

#include <cstdint>

#include "execute/action_queue.hpp"
#include "execute/state.hpp"

namespace kerf {

/// What one fixed-cycle block does. Levels are machine coordinates without length offset, in mm.
struct DrillingPlan {
  std::int32_t repetitions = 1;
  AxisVector first_hole;  ///< X and Y of the first hole
  AxisVector step;        ///< X and Y distance from hole to hole
  bool drills = true;     ///< false: only the moves in X and Y
  double r_level = 0.0;
  double bottom = 0.0;
  double return_level = 0.0;  ///< initial level (G98) or R level (G99)
  double peck = 0.0;          ///< depth of a step; 0: one stroke
  double clearance = 1.0;     ///< rapid re-approach stops this far above the last depth
  double dwell_s = 0.0;       ///< at the bottom
  bool feed_out = false;      ///< back to R at the feed rate
  bool spindle_stop = false;  ///< spindle off at the bottom, on again at the return level
  double spindle_rpm = 0.0;   ///< for switching on again
  double spindle_wait_s = 0.0;
};

class DrillingCycle {
 public:
  bool running() const { return phase_ != Phase::done; }
  void start(const DrillingPlan& plan, const Origin& origin);
  /// Pushes the actions of the next step (at most 4) and moves the registers' position along.
  void step(Registers& registers, const AxisVector& work_origin, ActionQueue& queue);

 private:
  enum class Phase : std::uint8_t { position, approach, feed, retract, reapproach, leave, done };

  void feed_down(Registers& registers, const AxisVector& work_origin, ActionQueue& queue);
  void leave(Registers& registers, const AxisVector& work_origin, ActionQueue& queue);
  void next_hole();

  DrillingPlan plan_;
  Origin origin_;
  AxisVector hole_;
  double depth_ = 0.0;  // reached so far
  std::int32_t done_ = 0;
  Phase phase_ = Phase::done;
};

}  // namespace kerf
