#pragma once
// The axes' limits as the planner needs them.

#include <cmath>

#include "execute/axis_speed.hpp"
#include "machine/machine.hpp"

namespace kerf {

/// Per second, and inverted where the planner divides by them. Axes the machine lacks limit nothing: their
/// inverses are 0.
struct AxisLimits {
  AxisVector acceleration;                ///< mm/s2
  AxisVector feed;                        ///< mm/s
  AxisVector inverse_acceleration;        ///< s2/mm
  AxisVector inverse_feed;                ///< s/mm, of the highest cutting feed
  AxisVector inverse_rapid;               ///< s/mm
  AxisVector inverse_rapid_acceleration;  ///< s2/mm
  bool feed_of_all_axes = false;          ///< MotionSettings::feed_of_all_axes
  AxisSet followers;                      ///< axes whose way is that of another: nothing of theirs counts
};

inline AxisLimits make_axis_limits(const Machine& machine, RateSet set = 0) {
  AxisLimits limits;
  limits.followers = machine.followers();
  limits.feed_of_all_axes = machine.motion.feed_of_all_axes;
  for (const Axis axis : machine.axes) {
    if (limits.followers.contains(axis)) continue;
    const AxisRates rates = rates_of(machine[axis], set);
    limits.acceleration[axis] = rates.acceleration;
    limits.feed[axis] = rates.max_feed / 60.0;
    limits.inverse_acceleration[axis] = 1.0 / rates.acceleration;
    limits.inverse_feed[axis] = 60.0 / rates.max_feed;
    limits.inverse_rapid[axis] = 60.0 / rates.rapid;
    limits.inverse_rapid_acceleration[axis] = 1.0 / rates.rapid_acceleration;
  }
  return limits;
}

}  // namespace kerf
