#include "dialect/omron/intermediate.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace kerf::omron {
namespace {

constexpr std::string_view kEndOfBlock = "M999.002";
constexpr std::string_view kCycleStarts = "G80.001";
constexpr std::int32_t kFirstSubprogram = 1000;

int code_of(std::string_view value) {
  int code = -1;
  const char* last = value.data() + value.size();
  const auto [end, error] = std::from_chars(value.data(), last, code);
  return error == std::errc() && end == last ? code : -1;
}

}  // namespace

void IntermediateCode::begin_block(std::uint32_t line, int skip) {
  words_.clear();
  head_ = skip > 0 ? "cskip" + std::to_string(skip) + " " : std::string();
  head_ += "N" + std::to_string(line);
  cycle_starts_ = names_cycle_ = positions_ = returns_ = false;
}

void IntermediateCode::add_word(const Word& word) {
  std::string_view address = word.address;
  if (address.size() == 2 && address.front() == 'V') address.remove_prefix(1);  // an argument of an M code
  note_cycle(word.address, word.value);
  if (address == "M" && code_of(word.value) == 99) returns_ = true;
  if (cycle_starts_ && words_.end() == std::find(words_.begin(), words_.end(), kCycleStarts))
    words_.emplace_back(kCycleStarts);
  std::string text(address);
  text += word.is_variable ? "(" + std::string(word.value) + ")" : std::string(word.value);
  words_.push_back(std::move(text));
}

void IntermediateCode::note_cycle(std::string_view address, std::string_view value) {
  if (address == "X" || address == "Y" || address == "Z") positions_ = true;
  if (address != "G") return;
  const int code = code_of(value);
  if (code == 74 || code == 84) {
    std::string started = "G" + std::string(value);
    cycle_starts_ = cycle_ != started;
    cycle_ = std::move(started);
    names_cycle_ = true;
  } else if ((code >= 0 && code <= 3) || code == 80) {
    cycle_.clear();
  }
}

bool IntermediateCode::end_block() {
  // In a block that goes on with the cycle its code stands behind the other codes.
  if (!cycle_.empty() && positions_ && !names_cycle_) {
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
  if (returns_) add_line("return");
  return fits;
}

bool IntermediateCode::add_line(std::string line) {
  lines_.push_back(std::move(line));
  return lines_.back().size() <= kLongestBlock;
}

void IntermediateCode::enclose(std::size_t first) {
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
