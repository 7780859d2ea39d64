#pragma once
// What the number of a word turned out to be.

#include <cstdint>

namespace kerf {

/// Why a number is refused.
enum class NumberFault : std::uint8_t {
  none,
  range,          ///< outside the range of the address
  decimal_point,  ///< the address takes none, or wants one
};

struct NumberResult {
  double value = 0.0;
  NumberFault fault = NumberFault::none;
};

}  // namespace kerf
