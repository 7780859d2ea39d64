#pragma once
// How alike two words are, for "did you mean".

#include <cstddef>
#include <string_view>

namespace kerf {

/// Longer texts are no typing mistakes, and comparing them would take its time.
inline constexpr std::size_t kLongestComparedText = 120;

/// Least number of inserted, deleted, replaced or swapped neighbouring characters that make one text the
/// other (optimal string alignment), upper and lower case being the same. Of texts of which one is longer
/// than kLongestComparedText: the length of the longer one. Allocates nothing.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace kerf
