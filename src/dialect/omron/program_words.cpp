// Assignments and blocks of words.

#include <algorithm>
#include <charconv>

#include "dialect/omron/addresses.hpp"
#include "dialect/omron/program_parser.hpp"

namespace kerf::omron {
namespace {

constexpr LetterSet kLetters("ABCFGIJKLMPRSXYZ");
constexpr LetterSet kPlainLetters("ABCFGIJKLPRSXYZ");  // a block with M may end the program

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

double number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

// ---- assignments

/// L, Q or P with a number and one = behind it, or a forbidden form of that.
bool ProgramParser::at_assignment() {
  const char bank = scanner_.peek();
  if (bank != 'L' && bank != 'Q' && bank != 'P') return false;
  Scanner ahead = scanner_;
  ahead.skip();
  while (is_digit(ahead.at())) ahead.skip();
  if (ahead.at() == '[') {
    while (ahead.at() != '\0' && ahead.at() != ']') ahead.skip();
    ahead.take(']');
  }
  if (ahead.peek() != '=') return false;
  ahead.skip();
  return ahead.at() != '=';
}

bool ProgramParser::assignments() {
  std::string line;
  std::vector<StatementIndex> added;
  while (at_assignment()) {
    ExpressionRef target;
    ExpressionRef value;
    const std::size_t from = scanner_.position();
    if (!expressions_.variable(target)) return false;
    if (!line.empty()) line += ' ';
    line += scanner_.since(from);
    scanner_.take('=');
    if (!expressions_.number(value)) return false;
    line += "=" + expressions_.text();
    // The target is the number of the variable, not its value.
    program_.steps[target.begin].op = ExpressionOp::constant;
    added.push_back(add(StatementKind::assignment));
    program_.statements.back().target = target;
    program_.statements.back().value = value;
  }
  block_ = scanner_.span_from(start_);
  for (const StatementIndex index : added) program_.statements[index].span = block_;
  if (!at_end_of_command())
    return fail("syntax", "An assignment ends here; other words have a block of their own.");
  return add_code(std::move(line));
}

bool ProgramParser::at_end_of_command() {
  if (scanner_.at_line_end() || scanner_.peek() == '}') return true;
  const std::string_view name = scanner_.name();
  return name == "else" || name == "while";
}

// ---- words

/// Takes the lines of plain words that come next as one statement, when they are many. Not for intermediate
/// code, which has every word.
bool ProgramParser::plain_lines() {
  constexpr int kMany = 16;
  constexpr std::size_t kLongest = std::size_t{1} << 31;  // bytes, so that a span can hold it
  if (code_.keeps_text() || scanner_.position() < few_until_) return false;
  LinePlace place = scanner_.place();
  LinePlace behind = place;
  int lines = 0;
  bool has_words = false;
  while (place.at < scanner_.text().size() && place.at - scanner_.position() < kLongest &&
         pass_plain_line(place, scanner_.text(), kPlainLetters, has_words)) {
    if (!has_words) continue;
    ++lines;
    behind = place;
  }
  few_until_ = place.at;
  if (lines < kMany) return false;
  first_of_block_ = true;
  block_ = scanner_.span_here(behind.at - scanner_.position());
  program_.plain_letters = kPlainLetters;
  add(StatementKind::lines);
  scanner_.go_to(behind);
  return true;
}

bool ProgramParser::words(int skip) {
  const StatementIndex index = add(StatementKind::words);
  const auto first = static_cast<std::uint32_t>(program_.words.size());
  code_.begin_block(block_.line, skip);
  while (!at_end_of_command()) {
    if (!word()) return false;
    if (program_.words.size() - first > Block::kMaxWords) return scanner_.fail("block-length", {}, block_);
    block_ = scanner_.span_from(start_);
  }
  Statement& statement = program_.statements[index];
  statement.span = block_;
  statement.first_word = first;
  statement.word_count = static_cast<std::uint32_t>(program_.words.size()) - first;
  statement.skip_number = static_cast<std::uint8_t>(skip);
  const auto ends = [](const Word& word) {
    return word.address == 'M' && (word.computed == 2.0 || word.computed == 30.0);
  };
  ends_program_ =
      skip == 0 && std::any_of(program_.words.end() - statement.word_count, program_.words.end(), ends);
  return code_.end_block() || scanner_.fail("block-length", {}, block_);
}

bool ProgramParser::address(char& address, std::string_view& text) {
  const char c = scanner_.peek();
  const std::size_t from = scanner_.position();
  const char second = scanner_.at(1);
  if (c == 't' && (second == 'a' || second == 'd' || second == 's')) {
    scanner_.skip(2);
    address = second;
  } else if (c == 'V' && second >= 'A' && second <= 'H') {
    scanner_.skip(2);
    address = kArguments[static_cast<std::size_t>(second - 'A')];
  } else if (kLetters.contains(c)) {
    scanner_.skip();
    address = c;
  } else if (c == 'N') {
    return fail("syntax", "N may only be the first word of a block.");
  } else if (c == '/') {
    return fail("block-skip", "The slash of a block skip stands in front of the block, before N.");
  } else {
    return fail("unknown-word");
  }
  text = scanner_.since(from);
  return true;
}

bool ProgramParser::word() {
  Word word;
  IntermediateCode::Word text;
  const SourceSpan place = (scanner_.peek(), scanner_.span_here());
  const std::size_t from = scanner_.position();
  if (!address(word.address, text.address)) return false;
  word.is_computed = true;
  const bool read = scanner_.at() == '[' ? indirect_value(word, text) : word_value(word, text);
  if (!read) return false;
  word.column = place.column;
  word.length = static_cast<std::uint32_t>(scanner_.position() - from);
  program_.words.push_back(word);
  code_.add_word(text);
  return true;
}

bool ProgramParser::word_value(Word& word, IntermediateCode::Word& text) {
  const std::size_t from = scanner_.position();
  if (scanner_.at() == '-' || scanner_.at() == '+') scanner_.skip();
  bool any = false;
  while (is_digit(scanner_.at())) any = true, scanner_.skip();
  if (scanner_.at() == '.') scanner_.skip();
  while (is_digit(scanner_.at())) any = true, scanner_.skip();
  if (!any) {
    const bool equals = scanner_.at() == '=';
    return scanner_.fail("syntax",
                         equals ? "Only variables L, Q and P can be assigned to."
                                : "A number belongs directly behind the letter of a word.",
                         scanner_.span_here());
  }
  text.value = scanner_.since(from);
  word.computed = number_of(text.value);
  return true;
}

bool ProgramParser::indirect_value(Word& word, IntermediateCode::Word& text) {
  if (word.address == 'G' || word.address == 'M')
    return scanner_.fail("indirection", "The number of a code cannot come from a variable.",
                         scanner_.span_here());
  scanner_.skip();
  scanner_.peek();
  const std::size_t from = scanner_.position();
  ExpressionRef value;
  if (!expressions_.variable(value)) return false;
  text.value = scanner_.since(from);
  text.is_variable = true;
  if (!scanner_.take(']'))
    return fail("indirection", "Only the name of a variable can stand in the brackets of a word.");
  word.expression = static_cast<std::int32_t>(program_.word_values.size());
  program_.word_values.push_back(value);
  return true;
}

}  // namespace kerf::omron
