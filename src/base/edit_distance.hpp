#pragma once
// How alike two words are, for "did you mean".

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>

namespace kerf {

/// Longer texts are no typing mistakes, and comparing them would take its time.
inline constexpr std::size_t kLongestComparedText = 120;

/// Least number of inserted, deleted, replaced or swapped neighbouring characters that make one text the
/// other (optimal string alignment), upper and lower case being the same. Of texts of which one is longer
/// than kLongestComparedText: the length of the longer one. Allocates nothing.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of a list that somebody who wrote `written` probably meant: the nearest one with at most one
/// mistake in three letters; empty when none is that near. `name_of` gives the word of an element of the
/// list, as a view that outlives the call.
template <class List, class NameOf = std::identity>
std::string_view nearest_word(std::string_view written, const List& list, NameOf name_of = {}) {
  std::string_view nearest;
  std::size_t best = std::max<std::size_t>(1, written.size() / 3) + 1;
  for (const auto& element : list) {
    const std::string_view word = std::invoke(name_of, element);
    const std::size_t distance = edit_distance(written, word);
    if (distance >= best) continue;
    best = distance;
    nearest = word;
  }
  return nearest;
}

}  // namespace kerf
