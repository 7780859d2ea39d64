#pragma once
// Functions of real numbers that a language may offer by name, after IEEE 754 and the C library: outside of
// its domain a function gives what is no number or an infinity, never a fault.

#include <cstddef>
#include <optional>
#include <string_view>

namespace kerf {

/// The place of a function among all of them, as ExpressionOp::call1 and call2 name it, and its arguments.
struct ScalarFunction {
  std::size_t number = 0;
  int arguments = 1;  ///< 1 or 2
};

/// `sin` and the like count in radians, `sind` and the like in degrees; `atan2(y, x)` as in C; `rint` rounds
/// halves to even, `int` downwards as `floor`.
std::optional<ScalarFunction> find_scalar_function(std::string_view name);

/// The value of a function of one argument, and of one of two.
double scalar_function(std::size_t number, double argument);
double scalar_function(std::size_t number, double first, double second);

}  // namespace kerf
