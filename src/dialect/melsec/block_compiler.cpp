#include "dialect/melsec/block_compiler.hpp"

#include <algorithm>
#include <array>

#include "dialect/melsec/alarms.hpp"
#include "syntax/decimal_reader.hpp"

namespace kerf::melsec {
namespace {

constexpr std::size_t kDeepestBrackets = 5;
constexpr std::int64_t kHighestSequenceNumber = 99999;
constexpr std::int32_t kHighestLoop = 127;

constexpr std::array<std::string_view, 8> kKeywords{"IF",  "GOTO",  "WHILE", "DO",
                                                    "END", "ENDIF", "ELSE",  "THEN"};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}

bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}

/// What is wrong with the brackets of a block, and where.
struct BracketFault {
  std::string_view detail;  ///< empty: nothing
  std::size_t at = 0;
};

BracketFault bracket_fault(std::string_view block) {
  std::array<std::size_t, kDeepestBrackets + 1> opened{};
  std::size_t depth = 0;
  std::size_t too_deep = std::string_view::npos;
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (block[i] == '[') {
      if (depth < opened.size()) opened[depth] = i;
      if (++depth == kDeepestBrackets + 1 && too_deep == std::string_view::npos) too_deep = i;
    } else if (block[i] == ']') {
      if (depth == 0) return {"032EH", i};
      --depth;
    }
  }
  if (depth > 0) return {"032EH", opened[std::min(depth, opened.size()) - 1]};
  if (too_deep != std::string_view::npos) return {"032DH", too_deep};
  return {};
}

}  // namespace

void BlockCompiler::compile(std::string_view line, const SourceSpan& span) {
  parser_.begin(line);
  span_ = span;
  number_ = -1;
  first_statement_ = program_.statements.size();
  const std::size_t words = program_.words.size();
  const std::size_t controls = controls_.size();
  if (!block()) {
    program_.statements.resize(first_statement_);
    program_.words.resize(words);
    controls_.resize(controls);
    fault();
  }
  if (number_ > 0) program_.labels.push_back({number_, static_cast<StatementIndex>(first_statement_)});
}

void BlockCompiler::fault() {
  const ParseFault& found = parser_.fault();
  SourceSpan place = span_;
  place.offset += found.at;
  place.column += static_cast<std::uint32_t>(found.at);
  const std::size_t left = span_.length - std::min<std::size_t>(span_.length, found.at);
  place.length = static_cast<std::uint32_t>(std::max<std::size_t>(1, std::min(found.length, left)));
  program_.faults.push_back({&alarm_kind(found.detail), place, found.message});
  add(StatementKind::fault).jump = static_cast<StatementIndex>(program_.faults.size() - 1);
}

Statement& BlockCompiler::add(StatementKind kind) {
  Statement& statement = program_.statements.emplace_back();
  statement.span = span_;
  statement.kind = kind;
  statement.first_of_block = program_.statements.size() == first_statement_ + 1;
  statement.sequence_number = number_;
  return statement;
}

void BlockCompiler::control(ControlKind kind, std::int32_t number) {
  controls_.push_back({kind, last(), last(), number});
}

ExpressionRef BlockCompiler::since(std::size_t first_step) const {
  return {static_cast<std::uint32_t>(first_step),
          static_cast<std::uint32_t>(program_.steps.size() - first_step)};
}

bool BlockCompiler::block() {
  // What reads the text takes a zero byte for its end.
  if (const std::size_t zero = parser_.text().find('\0'); zero != std::string_view::npos) {
    parser_.set_position(zero);
    return parser_.fail("0305H", "A zero byte stands in the block.");
  }
  if (const BracketFault found = bracket_fault(parser_.text()); !found.detail.empty()) {
    parser_.set_position(found.at);
    return parser_.fail(found.detail);
  }
  return sequence_number() && statement();
}

bool BlockCompiler::sequence_number() {
  if (!parser_.take("N")) return true;
  if (!is_digit(parser_.peek())) return parser_.fail("0306H", "N has a plain number behind it.");
  const std::size_t start = parser_.position();
  const char* p = parser_.text().data() + start;
  const char* const first = p;
  Decimal number;
  read_decimal(p, number);
  const auto length = static_cast<std::size_t>(p - first);
  if (number.has_point) return parser_.fail("031AH", length);
  if (number.overflow || number.digits > kHighestSequenceNumber) return parser_.fail("0308H", length);
  parser_.set_position(start + length);
  number_ = static_cast<std::int32_t>(number.digits);
  return true;
}

bool BlockCompiler::statement() {
  const char c = parser_.peek();
  if (c == '#') return assignment() && nothing_more();
  if (!at_keyword()) return words();
  if (parser_.take("IF")) return if_statement() && nothing_more();
  if (parser_.take("GOTO")) return go_to({}) && nothing_more();
  if (parser_.take("WHILE")) return while_statement() && nothing_more();
  if (parser_.take("ELSE")) return else_statement() && nothing_more();
  if (parser_.take("THEN")) return parser_.fail("0330H");
  if (parser_.take("ENDIF")) {
    add(StatementKind::nothing);
    control(ControlKind::end_if);
    return nothing_more();
  }
  if (parser_.take("END")) return end_statement() && nothing_more();
  if (parser_.take("DO")) return do_statement({}) && nothing_more();
  return words();
}

/// Two letters in a row: no word begins so, only a keyword or a function.
bool BlockCompiler::at_keyword() {
  const bool letter = is_upper(parser_.peek());
  const std::size_t next = parser_.position() + 1;
  return letter && next < parser_.text().size() && is_upper(parser_.text()[next]);
}

/// An operation or control command stands alone in its block: a word behind it is 032CH, as is an operation
/// behind a control command; anything else, a second operation included, is 0306H.
bool BlockCompiler::nothing_more() {
  const char c = parser_.peek();
  if (c == '\0') return true;
  const std::size_t next = parser_.position() + 1;
  const char behind = next < parser_.text().size() ? parser_.text()[next] : '\0';
  const bool is_word = is_upper(c) && (is_digit(behind) || behind == '.' || behind == '#' || behind == '[' ||
                                       behind == '-' || behind == '+');
  const bool operation = c == '#' && program_.statements.back().kind != StatementKind::assignment;
  if (is_word || operation) return parser_.fail("032CH");
  return parser_.fail("0306H", "An operation or control command stands alone in its block.");
}

bool BlockCompiler::condition_in_brackets(std::string_view detail, ExpressionRef& condition) {
  if (!parser_.take("[")) return parser_.fail(detail);
  const std::size_t first = parser_.begin_expression();
  if (!parser_.condition() ||
      !(parser_.take("]") || parser_.fail("0306H", "A closing bracket was expected here.")))
    return false;
  condition = since(first);
  return true;
}

bool BlockCompiler::if_statement() {
  ExpressionRef condition;
  if (!condition_in_brackets("0331H", condition)) return false;
  if (parser_.take("GOTO")) return go_to(condition);
  add(StatementKind::if_then).condition = condition;
  const StatementIndex start = last();
  if (parser_.take("THEN")) return then_part(start);
  controls_.push_back({ControlKind::if_operation, start, start, 0});
  return parser_.take("ELSE") ? else_statement() : parser_.fail("0331H");
}

bool BlockCompiler::then_part(StatementIndex start) {
  if (parser_.at_end()) {
    control(ControlKind::if_then);
    return true;
  }
  if (parser_.peek() != '#') return parser_.fail("032CH");
  if (!assignment()) return false;
  controls_.push_back({ControlKind::if_operation, start, last(), 0});
  return !parser_.take("ELSE") || else_statement();
}

bool BlockCompiler::else_statement() {
  add(StatementKind::else_part);
  const StatementIndex start = last();
  if (!parser_.at_end()) {
    if (parser_.peek() != '#') return parser_.fail("032CH");
    if (!assignment()) return false;
  }
  controls_.push_back({ControlKind::else_then, start, last(), 0});
  return true;
}

bool BlockCompiler::go_to(ExpressionRef condition) {
  if (parser_.peek() == 'N') return parser_.fail("0306H", "GOTO has the number alone behind it, without N.");
  const std::size_t first = parser_.begin_expression();
  if (!parser_.value()) return false;
  Statement& jump = add(StatementKind::go_to);
  jump.condition = condition;
  jump.value = since(first);
  return true;
}

bool BlockCompiler::while_statement() {
  ExpressionRef condition;
  if (!condition_in_brackets("0332H", condition)) return false;
  return parser_.take("DO") ? do_statement(condition) : parser_.fail("0332H");
}

bool BlockCompiler::loop_number(std::int32_t& number) {
  double value = 0.0;
  if (!is_digit(parser_.peek()) || !parser_.number(value)) return parser_.fail("0332H");
  number = value <= kHighestLoop ? static_cast<std::int32_t>(value) : 0;
  return (number >= 1 && value == number) || parser_.fail("0332H");
}

bool BlockCompiler::do_statement(ExpressionRef condition) {
  std::int32_t number = 0;
  if (!loop_number(number)) return false;
  add(StatementKind::while_do).condition = condition;
  control(ControlKind::loop, number);
  return true;
}

bool BlockCompiler::end_statement() {
  std::int32_t number = 0;
  if (!loop_number(number)) return false;
  add(StatementKind::end_do);
  control(ControlKind::end_loop, number);
  return true;
}

bool BlockCompiler::assignment() {
  parser_.take("#");
  const std::size_t target = parser_.begin_expression();
  if (!parser_.variable_number(true)) return false;
  const ExpressionRef number = since(target);
  if (!parser_.take("=")) return parser_.fail("032BH");
  const std::size_t value = parser_.begin_expression();
  if (!parser_.value()) return false;
  Statement& definition = add(StatementKind::assignment);
  definition.target = number;
  definition.value = since(value);
  return true;
}

bool BlockCompiler::words() {
  const std::size_t first = program_.words.size();
  while (!parser_.at_end()) {
    if (program_.words.size() - first == Block::kMaxWords) return parser_.fail("block-too-long");
    if (!word()) return false;
  }
  Statement& block = add(program_.words.size() == first ? StatementKind::nothing : StatementKind::words);
  block.first_word = static_cast<std::uint32_t>(first);
  block.word_count = static_cast<std::uint32_t>(program_.words.size() - first);
  return true;
}

bool BlockCompiler::word() {
  Word word;
  const std::size_t start = parser_.position();
  word.comma = parser_.take(",");
  const char c = parser_.peek();
  if (at_keyword()) {
    for (const std::string_view keyword : kKeywords) {
      if (parser_.take(keyword)) return parser_.fail("032CH");
    }
  }
  if (c == '#') return parser_.fail("032CH");
  if (is_lower(c) || (word.comma && c != 'F')) return parser_.fail("0305H");
  if (c == '(') return parser_.fail("0306H", "A comment has a line of its own.");
  if (c == '%') return parser_.fail("0306H", "A % stands alone in the first and in the last line.");
  if (c == '=' || is_digit(c)) return parser_.fail("0306H", "A letter was expected here.");
  if (!is_upper(c)) return parser_.fail("0305H", "This character begins no word.");
  if (c == 'N') return sequence_number();
  word.address = c;
  parser_.set_position(parser_.position() + 1);
  if (!word_value(word)) return false;
  word.column = span_.column + static_cast<std::uint32_t>(start);
  word.length = static_cast<std::uint32_t>(parser_.position() - start);
  if (word.address == 'O') {
    // The program number comes from the name of the file (decisions.md).
    if (!word.number.has_point) return true;
    parser_.set_position(start);
    return parser_.fail("031AH");
  }
  program_.words.push_back(word);
  return true;
}

bool BlockCompiler::word_value(Word& word) {
  const char c = parser_.peek();
  const std::size_t start = parser_.position();
  const std::string_view text = parser_.text();
  const bool is_signed = c == '-' || c == '+';
  const char* p = text.data() + start + (is_signed ? 1 : 0);
  while (is_signed && *p == ' ') ++p;
  if ((is_digit(*p) || *p == '.') && read_decimal(p, word.number)) {
    parser_.set_position(static_cast<std::size_t>(p - text.data()));
    if (!parser_.at_operator()) {
      if (c == '-') word.number.digits = -word.number.digits;
      return true;
    }
    parser_.set_position(start);
  }
  if (word.address == 'O') return parser_.fail("0306H", "O has a plain number behind it.");
  const std::size_t first = parser_.begin_expression();
  if (!parser_.value()) return false;
  // "X#101 = 5" would define a variable through an address.
  if (parser_.peek() == '=') return parser_.fail("0305H");
  word.expression = static_cast<std::int32_t>(program_.word_values.size());
  program_.word_values.push_back(since(first));
  return true;
}

}  // namespace kerf::melsec
