#include "dialect/melsec/compile.hpp"

#include <algorithm>
#include <optional>

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/block_compiler.hpp"

namespace kerf::melsec {
namespace {

/// One line of the text without its end.
struct Line {
  std::string_view text;
  std::uint64_t offset = 0;
  std::uint32_t number = 0;  ///< from 1
};

class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  std::optional<Line> next() {
    if (at_ >= text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    const Line found{line, at_, ++number_};
    at_ = end + 1;
    return found;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t number_ = 0;
};

bool may_start_block(char c) {
  // Lower case is refused when the block is executed.
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '#' || c == '[' || c == '(';
}

class FileCompiler {
 public:
  FileCompiler(CompiledProgram& program, std::string_view text) : program_(program), lines_(text) {
    if (text.size() > kLargestProgram) refuse("0041H", {0, 1, 1, 1});
  }

  void run() {
    auto line = lines_.next();
    while (line && line->text.empty()) line = lines_.next();
    if (!line || !line->text.starts_with('%')) refuse("0042H", {0, 1, 1, 1});
    const bool closed = read_blocks();
    if (!closed) refuse("0042H", end_);
    if (load_fault_) {
      controls_.clear();
      program_.refuse(*load_fault_);
      return;
    }
    pair_controls(program_, controls_);
    const auto by_number = [](const SequenceLabel& a, const SequenceLabel& b) { return a.number < b.number; };
    std::stable_sort(program_.labels.begin(), program_.labels.end(), by_number);
  }

 private:
  /// False: the text ended without the closing %.
  bool read_blocks() {
    BlockCompiler blocks(program_, controls_);
    while (const auto line = lines_.next()) {
      if (line->text.starts_with('%')) return true;
      read_block(*line, blocks);
    }
    return false;
  }

  void read_block(const Line& line, BlockCompiler& blocks) {
    const std::size_t start = std::min(line.text.find_first_not_of(" \t"), line.text.size());
    const std::string_view block = line.text.substr(start);
    const SourceSpan span{line.offset + start, line.number, static_cast<std::uint32_t>(start + 1),
                          static_cast<std::uint32_t>(block.size())};
    if (block.empty()) return;
    end_ = span;
    if (block.front() == '(') return;
    if (!may_start_block(block.front())) return refuse("0042H", {span.offset, span.line, span.column, 1});
    blocks.compile(block, span);
  }

  /// The controller does not load the file; the first reason counts.
  void refuse(std::string_view detail, const SourceSpan& span) {
    if (!load_fault_) load_fault_ = StatementFault{&alarm_kind(detail), span};
  }

  CompiledProgram& program_;
  Lines lines_;
  std::vector<Control> controls_;
  std::optional<StatementFault> load_fault_;
  SourceSpan end_{0, 1, 1, 1};  ///< the last block read that is not empty
};

}  // namespace

std::optional<std::int32_t> stored_number(std::string_view file_name) {
  constexpr std::int32_t kHighest = 256;
  const std::size_t slash = file_name.rfind('/');
  if (slash != std::string_view::npos) file_name.remove_prefix(slash + 1);
  if (file_name.size() != 8 || file_name[0] != 'O' || !file_name.ends_with(".gcd")) return std::nullopt;
  std::int32_t number = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (file_name[i] < '0' || file_name[i] > '9') return std::nullopt;
    number = number * 10 + (file_name[i] - '0');
  }
  return number >= 1 && number <= kHighest ? std::optional(number) : std::nullopt;
}

std::shared_ptr<const CompiledProgram> compile(std::shared_ptr<const Source> source, std::int32_t number) {
  auto program = std::make_shared<CompiledProgram>();
  const std::string_view text = source->text();
  program->source = std::move(source);
  program->number = number;
  FileCompiler(*program, text).run();
  return program;
}

std::shared_ptr<const CompiledProgram> refused_program(std::shared_ptr<const Source> source,
                                                       std::int32_t number, std::string_view detail) {
  auto program = std::make_shared<CompiledProgram>();
  program->source = std::move(source);
  program->number = number;
  program->refuse({&alarm_kind(detail), {0, 1, 1, 1}});
  return program;
}

bool is_subprogram(const std::shared_ptr<const Source>& source) {
  const auto program = compile(source, 0);
  bool returns = false;
  for (const Statement& statement : program->statements) {
    for (std::uint32_t i = 0; i < statement.word_count; ++i) {
      const Word& word = program->words[statement.first_word + i];
      if (word.expression >= 0 || word.number.has_point) continue;
      if (word.address == 'G' && word.number.digits == 65) break;  // the rest are arguments
      if (word.address != 'M') continue;
      if (word.number.digits == 2 || word.number.digits == 30) return false;
      returns = returns || word.number.digits == 99;
    }
  }
  return returns;
}

}  // namespace kerf::melsec
