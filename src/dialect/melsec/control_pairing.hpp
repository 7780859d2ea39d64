#pragma once
// Which ELSE, ENDIF and END belong to which IF, WHILE and DO.

#include <vector>

#include "syntax/compiled_program.hpp"

namespace kerf::melsec {

enum class ControlKind : std::uint8_t {
  if_then,       ///< IF ... THEN with nothing behind it: needs an ENDIF
  if_operation,  ///< IF ... THEN with an operation, or with ELSE in the same block: an ENDIF is optional
  else_then,     ///< ELSE
  end_if,
  loop,  ///< WHILE ... DO, or DO
  end_loop,
};

/// A control statement in the order of the text.
struct Control {
  ControlKind kind = ControlKind::if_then;
  StatementIndex statement = 0;  ///< of the if_then, else_part, while_do, end_do or nothing
  StatementIndex last = 0;       ///< last statement of its block
  std::int32_t number = 0;       ///< of a loop
};

/// Fills in the loops and ranges of the program, the jumps of its control statements and the loop and range
/// of every statement. What belongs to nothing, or overlaps, becomes a fault: 0330H for IF, 0334H for loops.
void pair_controls(CompiledProgram& program, const std::vector<Control>& controls);

}  // namespace kerf::melsec
