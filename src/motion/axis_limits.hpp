#pragma once
// The axes' limits as the planner needs them.

#include <cmath>

#include "execute/axis_speed.hpp"
#include "machine/machine.hpp"

namespace kerf {

/// Per second, and inverted where the planner divides by them. Axes the machine lacks limit nothing: their
/// inverses are 0.
struct AxisLimits {
  AxisVector acceleration;          ///< mm/s2
  AxisVector feed;                  ///< mm/s
  AxisVector inverse_acceleration;  ///< s2/mm
  AxisVector inverse_feed;          ///< s/mm, of the highest cutting feed
  AxisVector inverse_rapid;         ///< s/mm
  bool feed_of_all_axes = false;    ///< MotionSettings::feed_of_all_axes
  AxisSet followers;                ///< axes whose way is that of another: nothing of theirs counts
};

inline AxisLimits make_axis_limits(const Machine& machine, PathMode mode = PathMode::cutting) {
  AxisLimits limits;
  limits.followers = machine.followers();
  limits.feed_of_all_axes = machine.motion.feed_of_all_axes;
  for (const Axis axis : machine.axes) {
    if (limits.followers.contains(axis)) continue;
    const AxisSettings& settings = machine[axis];
    limits.acceleration[axis] = settings.acceleration;
    limits.feed[axis] = max_feed_of(settings, mode) / 60.0;
    limits.inverse_acceleration[axis] = 1.0 / settings.acceleration;
    limits.inverse_feed[axis] = 60.0 / max_feed_of(settings, mode);
    limits.inverse_rapid[axis] = 60.0 / rapid_of(settings, mode);
  }
  return limits;
}

}  // namespace kerf
