#pragma once
// Reads the expressions of one block into steps for a stack machine (manual 5.8, 5.9).

#include <string_view>
#include <vector>

#include "syntax/expression.hpp"

namespace kerf::melsec {

/// What a reader found wrong: the details code of the alarm and where, in bytes from the start of the block.
struct ParseFault {
  std::string_view detail;  ///< empty: nothing
  std::size_t at = 0;
  std::size_t length = 1;
  std::string_view message = {};  ///< empty: the alarm's own cause says it
};

/// A cursor over one block. Every function that reads leaves the cursor behind what it took, or sets the
/// fault and returns false. Blanks may stand between any two parts.
class ExpressionParser {
 public:
  explicit ExpressionParser(std::vector<ExpressionStep>& steps) : steps_(steps) {}
  /// Begins a block.
  void begin(std::string_view block) {
    text_ = block;
    at_ = 0;
    fault_ = {};
  }

  /// Begins an expression of its own; the place of its first step.
  std::size_t begin_expression() {
    depth_ = 0;
    return steps_.size();
  }
  /// A value: variables, constants and functions with operators; steps are appended.
  bool value();
  /// A condition: two values with EQ, NE, GT, LT, GE or LE between them, brackets excluded.
  bool condition();
  /// The number of a variable, the # being read already. `assigned`: the variable is to be defined.
  bool variable_number(bool assigned);

  /// Takes the text when it comes next.
  bool take(std::string_view text);
  bool at_end();
  /// The next character that is no blank; 0 at the end.
  char peek();
  /// An arithmetic or logical operator comes next.
  bool at_operator();
  /// A number without sign.
  bool number(double& value);
  bool fail(std::string_view detail, std::size_t length = 1);
  /// `message` stays: a literal.
  bool fail(std::string_view detail, std::string_view message);

  std::string_view text() const { return text_; }
  std::size_t position() const { return at_; }
  void set_position(std::size_t at) { at_ = at; }
  const ParseFault& fault() const { return fault_; }

 private:
  bool sum();
  bool product();
  bool signed_primary();
  bool primary();
  bool variable();
  bool function();
  bool push(ExpressionOp op, double operand = 0.0);

  std::string_view text_;
  std::vector<ExpressionStep>& steps_;
  std::size_t at_ = 0;
  int depth_ = 0;  ///< values of the expression on the stack at this point
  ParseFault fault_;
};

}  // namespace kerf::melsec
