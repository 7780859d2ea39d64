#pragma once
// What a trajectory gives: control cycles, and the times of finished actions.

#include <cstdint>

#include "base/axis.hpp"
#include "execute/action.hpp"
#include "motion/path_segment.hpp"

namespace kerf {

/// One control cycle of the command: a point and its time.
struct Cycle : PathPoint {
  double time_s = 0.0;             ///< since the start; the n-th cycle is at n times the control cycle
  double path_speed_mm_min = 0.0;  ///< measured as the feed is: see PathSegment
  Origin origin;                   ///< the action in progress
};

enum class StepResult : std::uint8_t {
  cycle,         ///< a control cycle
  held,          ///< a control cycle at rest that nothing but a change of the override ends: the feed is 0
  needs_action,  ///< no cycle: push more actions, or finish()
  finished,      ///< no cycle: everything pushed is done
};

enum class BlockKind : std::uint8_t { rapid, cutting, dwell, tool_change, spindle, other };

/// What became of one pushed action, told in order when it is done.
struct BlockTiming {
  BlockKind kind = BlockKind::other;
  double start_s = 0.0;  ///< planned time, not rounded to cycles
  double duration_s = 0.0;
  double length_mm = 0.0;         ///< way of the tool in X, Y and Z
  double peak_feed_mm_min = 0.0;  ///< highest path speed
  bool goes_on = false;           ///< a piece of a move (PolarPieces) that more pieces follow
};

/// Largest magnitudes and range of each axis's command so far.
struct MotionExtremes {
  AxisVector velocity;  ///< mm/s; on lines that of the plan, on arcs the largest at cycles and ends of phases
  AxisVector acceleration;  ///< mm/s2, likewise; inside segments, so without the steps at corners
  AxisVector corner_step;   ///< mm/s: change of velocity from one segment to the next, in no time
  AxisVector jerk;  ///< mm/s3: change of acceleration from one cycle to the next, divided by the cycle
  AxisVector low;   ///< machine coordinates
  AxisVector high;
};

}  // namespace kerf
