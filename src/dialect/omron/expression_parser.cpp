#include "dialect/omron/expression_parser.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "dialect/omron/variables.hpp"
#include "execute/scalar_functions.hpp"

namespace kerf::omron {
namespace {

constexpr std::string_view kNoValue = "A number, a variable, a function or a parenthesis was expected here.";
constexpr std::string_view kCapturedPosition = "_CNC_CapturedPosition";
constexpr int kDeepest = static_cast<int>(kExpressionStack) - 1;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

struct Operator {
  std::string_view text;
  int priority = 0;
  ExpressionOp op = ExpressionOp::add;
  ValueKind takes = ValueKind::number;
  ValueKind gives = ValueKind::number;
};

constexpr int kLowest = 1;

// Longer ones first, so that <= is not taken for <.
constexpr std::array kOperators{
    Operator{"||", 1, ExpressionOp::either, ValueKind::truth, ValueKind::truth},
    Operator{"&&", 2, ExpressionOp::both, ValueKind::truth, ValueKind::truth},
    Operator{"==", 3, ExpressionOp::equal, ValueKind::number, ValueKind::truth},
    Operator{"!=", 3, ExpressionOp::not_equal, ValueKind::number, ValueKind::truth},
    Operator{"<=", 3, ExpressionOp::less_equal, ValueKind::number, ValueKind::truth},
    Operator{">=", 3, ExpressionOp::greater_equal, ValueKind::number, ValueKind::truth},
    Operator{"<", 3, ExpressionOp::less, ValueKind::number, ValueKind::truth},
    Operator{">", 3, ExpressionOp::greater, ValueKind::number, ValueKind::truth},
    Operator{"+", 4, ExpressionOp::add},
    Operator{"-", 4, ExpressionOp::subtract},
    Operator{"*", 5, ExpressionOp::multiply},
    Operator{"/", 5, ExpressionOp::quotient},
    Operator{"%", 5, ExpressionOp::remainder},
};

const Operator* operator_at(Scanner& scanner) {
  if (scanner.peek() == '\0') return nullptr;
  for (const Operator& found : kOperators) {
    if (scanner.at() == found.text[0] && (found.text.size() == 1 || scanner.at(1) == found.text[1]))
      return &found;
  }
  return nullptr;
}

}  // namespace

bool ExpressionParser::whole(ValueKind wanted, ExpressionRef& ref) {
  text_.clear();
  stack_ = depth_ = 0;
  ref.begin = static_cast<std::uint32_t>(steps_.size());
  ValueKind found = ValueKind::number;
  scanner_.peek();
  const std::size_t from = scanner_.position();
  if (!binary(kLowest, found)) return false;
  if (scanner_.peek() == '=') return scanner_.fail("syntax", "A comparison for equality is written ==.");
  if (!wants(wanted, found, from)) return false;
  ref.count = static_cast<std::uint32_t>(steps_.size()) - ref.begin;
  return true;
}

bool ExpressionParser::wants(ValueKind wanted, ValueKind found, std::size_t from) {
  if (wanted == found) return true;
  return scanner_.fail("truth-value",
                       wanted == ValueKind::truth ? "A number stands where a condition is expected."
                                                  : "A condition stands where a number is expected.",
                       scanner_.span_from(from));
}

bool ExpressionParser::push(ExpressionOp op, double operand) {
  if (is_binary(op)) --stack_;
  if (op <= ExpressionOp::variable) ++stack_;
  if (stack_ > kDeepest) return scanner_.fail("nesting", "The expression is nested too deeply.");
  steps_.push_back({op, operand});
  return true;
}

bool ExpressionParser::binary(int least_priority, ValueKind& kind) {
  scanner_.peek();
  const std::size_t from = scanner_.position();
  if (!operand(kind)) return false;
  for (;;) {
    const Operator* found = operator_at(scanner_);
    if (found == nullptr || found->priority < least_priority) return true;
    if (!wants(found->takes, kind, from)) return false;
    scanner_.skip(found->text.size());
    const bool spaced = found->priority <= 3;
    if (spaced) text_ += ' ';
    text_ += found->text;
    if (spaced) text_ += ' ';
    scanner_.peek();
    const std::size_t right_from = scanner_.position();
    ValueKind right = ValueKind::number;
    if (!binary(found->priority + 1, right) || !wants(found->takes, right, right_from)) return false;
    if (!push(found->op)) return false;
    kind = found->gives;
  }
}

bool ExpressionParser::operand(ValueKind& kind) {
  kind = ValueKind::number;
  const char c = scanner_.peek();
  if (c == '-') return minus(kind);
  if (c == '!') return negation(kind);
  if (c == '(') return parentheses(kind);
  if (c == '+') {
    scanner_.skip();
    if (!is_digit(scanner_.at()) && scanner_.at() != '.')
      return scanner_.fail("syntax", "A plus sign in front of a value may only be part of a number.");
    text_ += '+';
    return constant();
  }
  if (is_digit(c) || c == '.') return constant();
  if (c == 'L' || c == 'Q' || c == 'P') {
    std::int64_t number = 0;
    const std::size_t from = scanner_.position();
    if (!variable_address(number)) return false;
    text_ += scanner_.since(from);
    return push(ExpressionOp::variable, static_cast<double>(number));
  }
  return function();
}

bool ExpressionParser::minus(ValueKind& kind) {
  scanner_.skip();
  text_ += '-';
  if (const char next = scanner_.peek(); next == '-' || next == '+')
    return scanner_.fail("syntax", "Two signs stand in a row.");
  const std::size_t from = scanner_.position();
  if (++depth_ > kDeepest) return scanner_.fail("nesting", "The expression is nested too deeply.");
  if (!operand(kind) || !wants(ValueKind::number, kind, from)) return false;
  --depth_;
  if (steps_.back().op != ExpressionOp::constant) return push(ExpressionOp::negate);
  steps_.back().operand = -steps_.back().operand;
  return true;
}

bool ExpressionParser::negation(ValueKind& kind) {
  scanner_.skip();
  text_ += '!';
  if (scanner_.peek() != '(') return scanner_.fail("syntax", "The condition behind ! stands in parentheses.");
  const std::size_t from = scanner_.position();
  return parentheses(kind) && wants(ValueKind::truth, kind, from) && push(ExpressionOp::negation);
}

bool ExpressionParser::parentheses(ValueKind& kind) {
  if (++depth_ > kDeepest) return scanner_.fail("nesting", "The expression is nested too deeply.");
  scanner_.skip();
  text_ += '(';
  if (!binary(kLowest, kind)) return false;
  if (!scanner_.take(')')) return scanner_.fail("syntax", "A closing parenthesis was expected here.");
  text_ += ')';
  --depth_;
  return true;
}

bool ExpressionParser::constant() {
  const std::size_t from = scanner_.position();
  bool any = false;
  while (is_digit(scanner_.at())) any = true, scanner_.skip();
  if (scanner_.at() == '.') scanner_.skip();
  while (is_digit(scanner_.at())) any = true, scanner_.skip();
  if (!any) return scanner_.fail("syntax", "A point without a digit is no number.");
  const char exponent = scanner_.at();
  if (exponent == 'e' || exponent == 'E') {
    const bool sign = scanner_.at(1) == '+' || scanner_.at(1) == '-';
    if (is_digit(scanner_.at(sign ? 2 : 1))) {
      scanner_.skip(sign ? 2 : 1);
      while (is_digit(scanner_.at())) scanner_.skip();
    }
  }
  const std::string_view written = scanner_.since(from);
  double value = 0.0;
  if (std::from_chars(written.data(), written.data() + written.size(), value).ec != std::errc())
    value = HUGE_VAL;
  text_ += written;
  return push(ExpressionOp::constant, value);
}

bool ExpressionParser::variable_address(std::int64_t& number) {
  const char bank = scanner_.peek();
  const std::size_t from = scanner_.position();
  if (bank != 'L' && bank != 'Q' && bank != 'P')
    return scanner_.fail("variable", "The name of a variable was expected here: L, Q or P and a number.");
  scanner_.skip();
  if (scanner_.at() == '[')
    return scanner_.fail("indirection", "The address of a variable cannot come from another variable.",
                         scanner_.span_from(from));
  std::int64_t address = 0;
  if (!is_digit(scanner_.at()))
    return scanner_.fail("variable", "A number belongs behind the letter of a variable.",
                         scanner_.span_from(from));
  while (is_digit(scanner_.at())) {
    address = std::min<std::int64_t>(address * 10 + (scanner_.at() - '0'), 1'000'000);
    scanner_.skip();
  }
  const auto found = variable_number(bank, address);
  if (!found) return scanner_.fail("variable", {}, scanner_.span_from(from));
  number = *found;
  return true;
}

bool ExpressionParser::variable(ExpressionRef& ref) {
  ref = {static_cast<std::uint32_t>(steps_.size()), 1};
  stack_ = 0;
  std::int64_t number = 0;
  return variable_address(number) && push(ExpressionOp::variable, static_cast<double>(number));
}

/// Where the skip inputs caught the motors (manual G31): a system variable with an index.
bool ExpressionParser::captured_position() {
  text_ += kCapturedPosition;
  return arguments(1) && push(ExpressionOp::system_value);
}

bool ExpressionParser::function() {
  if (scanner_.take_name(kCapturedPosition)) return captured_position();
  const std::string_view name = scanner_.name();
  if (name.empty()) return scanner_.fail("syntax", kNoValue);
  const auto found = find_scalar_function(name);
  if (!found) return scanner_.fail("function", {}, scanner_.span_here(name.size()));
  scanner_.skip(name.size());
  text_ += name;
  return arguments(found->arguments) &&
         push(found->arguments == 2 ? ExpressionOp::call2 : ExpressionOp::call1,
              static_cast<double>(found->number));
}

bool ExpressionParser::arguments(int count) {
  if (!scanner_.take('('))
    return scanner_.fail("syntax", "The arguments of a function stand in parentheses.");
  text_ += '(';
  if (++depth_ > kDeepest) return scanner_.fail("nesting", "The expression is nested too deeply.");
  for (int i = 0; i < count; ++i) {
    if (i > 0 && !scanner_.take(',')) return scanner_.fail("syntax", "This function has two arguments.");
    if (i > 0) text_ += ',';
    ValueKind kind = ValueKind::number;
    scanner_.peek();
    const std::size_t from = scanner_.position();
    if (!binary(kLowest, kind) || !wants(ValueKind::number, kind, from)) return false;
  }
  if (scanner_.peek() == ',') return scanner_.fail("syntax", "The function has too many arguments.");
  if (!scanner_.take(')')) return scanner_.fail("syntax", "A closing parenthesis was expected here.");
  text_ += ')';
  --depth_;
  return true;
}

}  // namespace kerf::omron
