#pragma once
// The alternatives of a case: `foreach: $a $b = 1 2 | 3 4`.

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "conformance/runner/text.hpp"

namespace kerf::conformance {

/// One set of replacements, names with their `$`.
using Replacements = std::vector<std::pair<std::string, std::string>>;

/// The alternatives of one `foreach` line, without its header word. Cells are separated by blanks,
/// alternatives by
/// `|`; a `~` in a cell is a blank. The error is a message.
tl::expected<std::vector<Replacements>, std::string> parse_foreach(std::string_view text);

/// All combinations, the last list varying fastest.
std::vector<Replacements> combinations(const std::vector<std::vector<Replacements>>& lists);

/// The text with every name replaced, the longest name that fits first.
std::string replaced(std::string_view text, const Replacements& replacements);

/// `$a=1 $b=2`
std::string replacements_text(const Replacements& replacements);

}  // namespace kerf::conformance
