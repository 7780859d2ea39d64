#pragma once
// Expressions of a macro language as compact code for a stack machine.

#include <cstdint>
#include <span>

namespace kerf {

/// What a step does with the stack: a leaf pushes a value, a unary step replaces the top, a binary step
/// replaces the two on top by one.
enum class ExpressionOp : std::uint8_t {
  constant,  ///< push ExpressionStep::operand
  variable,  ///< push the variable whose number is ExpressionStep::operand
  indirect,  ///< the variable whose number is on top
  negate,
  // binary
  add,
  subtract,
  multiply,
  divide,
  modulo,
  bit_or,
  bit_xor,
  bit_and,
  equal,
  not_equal,
  greater,
  less,
  greater_equal,
  less_equal,
  power,
  quotient,   ///< of IEEE arithmetic: x / 0 is an infinity, 0 / 0 is no number
  remainder,  ///< with the sign of the dividend; x % 0 is no number
  both,       ///< truth values are 1 and 0
  either,
  call2,  ///< the function of two arguments with the number ExpressionStep::operand (scalar_functions.hpp)
  // functions of one argument; angles in degrees
  sine,
  cosine,
  tangent,
  arc_sine,
  arc_cosine,
  arc_tangent,
  square_root,
  absolute,
  from_bcd,
  to_bcd,
  round,
  truncate,  ///< towards zero
  round_up,  ///< away from zero
  logarithm,
  exponential,
  negation,      ///< of a truth value
  call1,         ///< as call2, with one argument
  system_value,  ///< the value of the controller whose number is on top
};

constexpr bool is_binary(ExpressionOp op) {
  return op >= ExpressionOp::add && op <= ExpressionOp::call2;
}

struct ExpressionStep {
  ExpressionOp op = ExpressionOp::constant;
  double operand = 0.0;
};

using Expression = std::span<const ExpressionStep>;

/// The stack an expression may need. Compilers refuse what would need more.
inline constexpr std::size_t kExpressionStack = 64;

/// A stretch of the steps of a compiled program.
struct ExpressionRef {
  std::uint32_t begin = 0;
  std::uint32_t count = 0;  ///< 0: no expression
};

}  // namespace kerf
