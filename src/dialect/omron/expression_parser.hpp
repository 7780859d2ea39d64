#pragma once
// Reads expressions and conditions into steps for a stack machine (manual 4-1).

#include <string>
#include <vector>

#include "dialect/omron/scanner.hpp"
#include "syntax/expression.hpp"

namespace kerf::omron {

/// What an expression gives. A truth value is no number and a number no truth value (manual 4-1-4).
enum class ValueKind : std::uint8_t { number, truth };

/// Priorities from high to low: unary minus, !, * / %, + -, comparisons, &&, ||; operators of one priority
/// work from left to right. Every function that reads leaves the cursor behind what it took, or sets the
/// scanner's fault and returns false.
class ExpressionParser {
 public:
  ExpressionParser(Scanner& scanner, std::vector<ExpressionStep>& steps) : scanner_(scanner), steps_(steps) {}

  /// A number; the steps read are `ref`.
  bool number(ExpressionRef& ref) { return whole(ValueKind::number, ref); }
  /// A truth value, its parentheses read already or still to be read by the caller.
  bool condition(ExpressionRef& ref) { return whole(ValueKind::truth, ref); }
  /// A variable as it is named: L12.
  bool variable(ExpressionRef& ref);
  /// The number of a variable that comes next, see variables.hpp.
  bool variable_address(std::int64_t& number);

  /// The text of the last expression as intermediate code writes it.
  const std::string& text() const { return text_; }

 private:
  bool whole(ValueKind wanted, ExpressionRef& ref);
  bool binary(int least_priority, ValueKind& kind);
  bool operand(ValueKind& kind);
  bool minus(ValueKind& kind);
  bool negation(ValueKind& kind);
  bool parentheses(ValueKind& kind);
  bool constant();
  bool function();
  bool captured_position();
  bool arguments(int count);
  bool push(ExpressionOp op, double operand = 0.0);
  bool wants(ValueKind wanted, ValueKind found, std::size_t from);

  Scanner& scanner_;
  std::vector<ExpressionStep>& steps_;
  std::string text_;
  int stack_ = 0;  ///< values on the stack at this point
  int depth_ = 0;  ///< parentheses and signs open at this point
};

}  // namespace kerf::omron
