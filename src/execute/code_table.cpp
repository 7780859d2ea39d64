#include "execute/code_table.hpp"

#include <algorithm>

#include "base/edit_distance.hpp"

namespace kerf {
const CodeRow* find_code(std::span<const CodeRow> rows, char letter, CodeNumber number) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const CodeRow& candidate) {
    return candidate.letter == letter && candidate.number == number && candidate.word.size() > 1;
  });
  return row == rows.end() ? nullptr : &*row;
}

FixedText<200> nearest_code(std::span<const CodeRow> rows, char letter, std::int64_t number) {
  const auto written = FixedText<24>::format("{}{:02}", letter, number);
  const CodeRow* best = nullptr;
  std::size_t best_distance = 2;
  for (const CodeRow& row : rows) {
    if (row.letter != letter || row.word.size() < 2) continue;
    const std::size_t distance = edit_distance(written.view(), row.word);
    if (distance < best_distance) {
      best = &row;
      best_distance = distance;
    }
  }
  if (best == nullptr) return {};
  return FixedText<200>::format("did you mean {} ({})? `kerf codes` lists every code", best->word,
                                best->name);
}

}  // namespace kerf
