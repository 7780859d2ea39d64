#pragma once
// Round numbers for drawings: ticks of axes, lengths of scale bars.

#include <string>
#include <vector>

namespace kerf {

/// The smallest of 1, 2 or 5 times a power of ten that is at least `value` (> 0).
double round_up_125(double value);

/// The largest of 1, 2 or 5 times a power of ten that is at most `value` (> 0).
double round_down_125(double value);

/// Multiples of `step` from `low` to `high`; at most 200.
std::vector<double> ticks_between(double low, double high, double step);

/// The tick with as many decimals as the step needs, e.g. "2.5" for multiples of 0.5.
std::string tick_text(double tick, double step);

}  // namespace kerf
