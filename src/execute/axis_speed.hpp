#pragma once
// The highest rates of an axis, which depend on the set that a move keeps to.

#include "machine/machine.hpp"

namespace kerf {

/// Rates of an axis in a set, all of them above 0.
inline AxisRates rates_of(const AxisSettings& axis, RateSet set) {
  const double rapid_acceleration =
      axis.rapid_acceleration > 0.0 ? axis.rapid_acceleration : axis.acceleration;
  AxisRates rates{axis.rapid, axis.max_feed, axis.acceleration, rapid_acceleration};
  if (set == 0) return rates;
  const AxisRates& own = axis.other_rates[set - std::size_t{1}];
  if (own.rapid > 0.0) rates.rapid = own.rapid;
  if (own.max_feed > 0.0) rates.max_feed = own.max_feed;
  if (own.acceleration > 0.0) rates.acceleration = own.acceleration;
  if (own.rapid_acceleration > 0.0) rates.rapid_acceleration = own.rapid_acceleration;
  return rates;
}

}  // namespace kerf
