#include "conformance/runner/case_parser.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include "conformance/runner/entry.hpp"
#include "conformance/runner/foreach.hpp"

namespace kerf::conformance {
namespace {

constexpr std::string_view kTitleMark = "===";
constexpr std::string_view kSectionMark = "---";

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool is_ignored(std::string_view text) {
  return trimmed(text).empty() || text[0] == '#';
}

/// `#100=6`, the value of a macro variable.
bool is_variable(std::string_view text) {
  return text.size() > 1 && text[0] == '#' && text[1] >= '0' && text[1] <= '9';
}

/// `sub O002`: the number of a further program; 0: it is none.
std::int32_t program_of(std::string_view section) {
  constexpr std::string_view kSub = "sub ";
  if (!starts_with(section, kSub)) return 0;
  section.remove_prefix(kSub.size());
  if (starts_with(section, "O")) section.remove_prefix(1);
  return static_cast<std::int32_t>(number_of(section).value_or(0.0));
}

/// The first `$name` of a text; empty: none.
std::string unknown_name(std::string_view text) {
  for (std::size_t at = text.find('$'); at != std::string_view::npos; at = text.find('$', at + 1)) {
    const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", at + 1);
    const std::size_t length = (end == std::string_view::npos ? text.size() : end) - at;
    if (length > 1) return std::string(text.substr(at, length));
  }
  return {};
}

struct Header {
  std::string_view word;
  std::string_view value;
};

std::optional<Header> header_of(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  return Header{trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1))};
}

/// Reads the lines of one alternative of one case.
class CaseParser {
 public:
  CaseParser(const std::string& file, const std::vector<TextLine>& lines, Replacements replacements,
             const ProgramFrame& frame)
      : lines_(lines), replacements_(std::move(replacements)), frame_(frame) {
    case_.file = file;
    case_.alternative = replacements_text(replacements_);
    case_.watched = default_watch();
  }

  void parse() {
    case_.line = lines_.front().number;
    case_.title = trimmed(std::string_view(lines_.front().text).substr(kTitleMark.size()));
    if (case_.title.empty()) fail(case_.line, "a case needs a title behind ===");
    for (auto line = std::next(lines_.begin()); line != lines_.end(); ++line) {
      const std::string text = replaced(line->text, replacements_);
      if (const std::string name = unknown_name(text); !name.empty()) {
        fail(line->number, fmt::format("no foreach names '{}'", name));
      }
      if (starts_with(text, kSectionMark))
        open_section(trimmed(std::string_view(text).substr(3)), line->number);
      else
        take(text, line->number);
    }
    close_program();
    check();
  }

  const Case& result() const { return case_; }
  const std::vector<FileError>& errors() const { return errors_; }

 private:
  enum class Section : std::uint8_t { header, program, body, sub, expect, after };

  void fail(std::uint32_t line, std::string message) {
    errors_.push_back({case_.file, line, std::move(message)});
  }

  void open_section(std::string_view name, std::uint32_t line) {
    if (name == "program" || name == "body") {
      close_program();
      section_ = name == "body" ? Section::body : Section::program;
      is_body_ = name == "body";
      expects_ = false;
      ProgramSection& program = case_.programs.emplace_back();
      program.line = line;
      if (is_body_) program.text = frame_.head;
      return;
    }
    if (const std::int32_t number = program_of(name); number > 0 && !case_.programs.empty()) {
      section_ = Section::sub;
      sub_ = &case_.programs.back().others[number];
      *sub_ = frame_.head;
      return;
    }
    if (name != "expect" && name != "after") return fail(line, fmt::format("unknown section '{}'", name));
    if (case_.programs.empty()) return fail(line, fmt::format("'--- {}' stands before any program", name));
    section_ = name == "expect" ? Section::expect : Section::after;
    expects_ = expects_ || section_ == Section::expect;
  }

  void close_program() {
    if (case_.programs.empty()) return;
    ProgramSection& program = case_.programs.back();
    if (is_body_) program.text += frame_.tail;
    for (auto& [number, text] : program.others) text += frame_.sub_tail;
    const bool can_fail =
        !program.expected.empty() || !program.facts.empty() || case_.watched != default_watch();
    if (!expects_ || !can_fail) fail(program.line, "the program has no expectation");
  }

  void take(const std::string& text, std::uint32_t line) {
    switch (section_) {
      case Section::program:
      case Section::body:
        case_.programs.back().text += text + "\n";
        break;
      case Section::sub:
        *sub_ += text + "\n";
        break;
      case Section::header:
        if (!is_ignored(text)) take_header(text, line);
        break;
      case Section::expect:
      case Section::after:
        if (!is_ignored(text) || is_variable(text)) take_entry(text, line);
        break;
    }
  }

  void take_entry(std::string_view text, std::uint32_t line) {
    const auto entry = parse_entry(text, line);
    if (!entry) return fail(line, entry.error());
    const bool event = section_ == Section::expect;
    if (std::string wrong = event ? event_fault(*entry) : fact_fault(*entry); !wrong.empty()) {
      return fail(line, std::move(wrong));
    }
    if (event && entry->name != "refused" && case_.watched.count(watch_kind(entry->name)) == 0) {
      return fail(line, fmt::format("'{}' is not watched", entry->name));
    }
    ProgramSection& program = case_.programs.back();
    (event ? program.expected : program.facts).push_back(*entry);
  }

  void take_header(std::string_view text, std::uint32_t line) {
    const auto header = header_of(text);
    if (!header) return fail(line, fmt::format("'{}' is no header line", trimmed(text)));
    const auto [word, value] = *header;
    if (value.empty()) return fail(line, fmt::format("'{}' has no value", word));
    if (word == "ids") {
      for (std::string& id : words_of(value)) case_.ids.push_back(std::move(id));
    } else if (word == "set") {
      case_.settings.emplace_back(value);
    } else if (word == "watch") {
      take_watch(value, line);
    } else if (word == "options") {
      take_options(value, line);
    } else if (word == "during") {
      take_change(value, line);
    } else if (word == "eol") {
      if (value != "lf" && value != "crlf" && value != "cr") fail(line, "eol is lf, crlf or cr");
      case_.line_end = value == "cr" ? LineEnd::cr : value == "crlf" ? LineEnd::crlf : LineEnd::lf;
    } else if (word == "ideal" || word == "recover") {
      if (value != "yes") fail(line, fmt::format("{} can only be yes", word));
      (word == "ideal" ? case_.ideal : case_.recover) = true;
    } else if (word == "tol") {
      const auto number = number_of(value);
      if (!number || *number <= 0.0) fail(line, "tol needs a positive number");
      case_.tolerance = number.value_or(case_.tolerance);
    } else if (word != "foreach") {
      fail(line, fmt::format("unknown header '{}'", word));
    }
  }

  void take_watch(std::string_view value, std::uint32_t line) {
    case_.watched.clear();
    for (const std::string& kind : words_of(value)) {
      if (!is_watch_kind(kind)) fail(line, fmt::format("'{}' cannot be watched", kind));
      case_.watched.insert(kind);
    }
  }

  void take_options(std::string_view value, std::uint32_t line) {
    for (const std::string& option : words_of(value)) {
      if (option == "optional-stop")
        case_.optional_stop = true;
      else if (option == "block-skip")
        case_.block_skip = true;
      else
        fail(line, fmt::format("unknown option '{}'", option));
    }
  }

  void take_change(std::string_view value, std::uint32_t line) {
    const auto entry = parse_entry(value, line);
    OverrideChange change;
    bool timed = false;
    if (!entry || !entry->words.empty()) return fail(line, "during: t=SECONDS feed_override=PERCENT");
    for (const Field& field : entry->fields) {
      const double* number = std::get_if<double>(&field.value);
      if (number == nullptr) return fail(line, fmt::format("'{}' needs a number", field.key));
      if (field.key == "t")
        change.time_s = *number;
      else if (field.key == "feed_override")
        change.feed_percent = *number;
      else if (field.key == "rapid_override")
        change.rapid_percent = *number;
      else
        return fail(line, fmt::format("during has no '{}'", field.key));
      timed = timed || field.key == "t";
    }
    if (!timed || (!change.feed_percent && !change.rapid_percent)) {
      return fail(line, "during: t=SECONDS feed_override=PERCENT");
    }
    case_.changes.push_back(change);
  }

  void check() {
    if (case_.ids.empty()) fail(case_.line, "the case proves nothing: no ids");
    if (case_.programs.empty()) fail(case_.line, "the case has no program");
    for (const Entry& fact : case_.programs.empty() ? std::vector<Entry>() : case_.programs.front().facts) {
      if (fact.name == "same") fail(fact.line, "'same' needs a program before this one");
    }
  }

  const std::vector<TextLine>& lines_;
  Replacements replacements_;
  const ProgramFrame& frame_;
  Case case_;
  std::vector<FileError> errors_;
  Section section_ = Section::header;
  std::string* sub_ = nullptr;  ///< text of the `sub` section being read
  bool is_body_ = false;
  bool expects_ = false;
};

/// The `foreach` lines of a case's header, with all combinations of their alternatives.
std::vector<Replacements> alternatives_of(const std::string& file, const std::vector<TextLine>& lines,
                                          std::vector<FileError>& errors) {
  std::vector<std::vector<Replacements>> lists;
  for (const TextLine& line : lines) {
    if (starts_with(line.text, kSectionMark)) break;
    const auto header = header_of(line.text);
    if (line.text.empty() || line.text[0] == '#' || !header || header->word != "foreach") continue;
    auto list = parse_foreach(header->value);
    if (list)
      lists.push_back(*std::move(list));
    else
      errors.push_back({file, line.number, list.error()});
  }
  return combinations(lists);
}

/// Whether a line outside the `foreach` headers holds the name.
bool is_used(const std::string& name, const Replacements& replacements, const std::vector<TextLine>& lines) {
  Replacements marked = replacements;
  for (auto& [other, value] : marked) value = other == name ? std::string(1, '\0') : std::string();
  return std::any_of(lines.begin(), lines.end(), [&](const TextLine& line) {
    const bool is_list = starts_with(line.text, "foreach");
    return !is_list && replaced(line.text, marked).find('\0') != std::string::npos;
  });
}

/// A header line that begins with | goes on with the one before.
void join_continued(std::vector<TextLine>& lines) {
  std::vector<TextLine> joined;
  bool header = true;
  for (TextLine& line : lines) {
    header = header && !starts_with(line.text, kSectionMark);
    if (header && joined.size() > 1 && line.text[0] == '|')
      joined.back().text += " " + line.text;
    else
      joined.push_back(std::move(line));
  }
  lines = std::move(joined);
}

void parse_case(const std::string& file, std::vector<TextLine>& lines, const ProgramFrame& frame,
                CaseFile& result) {
  if (lines.empty()) return;
  join_continued(lines);
  const std::size_t errors_before = result.errors.size();
  const std::vector<Replacements> alternatives = alternatives_of(file, lines, result.errors);
  for (const auto& [name, value] : alternatives.front()) {
    if (!is_used(name, alternatives.front(), lines)) {
      result.errors.push_back({file, lines.front().number, fmt::format("nothing uses '{}'", name)});
    }
  }
  if (result.errors.size() != errors_before) return;
  for (const Replacements& replacements : alternatives) {
    CaseParser parser(file, lines, replacements, frame);
    parser.parse();
    if (parser.errors().empty()) {
      result.cases.push_back(parser.result());
      continue;
    }
    // The other alternatives would most likely repeat the same errors.
    result.errors.insert(result.errors.end(), parser.errors().begin(), parser.errors().end());
    return;
  }
}

}  // namespace

CaseFile parse_cases(const std::string& file, std::string_view text, const ProgramFrame& frame) {
  CaseFile result;
  std::vector<TextLine> lines;
  for (TextLine& line : lines_of(text)) {
    if (starts_with(line.text, kTitleMark)) {
      parse_case(file, lines, frame, result);
      lines.clear();
    } else if (lines.empty()) {
      if (!is_ignored(line.text)) result.errors.push_back({file, line.number, "text before the first ==="});
      continue;
    }
    lines.push_back(std::move(line));
  }
  parse_case(file, lines, frame, result);
  if (result.cases.empty() && result.errors.empty())
    result.errors.push_back({file, 0, "the file has no case"});
  return result;
}

}  // namespace kerf::conformance
