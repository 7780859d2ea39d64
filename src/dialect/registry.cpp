#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "dialect/dgshape/dialect.hpp"
#include "dialect/dialect.hpp"
#include "dialect/melsec/dialect.hpp"
#include "dialect/omron/dialect.hpp"
#include "machine/common_parameters.hpp"

namespace kerf {
namespace {

/// The machine-file sections of all other dialects.
std::span<const std::string_view> sections_beside(std::string_view name) {
  static const auto kBeside = [] {
    std::map<std::string_view, std::vector<std::string_view>> beside;
    for (const Dialect& own : dialects()) {
      std::vector<std::string_view>& others = beside[own.name];
      for (const Dialect& other : dialects()) {
        if (other.name != own.name) others.push_back(other.name);
      }
    }
    return beside;
  }();
  return kBeside.at(name);
}

/// The keys that all dialects share, as a dialect knows them.
std::vector<Parameter> shared_parameters(const Dialect& dialect) {
  std::vector<Parameter> shared;
  for (const Parameter& parameter : common_parameters()) {
    const auto& absent = dialect.not_shared;
    if (std::find(absent.begin(), absent.end(), parameter.key) != absent.end()) continue;
    const auto own = std::find_if(dialect.shared.begin(), dialect.shared.end(),
                                  [&](const Parameter& p) { return p.key == parameter.key; });
    shared.push_back(own == dialect.shared.end() ? parameter : *own);
  }
  return shared;
}

/// Computed once: schemas refer to them.
std::span<const Parameter> shared_parameters_of(std::string_view name) {
  static const auto kShared = [] {
    std::map<std::string_view, std::vector<Parameter>> shared;
    for (const Dialect& dialect : dialects()) shared.emplace(dialect.name, shared_parameters(dialect));
    return shared;
  }();
  return kShared.at(name);
}

}  // namespace

std::span<const Dialect> dialects() {
  // The last one takes every text that no other one does.
  static const std::array<Dialect, 3> kDialects{dgshape::dialect(), melsec::dialect(), omron::dialect()};
  return kDialects;
}

const Dialect* find_dialect(std::string_view name) {
  const auto all = dialects();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Dialect& d) { return d.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const Dialect& detect_dialect(std::string_view file_name, std::string_view text) {
  const auto all = dialects();
  std::string name(file_name);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const auto named = std::find_if(all.begin(), all.end(), [&](const Dialect& d) {
    return !d.file_extension.empty() && name.ends_with(d.file_extension);
  });
  if (named != all.end()) return *named;
  return *std::find_if(all.begin(), all.end(), [text](const Dialect& d) {
    return d.file_extension.empty() && (d.recognises == nullptr || d.recognises(text));
  });
}

Schema schema_of(const Dialect& dialect) {
  return {shared_parameters_of(dialect.name),
          dialect.parameters,
          dialect.defaults,
          sections_beside(dialect.name),
          dialect.key_alarms,
          dialect.shared_names,
          dialect.highest_tool};
}

}  // namespace kerf
