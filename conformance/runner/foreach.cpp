#include "conformance/runner/foreach.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace kerf::conformance {
namespace {

bool is_name(std::string_view word) {
  return word.size() >= 2 && word[0] == '$' &&
         word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", 1) == std::string_view::npos;
}

}  // namespace

tl::expected<std::vector<Replacements>, std::string> parse_foreach(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos)
    return tl::unexpected(std::string("foreach needs '=': $a $b = 1 2 | 3 4"));
  const std::vector<std::string> names = words_of(text.substr(0, equals));
  if (names.empty()) return tl::unexpected(std::string("foreach names nothing before '='"));
  for (const std::string& name : names) {
    if (!is_name(name)) return tl::unexpected(fmt::format("'{}' is no name: $ and lower-case letters", name));
  }
  std::vector<Replacements> alternatives;
  for (const std::string& part : parts_of(text.substr(equals + 1), '|')) {
    std::vector<std::string> cells = words_of(part);
    if (cells.size() != names.size()) {
      return tl::unexpected(
          fmt::format("'{}' has {} values for {} names", trimmed(part), cells.size(), names.size()));
    }
    Replacements& replacements = alternatives.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) {
      std::replace(cells[i].begin(), cells[i].end(), '~', ' ');
      replacements.emplace_back(names[i], cells[i]);
    }
  }
  return alternatives;
}

std::vector<Replacements> combinations(const std::vector<std::vector<Replacements>>& lists) {
  std::vector<Replacements> all(1);
  for (const std::vector<Replacements>& list : lists) {
    std::vector<Replacements> longer;
    for (const Replacements& first : all) {
      for (const Replacements& next : list) {
        longer.push_back(first);
        longer.back().insert(longer.back().end(), next.begin(), next.end());
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::string replaced(std::string_view text, const Replacements& replacements) {
  std::string result;
  while (!text.empty()) {
    const std::pair<std::string, std::string>* best = nullptr;
    for (const auto& replacement : replacements) {
      const bool fits = text.substr(0, replacement.first.size()) == replacement.first;
      if (fits && (best == nullptr || best->first.size() < replacement.first.size())) best = &replacement;
    }
    result += best != nullptr ? std::string_view(best->second) : text.substr(0, 1);
    text.remove_prefix(best != nullptr ? best->first.size() : 1);
  }
  return result;
}

std::string replacements_text(const Replacements& replacements) {
  std::string text;
  for (const auto& [name, value] : replacements) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, value);
  }
  return text;
}

}  // namespace kerf::conformance
