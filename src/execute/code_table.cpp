#include "execute/code_table.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

namespace kerf {
namespace {

/// Edit distance with swaps of neighbours (optimal string alignment), for texts of a few characters.
int edit_distance(std::string_view a, std::string_view b) {
  constexpr std::size_t kMax = 12;
  if (a.size() >= kMax || b.size() >= kMax) return kMax;
  std::array<std::array<int, kMax>, kMax> d{};
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int cost = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + cost});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

const CodeRow* find_code(std::span<const CodeRow> rows, char letter, CodeNumber number) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const CodeRow& candidate) {
    return candidate.letter == letter && candidate.number == number && candidate.word.size() > 1;
  });
  return row == rows.end() ? nullptr : &*row;
}

FixedText<200> nearest_code(std::span<const CodeRow> rows, char letter, std::int64_t number) {
  const auto written = FixedText<24>::format("{}{:02}", letter, number);
  const CodeRow* best = nullptr;
  int best_distance = 2;
  for (const CodeRow& row : rows) {
    if (row.letter != letter || row.word.size() < 2) continue;
    const int distance = edit_distance(written.view(), row.word);
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
