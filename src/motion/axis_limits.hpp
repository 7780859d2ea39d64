#pragma once
// The axes' limits as the planner needs them.

#include <cmath>

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
};

inline AxisLimits make_axis_limits(const Machine& machine) {
  AxisLimits limits;
  for (const Axis axis : machine.axes) {
    const AxisSettings& settings = machine[axis];
    limits.acceleration[axis] = settings.acceleration;
    limits.feed[axis] = settings.max_feed / 60.0;
    limits.inverse_acceleration[axis] = 1.0 / settings.acceleration;
    limits.inverse_feed[axis] = 60.0 / settings.max_feed;
    limits.inverse_rapid[axis] = 60.0 / settings.rapid;
  }
  return limits;
}

}  // namespace kerf
