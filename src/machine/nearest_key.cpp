#include "machine/nearest_key.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/edit_distance.hpp"

namespace kerf {
namespace {

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return out;
}

std::string dotted(const KeyPath& path) {
  std::string text;
  for (const std::string& segment : path) text += (text.empty() ? "" : ".") + segment;
  return text;
}

/// The declared key with the `*` filled from the same place of the path or, failing that, with the first axis
/// or tool.
KeyPath concrete(const Parameter& parameter, AxisSet axes, const KeyPath& path) {
  KeyPath key = split_key(parameter.key);
  for (std::size_t i = 0; i < key.size(); ++i) {
    if (key[i] != "*") continue;
    const std::string written = i < path.size() ? upper(path[i]) : std::string();
    if (instance_of(parameter) == Instance::tool) {
      key[i] = tool_of(written) ? written : "1";
    } else {
      const char first = axes.empty() ? 'X' : letter(*axes.begin());
      key[i] = axis_of(written) ? written : std::string(1, first);
    }
  }
  return key;
}

/// Every declared key and, before it, the sections that lead to it.
std::vector<KeyPath> candidates(const Schema& schema, AxisSet axes, const KeyPath& path) {
  std::vector<KeyPath> all;
  for (const std::span<const Parameter> table : {schema.common, schema.dialect}) {
    for (const Parameter& parameter : table) {
      const KeyPath key = concrete(parameter, axes, path);
      for (std::size_t size = 1; size <= key.size(); ++size) {
        all.emplace_back(key.begin(), key.begin() + static_cast<std::ptrdiff_t>(size));
      }
    }
  }
  return all;
}

bool same_start(const KeyPath& a, const KeyPath& b, std::size_t count) {
  return a.size() >= count && b.size() >= count &&
         std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(count), b.begin());
}

}  // namespace

std::optional<std::string> nearest_key(const Schema& schema, AxisSet axes, const KeyPath& path,
                                       std::size_t fault) {
  const std::string written = dotted(path);
  const std::string& segment = path[fault];
  if (written.size() > kLongestComparedText) return std::nullopt;
  const std::vector<KeyPath> all = candidates(schema, axes, path);

  std::optional<std::string> nearest;
  std::size_t best = std::max<std::size_t>(1, segment.size() / 3) + 1;
  for (const KeyPath& candidate : all) {
    const std::string key = dotted(candidate);
    if (key == written) continue;
    const std::size_t distance = edit_distance(written, key);
    if (distance < best) {
      best = distance;
      nearest = key;
    }
  }
  if (nearest) return nearest;

  constexpr std::size_t kShortestAbbreviation = 3;
  for (const KeyPath& candidate : all) {
    const bool beside = candidate.size() == fault + 1 && same_start(candidate, path, fault);
    if (beside && segment.size() >= kShortestAbbreviation && candidate[fault].starts_with(segment)) {
      return dotted(candidate);
    }
  }
  for (const KeyPath& candidate : all) {
    if (candidate.back() == path.back() && candidate != path) return dotted(candidate);
  }
  return std::nullopt;
}

std::string names_beside(const Schema& schema, const KeyPath& path, std::size_t fault) {
  std::vector<std::string> names;
  for (const KeyPath& candidate : candidates(schema, {}, path)) {
    if (candidate.size() != fault + 1 || !same_start(candidate, path, fault)) continue;
    if (std::find(names.begin(), names.end(), candidate[fault]) == names.end()) {
      names.push_back(candidate[fault]);
    }
  }
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace kerf
