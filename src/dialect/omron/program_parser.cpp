#include "dialect/omron/program_parser.hpp"

#include <algorithm>
#include <charconv>

namespace kerf::omron {
namespace {

constexpr std::string_view kCommandMissing = "A command was expected here.";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

void ProgramParser::run(std::vector<ParseFault>& faults) {
  faults_ = &faults;
  for (;;) {
    scanner_.next_line_with_text();
    if (scanner_.at_text_end() || faults.size() >= kMostFaults) return;
    if (plain_lines()) continue;
    Command kind = Command::none;
    ends_program_ = false;
    if (!command(kind)) note_fault();
    if (ends_program_ && kind == Command::block) return;
  }
}

void ProgramParser::note_fault() {
  faults_->push_back(scanner_.fault());
  scanner_.forget_fault();
  resume();
}

/// Goes on behind a faulty line; a body that begins on it is left out with it, and a brace that closes the
/// body around it still does.
void ProgramParser::resume() {
  int open = 0;
  for (;;) {
    const char c = scanner_.peek();
    if (c == '\0') {
      if (open == 0 || scanner_.at_text_end()) return;
      scanner_.next_line_with_text();
      continue;
    }
    if (c == '}' && open == 0) return;
    open += c == '{' ? 1 : c == '}' ? -1 : 0;
    scanner_.skip();
    if (c == '}' && open == 0) return;
  }
}

bool ProgramParser::fail(std::string_view detail, std::string_view message) {
  return scanner_.fail(detail, message);
}

StatementIndex ProgramParser::add(StatementKind kind) {
  Statement& statement = program_.statements.emplace_back();
  statement.kind = kind;
  statement.span = block_;
  statement.sequence_number = static_cast<std::int32_t>(block_.line);
  statement.first_of_block = first_of_block_;
  first_of_block_ = false;
  return here() - 1;
}

StatementIndex ProgramParser::jump_unless(const ExpressionRef& condition) {
  const StatementIndex jump = add(StatementKind::branch);
  program_.statements[jump].condition = condition;
  return jump;
}

bool ProgramParser::add_code(std::string line) {
  return code_.add_line(std::move(line)) || scanner_.fail("block-length", {}, block_);
}

bool ProgramParser::command(Command& kind) {
  scanner_.next_line_with_text();
  if (scanner_.at_text_end()) return fail("syntax", kCommandMissing);
  start_ = scanner_.position();
  first_of_block_ = true;
  block_ = scanner_.span_here();
  int skip = 0;
  if (scanner_.peek() == '/' && !skip_number(skip)) return false;
  const SourceSpan skip_span = scanner_.span_from(start_);
  if (scanner_.peek() == 'N' && !block_number()) return false;
  bool found = false;
  if (!program_code(found)) return false;
  if (found && skip > 0)
    return scanner_.fail("block-skip", "Only blocks of words can be skipped, not program codes.", skip_span);
  kind = found ? Command::program_code : Command::block;
  return found || words(skip);
}

bool ProgramParser::program_code(bool& found) {
  found = true;
  if (scanner_.peek() == '{') return braces();
  if (scanner_.peek() == '}') {
    scanner_.skip();
    return scanner_.fail("syntax", "This brace closes nothing.", block_);
  }
  if (scanner_.name().empty()) {  // most blocks
    found = at_assignment();
    return !found || assignments();
  }
  if (scanner_.take_keyword("if")) return if_statement();
  if (scanner_.take_keyword("while")) return while_statement();
  if (scanner_.take_keyword("do")) return do_statement();
  if (scanner_.take_keyword("switch")) return switch_statement();
  if (scanner_.take_keyword("break")) return break_statement();
  for (const std::string_view stray : {"else", "case", "default"}) {
    if (scanner_.name() == stray)
      return fail("syntax", stray == "else" ? "There is no if in front of this else."
                                            : "A case and a default stand directly inside of a switch.");
  }
  found = false;  // ta, td or ts
  return true;
}

bool ProgramParser::braces() {
  if (depth_ >= kDeepest) return fail("nesting", "The braces are nested too deeply.");
  ++depth_;
  scanner_.skip();
  std::size_t count = 0;
  Command last = Command::none;
  const bool read = commands_to_brace(count, last);
  --depth_;
  return read;
}

bool ProgramParser::skip_number(int& skip) {
  constexpr int kMostSkips = 31;
  scanner_.skip();
  while (is_digit(scanner_.at()) && skip < 1000) {
    skip = skip * 10 + (scanner_.at() - '0');
    scanner_.skip();
  }
  return (skip >= 1 && skip <= kMostSkips) || scanner_.fail("block-skip", {}, scanner_.span_from(start_));
}

bool ProgramParser::block_number() {
  const std::size_t from = scanner_.position();
  scanner_.skip();
  if (!is_digit(scanner_.at()))
    return scanner_.fail("syntax", "A number of digits belongs behind N.", scanner_.span_from(from));
  while (is_digit(scanner_.at())) scanner_.skip();
  return true;
}

/// A block number may also stand in front of what belongs to a statement that began before.
void ProgramParser::pass_number_before(std::initializer_list<std::string_view> texts) {
  if (scanner_.peek() != 'N') return;
  Scanner ahead = scanner_;
  ahead.skip();
  if (!is_digit(ahead.at())) return;
  while (is_digit(ahead.at())) ahead.skip();
  const char next = ahead.peek();
  for (const std::string_view text : texts) {
    if (ahead.name() == text || (text.size() == 1 && next == text[0])) scanner_ = ahead;
  }
}

// ---- control statements

bool ProgramParser::condition(std::string_view keyword, ExpressionRef& ref) {
  if (!scanner_.take('(')) return fail("syntax", "The condition stands in parentheses.");
  if (!expressions_.condition(ref)) return false;
  if (!scanner_.take(')')) return fail("syntax", "A closing parenthesis was expected here.");
  block_ = scanner_.span_from(start_);
  return add_code(std::string(keyword) + "(" + expressions_.text() + ")");
}

bool ProgramParser::body() {
  if (depth_ >= kDeepest) return fail("nesting", "The control statements are nested too deeply.");
  ++depth_;
  scanner_.next_line_with_text();
  const std::size_t first = code_.size();
  Command last = Command::none;
  std::size_t count = 1;
  const bool braces = scanner_.take('{');
  const bool read = braces ? commands_to_brace(count, last) : command(last);
  // A block may give two lines of code: M99 and its return.
  const bool one_line = count == 1 && last == Command::block && code_.size() == first + 1;
  if (!one_line && (braces || last == Command::block)) code_.enclose(first);
  --depth_;
  return read;
}

bool ProgramParser::commands_to_brace(std::size_t& count, Command& last) {
  const SourceSpan open = block_;
  count = 0;
  for (;;) {
    scanner_.next_line_with_text();
    if (scanner_.at_text_end())
      return scanner_.fail("syntax", "The brace that is opened here is never closed.", open);
    pass_number_before({"}"});
    if (scanner_.take('}')) return true;
    if (faults_->size() >= kMostFaults) return fail("syntax", {});
    if (!plain_lines() && !command(last)) note_fault();
    ++count;
  }
}

bool ProgramParser::if_statement() {
  ExpressionRef holds;
  if (!condition("if", holds)) return false;
  const StatementIndex skipped = jump_unless(holds);
  if (!body()) return false;
  const Scanner behind = scanner_;
  scanner_.next_line_with_text();
  pass_number_before({"else"});
  start_ = scanner_.position();
  if (!scanner_.take_keyword("else")) {
    scanner_ = behind;
    set_target(skipped);
    return true;
  }
  first_of_block_ = false;
  const StatementIndex end = add(StatementKind::branch);
  set_target(skipped);
  block_ = scanner_.span_from(start_);
  if (!add_code("else") || !body()) return false;
  set_target(end);
  return true;
}

bool ProgramParser::while_statement() {
  ExpressionRef holds;
  if (!condition("while", holds)) return false;
  const StatementIndex top = jump_unless(holds);
  breaks_.emplace_back();
  const bool read = body();
  if (read) {
    first_of_block_ = false;
    program_.statements[add(StatementKind::branch)].jump = top;
    set_target(top);
  }
  leave_breakable();
  return read;
}

bool ProgramParser::do_statement() {
  block_ = scanner_.span_from(start_);
  if (!add_code("do")) return false;
  const StatementIndex top = here();
  breaks_.emplace_back();
  bool read = body();
  if (read) {
    scanner_.next_line_with_text();
    pass_number_before({"while"});
    start_ = scanner_.position();
    first_of_block_ = true;
    ExpressionRef holds;
    read =
        (scanner_.take_keyword("while") || fail("syntax", "A while was expected behind the body of do.")) &&
        condition("while", holds);
    if (read) {
      program_.steps.push_back({ExpressionOp::negation});
      ++holds.count;
      program_.statements[jump_unless(holds)].jump = top;
    }
  }
  leave_breakable();
  return read;
}

void ProgramParser::leave_breakable() {
  for (const StatementIndex jump : breaks_.back()) set_target(jump);
  breaks_.pop_back();
}

bool ProgramParser::break_statement() {
  block_ = scanner_.span_from(start_);
  if (breaks_.empty())
    return scanner_.fail("syntax", "There is no loop and no switch around this break.", block_);
  breaks_.back().push_back(add(StatementKind::branch));
  return add_code("break");
}

bool ProgramParser::switch_statement() {
  ExpressionRef value;
  if (!scanner_.take('(')) return fail("syntax", "The expression stands in parentheses.");
  if (!expressions_.number(value)) return false;
  if (!scanner_.take(')')) return fail("syntax", "A closing parenthesis was expected here.");
  block_ = scanner_.span_from(start_);
  if (!add_code("switch(" + expressions_.text() + ")") || !add_code("{")) return false;
  const SourceSpan head = block_;
  scanner_.next_line_with_text();
  pass_number_before({"{"});
  if (depth_ >= kDeepest) return fail("nesting", "The control statements are nested too deeply.");
  if (!scanner_.take('{')) return fail("syntax", "The cases of a switch stand in braces.");
  const StatementIndex to_dispatch = add(StatementKind::branch);
  breaks_.emplace_back();
  std::vector<Case> cases;
  ++depth_;
  const bool read = switch_body(head, cases) && add_code("}");
  --depth_;
  if (read) {
    block_ = head;
    first_of_block_ = false;
    breaks_.back().push_back(add(StatementKind::branch));
    set_target(to_dispatch);
    dispatch(value, cases);
  }
  leave_breakable();
  return read;
}

bool ProgramParser::switch_body(const SourceSpan& head, std::vector<Case>& cases) {
  for (;;) {
    scanner_.next_line_with_text();
    if (scanner_.at_text_end()) return scanner_.fail("syntax", "This switch is never closed.", head);
    pass_number_before({"}", "case", "default"});
    if (scanner_.take('}')) return true;
    if (faults_->size() >= kMostFaults) return fail("syntax", {});
    const bool label = scanner_.name() == "case" || scanner_.name() == "default";
    if (!label && cases.empty()) return fail("syntax", "A case or default was expected here.");
    Command kind = Command::none;
    if (!(label ? case_label(cases) : command(kind))) note_fault();
  }
}

bool ProgramParser::case_label(std::vector<Case>& cases) {
  start_ = scanner_.position();
  Case found;
  found.body = here();
  found.is_default = scanner_.take_keyword("default");
  if (!found.is_default) {
    scanner_.take_keyword("case");
    scanner_.peek();
    const std::size_t from = scanner_.position();
    if (scanner_.at() == '-') scanner_.skip();
    while (is_digit(scanner_.at())) scanner_.skip();
    const std::string_view digits = scanner_.since(from);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), found.value);
    if (error != std::errc() || scanner_.at() == '.')
      return scanner_.fail("syntax", "A case has an integer.", scanner_.span_from(from));
  }
  if (!scanner_.take(':')) return fail("syntax", "A colon was expected here.");
  block_ = scanner_.span_from(start_);
  const auto same = [&](const Case& other) {
    return other.is_default == found.is_default && other.value == found.value;
  };
  if (std::any_of(cases.begin(), cases.end(), same))
    return scanner_.fail("syntax", "The switch has this case already.", block_);
  cases.push_back(found);
  return add_code(found.is_default ? "default:" : "case " + std::to_string(found.value) + ":");
}

/// The way from the head of a switch to its cases: one comparison after the other.
void ProgramParser::dispatch(const ExpressionRef& value, const std::vector<Case>& cases) {
  std::optional<StatementIndex> otherwise;
  for (const Case& one : cases) {
    if (one.is_default) {
      otherwise = one.body;
      continue;
    }
    ExpressionRef differs{static_cast<std::uint32_t>(program_.steps.size()), value.count + 3};
    for (std::uint32_t i = 0; i < value.count; ++i) {
      const ExpressionStep step = program_.steps[value.begin + i];
      program_.steps.push_back(step);
    }
    program_.steps.push_back({ExpressionOp::truncate});
    program_.steps.push_back({ExpressionOp::constant, static_cast<double>(one.value)});
    program_.steps.push_back({ExpressionOp::not_equal});
    program_.statements[jump_unless(differs)].jump = one.body;
  }
  if (otherwise) program_.statements[add(StatementKind::branch)].jump = *otherwise;
}

}  // namespace kerf::omron
