#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "dialect/dgshape/dialect.hpp"
#include "dialect/dialect.hpp"
#include "dialect/melsec/dialect.hpp"
#include "machine/common_parameters.hpp"

namespace kerf {
namespace {

/// Controllers that a machine file may describe before kerf has their dialect.
constexpr std::array<std::string_view, 1> kPlanned{"omron"};

/// The machine-file sections of all other dialects.
std::span<const std::string_view> sections_beside(std::string_view name) {
  static const auto kBeside = [] {
    std::map<std::string_view, std::vector<std::string_view>> beside;
    for (const Dialect& own : dialects()) {
      std::vector<std::string_view>& others = beside[own.name];
      others.assign(kPlanned.begin(), kPlanned.end());
      for (const Dialect& other : dialects()) {
        if (other.name != own.name) others.push_back(other.name);
      }
    }
    return beside;
  }();
  return kBeside.at(name);
}

}  // namespace

std::span<const Dialect> dialects() {
  static const std::array<Dialect, 2> kDialects{dgshape::dialect(), melsec::dialect()};
  return kDialects;
}

const Dialect* find_dialect(std::string_view name) {
  const auto all = dialects();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Dialect& d) { return d.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const Dialect& detect_dialect(std::string_view file_name) {
  const auto all = dialects();
  const auto named = std::find_if(all.begin(), all.end(), [&](const Dialect& d) {
    return !d.file_extension.empty() && file_name.ends_with(d.file_extension);
  });
  if (named != all.end()) return *named;
  return *std::find_if(all.begin(), all.end(), [](const Dialect& d) { return d.file_extension.empty(); });
}

Schema schema_of(const Dialect& dialect) {
  return {common_parameters(),           dialect.parameters, dialect.defaults,
          sections_beside(dialect.name), dialect.key_alarms, dialect.shared_names};
}

}  // namespace kerf
