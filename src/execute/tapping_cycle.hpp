#pragma once
// Fixed cycles for threads along Z, given one short step after another so that thousands of repetitions need
// no memory. Source of the steps: OMRON NC Integrated Controller, G74 and G84.

#include <cstdint>

#include "execute/action_queue.hpp"

namespace kerf {

/// What one tapping block does. Positions and levels are machine coordinates of the axes, in mm.
struct TappingPlan {
  AxisVector start;       ///< where the axes stand
  AxisVector first_hole;  ///< X and Y of the first hole
  AxisVector step;        ///< X and Y distance from hole to hole
  AxisVector origin;      ///< of the coordinates that moves show as commanded
  std::int32_t repetitions = 1;
  double r_level = 0.0;
  double bottom = 0.0;
  double return_level = 0.0;  ///< initial level or R level
  double dwell_s = 0.0;       ///< at the bottom
  double feed = 0.0;          ///< mm/min
  RateSet rates = 0;
  SpindleDirection cuts = SpindleDirection::clockwise;  ///< on the way in
  double rpm = 0.0;
  double orient_rpm = 0.0;
  double orient_angle = 0.0;      ///< degrees
  bool has_spindle_axis = false;  ///< it turns with Z along the strokes; else the machine is told to turn it
};

class TappingCycle {
 public:
  bool running() const { return phase_ != Phase::done; }
  void start(const TappingPlan& plan, const Origin& origin);
  /// Pushes the actions of the next step, at most 4.
  void step(ActionQueue& queue);

 private:
  enum class Phase : std::uint8_t { begin, position, approach, cut, withdraw, leave, end, done };

  void go(MoveMode mode, const AxisVector& target, ActionQueue& queue, double turns = 0.0);
  AxisVector at_level(double z) const;
  void spindle(SpindleDirection direction, ActionQueue& queue) const;
  void next_hole();

  TappingPlan plan_;
  Origin origin_;
  AxisVector at_;
  AxisVector hole_;
  double turns_ = 0.0;  ///< of the spindle axis along a stroke inwards, positive clockwise
  std::int32_t done_ = 0;
  Phase phase_ = Phase::done;
};

}  // namespace kerf
