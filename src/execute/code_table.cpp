#include "execute/code_table.hpp"

#include <algorithm>
#include <charconv>

#include "base/edit_distance.hpp"

namespace kerf {
namespace {

/// Codes of equal length that differ in one digit are simply two codes, no slip of the fingers.
bool one_digit_differs(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  int differences = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differences += a[i] != b[i] ? 1 : 0;
  return differences == 1;
}

}  // namespace

const CodeRow* find_code(std::span<const CodeRow> rows, char letter, CodeNumber number) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const CodeRow& candidate) {
    return candidate.letter == letter && candidate.number == number && candidate.word.size() > 1;
  });
  return row == rows.end() ? nullptr : &*row;
}

CodeNumber code_named(std::string_view word) {
  if (word.empty()) return kNoCode;
  const char* const end = word.data() + word.size();
  int whole = 0;
  int tenth = 0;
  auto read = std::from_chars(word.data() + 1, end, whole);
  if (read.ec == std::errc{} && read.ptr != end && *read.ptr == '.')
    read = std::from_chars(read.ptr + 1, end, tenth);
  const bool good =
      read.ec == std::errc{} && read.ptr == end && whole >= 0 && whole < 1000 && tenth >= 0 && tenth < 10;
  return good ? code(whole, tenth) : kNoCode;
}

FixedText<200> nearest_code(std::span<const CodeRow> rows, char letter, std::int64_t number) {
  const auto written = FixedText<24>::format("{}{:02}", letter, number);
  const CodeRow* best = nullptr;
  for (const CodeRow& row : rows) {
    if (row.letter != letter || row.word.size() < 2) continue;
    if (edit_distance(written.view(), row.word) > 1 || one_digit_differs(written.view(), row.word)) continue;
    if (best != nullptr) return {};  // two that are equally near: neither is worth proposing
    best = &row;
  }
  if (best == nullptr) return {};
  return FixedText<200>::format("did you mean {} ({})? `kerf codes` lists every code", best->word,
                                best->name);
}

}  // namespace kerf
