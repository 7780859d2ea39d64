#pragma once
// The highest speeds of an axis, which depend on how the path is to be followed.

#include "execute/action.hpp"
#include "machine/machine.hpp"

namespace kerf {

/// Highest rapid speed of an axis in a path mode, mm/min or degree/min.
inline double rapid_of(const AxisSettings& axis, PathMode mode) {
  const bool accurate = mode == PathMode::high_accuracy && axis.high_accuracy_rapid > 0.0;
  return accurate ? axis.high_accuracy_rapid : axis.rapid;
}

/// Highest cutting feed of an axis in a path mode, mm/min or degree/min.
inline double max_feed_of(const AxisSettings& axis, PathMode mode) {
  const bool accurate = mode == PathMode::high_accuracy && axis.high_accuracy_max_feed > 0.0;
  return accurate ? axis.high_accuracy_max_feed : axis.max_feed;
}

}  // namespace kerf
