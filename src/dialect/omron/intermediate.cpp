#include "dialect/omron/intermediate.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace kerf::omron {
namespace {

constexpr std::string_view kEndOfBlock = "M999.002";
constexpr std::string_view kCycleStarts = "G80.001";
constexpr std::int32_t kFirstSubprogram = 1000;

/// The number of a code, however it is written: 84, 084, 84.0; -1 for one with a fraction.
int code_of(std::string_view value) {
  constexpr double kHighest = 1000.0;
  double code = -1.0;
  std::from_chars(value.data(), value.data() + value.size(), code);
  return code >= 0.0 && code < kHighest && code == std::trunc(code) ? static_cast<int>(code) : -1;
}

}  // namespace

void IntermediateCode::begin_block(std::uint32_t line, int skip) {
  words_.clear();
  head_ = skip > 0 ? "cskip" + std::to_string(skip) + " " : std::string();
  skip_ = head_;
  head_ += "N" + std::to_string(line);
  length_ = head_.size();
  cycle_starts_ = names_cycle_ = positions_ = returns_ = false;
}

void IntermediateCode::append(std::string_view word) {
  length_ += 1 + word.size();
  if (keeps_text_) words_.emplace_back(word);
}

void IntermediateCode::add_word(const Word& word) {
  std::string_view address = word.address;
  if (address.size() == 2 && address.front() == 'V') address.remove_prefix(1);  // an argument of an M code
  const bool started = cycle_starts_;
  note_cycle(word.address, word.value);
  if (address == "M" && code_of(word.value) == 99) returns_ = true;
  if (cycle_starts_ && !started) append(kCycleStarts);
  if (!keeps_text_) {
    length_ += 1 + address.size() + word.value.size() + (word.is_variable ? 2 : 0);
    return;
  }
  std::string text(address);
  text += word.is_variable ? "(" + std::string(word.value) + ")" : std::string(word.value);
  append(text);
}

void IntermediateCode::note_cycle(std::string_view address, std::string_view value) {
  const char letter = address.front();
  if (letter == 'X' || letter == 'Y' || letter == 'Z') positions_ = true;
  if (letter != 'G') return;
  const int code = code_of(value);
  if (code == 74 || code == 84) {
    std::string started = "G" + std::to_string(code);
    cycle_starts_ = cycle_ != started;
    cycle_ = std::move(started);
    names_cycle_ = true;
  } else if ((code >= 0 && code <= 3) || code == 80) {
    cycle_.clear();
  }
}

bool IntermediateCode::end_block() {
  if (continues_cycle()) length_ += 1 + cycle_.size();
  length_ += 1 + kEndOfBlock.size();
  if (!keeps_text_) return length_ <= kLongestBlock;
  // In a block that goes on with the cycle its code stands behind the other codes.
  if (continues_cycle()) {
    const auto behind =
        std::find_if(words_.begin(), words_.end(), [](const std::string& word) { return word[0] != 'G'; });
    words_.insert(behind, cycle_);
  }
  std::string line = std::move(head_);
  for (const std::string& word : words_) {
    line += ' ';
    line += word;
  }
  line += ' ';
  line += kEndOfBlock;
  const bool fits = add_line(std::move(line));
  if (returns_) add_line(skip_ + "return");
  return fits;
}

bool IntermediateCode::add_line(std::string line) {
  const bool fits = line.size() <= kLongestBlock;
  if (keeps_text_) lines_.push_back(std::move(line));
  return fits;
}

void IntermediateCode::enclose(std::size_t first) {
  if (!keeps_text_) return;
  lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(first), "{");
  lines_.emplace_back("}");
}

std::string IntermediateCode::text(std::int32_t program) const {
  const bool subprogram = program >= kFirstSubprogram;
  std::string text = subprogram ? "open subprog " : "open prog ";
  text += std::to_string(program) + "\n";
  for (const std::string& line : lines_) text += line + "\n";
  // The return of a subprogram's last block is that of the footer.
  if (subprogram && (lines_.empty() || lines_.back() != "return")) text += "return\n";
  return text + "close\n";
}

}  // namespace kerf::omron
