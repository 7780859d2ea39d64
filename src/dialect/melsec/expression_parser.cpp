#include "dialect/melsec/expression_parser.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace kerf::melsec {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

struct Named {
  std::string_view name;
  ExpressionOp op;
};

constexpr std::array kFunctions{
    Named{"SIN", ExpressionOp::sine},         Named{"COS", ExpressionOp::cosine},
    Named{"TAN", ExpressionOp::tangent},      Named{"ASIN", ExpressionOp::arc_sine},
    Named{"ACOS", ExpressionOp::arc_cosine},  Named{"ATAN", ExpressionOp::arc_tangent},
    Named{"SQRT", ExpressionOp::square_root}, Named{"ABS", ExpressionOp::absolute},
    Named{"BIN", ExpressionOp::from_bcd},     Named{"BCD", ExpressionOp::to_bcd},
    Named{"ROUND", ExpressionOp::round},      Named{"FIX", ExpressionOp::truncate},
    Named{"FUP", ExpressionOp::round_up},     Named{"LN", ExpressionOp::logarithm},
    Named{"EXP", ExpressionOp::exponential},  Named{"POW", ExpressionOp::power},
};

constexpr std::array kComparisons{
    Named{"EQ", ExpressionOp::equal},         Named{"NE", ExpressionOp::not_equal},
    Named{"GT", ExpressionOp::greater},       Named{"LT", ExpressionOp::less},
    Named{"GE", ExpressionOp::greater_equal}, Named{"LE", ExpressionOp::less_equal},
};

constexpr std::array kLogical{
    Named{"OR", ExpressionOp::bit_or},
    Named{"XOR", ExpressionOp::bit_xor},
    Named{"AND", ExpressionOp::bit_and},
};

/// Values that a constant, a function or a bracket may add to the stack; the limit of five bracket levels
/// keeps any block far below the machine's stack.
constexpr int kDeepest = static_cast<int>(kExpressionStack) - 1;

}  // namespace

constexpr std::string_view kNoValue =
    "A value was expected here: a number, a variable, a function or a bracket.";

bool ExpressionParser::fail(std::string_view detail, std::size_t length) {
  if (fault_.detail.empty()) fault_ = {detail, at_, length};
  return false;
}

bool ExpressionParser::fail(std::string_view detail, std::string_view message) {
  if (fault_.detail.empty()) fault_ = {detail, at_, 1, message};
  return false;
}

char ExpressionParser::peek() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  return at_ < text_.size() ? text_[at_] : '\0';
}

bool ExpressionParser::at_end() {
  return peek() == '\0';
}

bool ExpressionParser::take(std::string_view text) {
  peek();
  if (text_.substr(at_, text.size()) != text) return false;
  at_ += text.size();
  return true;
}

bool ExpressionParser::at_operator() {
  const std::size_t start = at_;
  const char c = peek();
  bool found = c == '+' || c == '-' || c == '*' || c == '/';
  if (c == 'M' || c == 'O' || c == 'X' || c == 'A') {
    found = take("MOD");
    for (const Named& logical : kLogical) found = found || take(logical.name);
  }
  at_ = start;
  return found;
}

bool ExpressionParser::push(ExpressionOp op, double operand) {
  if (is_binary(op)) --depth_;
  if (op <= ExpressionOp::variable) ++depth_;
  if (depth_ > kDeepest) return fail("032DH");
  steps_.push_back({op, operand});
  return true;
}

bool ExpressionParser::number(double& value) {
  peek();
  const std::size_t start = at_;
  bool any = false;
  while (at_ < text_.size() && is_digit(text_[at_])) any = true, ++at_;
  if (at_ < text_.size() && text_[at_] == '.') {
    ++at_;
    while (at_ < text_.size() && is_digit(text_[at_])) any = true, ++at_;
  }
  if (!any) {
    at_ = start;
    return fail("0306H", "A number was expected here.");
  }
  const char* first = text_.data() + start;
  if (std::from_chars(first, text_.data() + at_, value).ec != std::errc()) value = HUGE_VAL;
  return true;
}

bool ExpressionParser::value() {
  if (!sum()) return false;
  // OR, XOR and AND have one priority and work from left to right (decisions.md).
  for (;;) {
    const Named* found = nullptr;
    for (const Named& logical : kLogical) {
      if (found == nullptr && take(logical.name)) found = &logical;
    }
    if (found == nullptr) return true;
    if (!sum() || !push(found->op)) return false;
  }
}

bool ExpressionParser::sum() {
  if (!product()) return false;
  for (;;) {
    const char c = peek();
    if (c != '+' && c != '-') return true;
    ++at_;
    if (!product() || !push(c == '+' ? ExpressionOp::add : ExpressionOp::subtract)) return false;
  }
}

bool ExpressionParser::product() {
  if (!signed_primary()) return false;
  for (;;) {
    ExpressionOp op = ExpressionOp::multiply;
    if (take("*")) {
    } else if (take("/")) {
      op = ExpressionOp::divide;
    } else if (take("MOD")) {
      op = ExpressionOp::modulo;
    } else {
      return true;
    }
    if (!signed_primary() || !push(op)) return false;
  }
}

bool ExpressionParser::signed_primary() {
  const char sign = peek();
  if (sign != '+' && sign != '-') return primary();
  ++at_;
  if (const char second = peek(); second == '+' || second == '-')
    return fail("0306H", "Two signs stand in a row.");
  return primary() && (sign == '+' || push(ExpressionOp::negate));
}

bool ExpressionParser::primary() {
  const char c = peek();
  if (c == '#') {
    ++at_;
    return variable();
  }
  if (c == '[') {
    ++at_;
    return value() && (take("]") || fail("0306H", "A closing bracket was expected here."));
  }
  if (is_digit(c) || c == '.') {
    double constant = 0.0;
    return number(constant) && push(ExpressionOp::constant, constant);
  }
  return function();
}

bool ExpressionParser::function() {
  for (const Named& function : kFunctions) {
    if (!take(function.name)) continue;
    if (!take("[")) return fail("0306H", "A function has its argument in brackets.");
    if (!value()) return false;
    if (function.op == ExpressionOp::power && !(take(",") && value())) {
      return fail("0306H", "POW has two arguments with a comma between them.");
    }
    return (take("]") || fail("0306H", "A closing bracket was expected here.")) && push(function.op);
  }
  return fail("0306H", kNoValue);
}

bool ExpressionParser::variable() {
  if (!variable_number(false)) return false;
  ExpressionStep& last = steps_.back();
  if (last.op != ExpressionOp::constant) return push(ExpressionOp::indirect);
  last.op = ExpressionOp::variable;
  return true;
}

bool ExpressionParser::variable_number(bool assigned) {
  const char c = peek();
  if (c == '#') {
    ++at_;
    return variable();
  }
  if (c == '[') {
    ++at_;
    if (!value() || !(take("]") || fail("0306H", "A closing bracket was expected here."))) return false;
    // A bracket is never folded into the variable step: #[206] and #206 differ for what is defined.
    return steps_.back().op != ExpressionOp::constant || push(ExpressionOp::truncate);
  }
  if (is_digit(c) || c == '.') {
    double constant = 0.0;
    const std::size_t start = at_;
    if (!number(constant)) return false;
    if (assigned && constant != std::trunc(constant)) {
      at_ = start;
      return fail("032AH");
    }
    return push(ExpressionOp::constant, constant);
  }
  if (c == '-' || c == '+') {
    const std::size_t start = at_++;
    const char second = peek();
    at_ = start;
    return fail(second == '-' || second == '+' ? "0306H" : "032AH");
  }
  return fail("0306H", kNoValue);
}

bool ExpressionParser::condition() {
  if (!value()) return false;
  for (const Named& comparison : kComparisons) {
    if (take(comparison.name)) return value() && push(comparison.op);
  }
  return fail("0306H", kNoValue);
}

}  // namespace kerf::melsec
