#pragma once
// Computes the expressions of a macro language.

#include "execute/macro_variables.hpp"
#include "syntax/expression.hpp"

namespace kerf {

enum class MathFault : std::uint8_t {
  none,
  no_variable,    ///< a variable number that does not exist
  zero_divisor,   ///< division or remainder by zero
  out_of_domain,  ///< no value exists: the root of a negative number, the tangent of 90 degrees
};

/// The value of an expression, IEEE doubles throughout; overflow gives an infinity, without a fault. Angles
/// are degrees. Bitwise operations work on 32-bit two's complement of the operands without their fractions.
/// Source of the rules: MELSEC manual, operation commands of the macro chapter.
MathFault evaluate(Expression expression, const MacroVariables& variables, double& value);

}  // namespace kerf
