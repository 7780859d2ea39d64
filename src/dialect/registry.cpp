#include <algorithm>
#include <array>

#include "dialect/dgshape/dialect.hpp"
#include "dialect/dialect.hpp"
#include "machine/common_parameters.hpp"

namespace kerf {

std::span<const Dialect> dialects() {
  static const std::array<Dialect, 1> kDialects{dgshape::dialect()};
  return kDialects;
}

const Dialect* find_dialect(std::string_view name) {
  const auto all = dialects();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Dialect& d) { return d.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const Dialect& detect_dialect(std::string_view, std::string_view) {
  // With one dialect there is nothing to choose; its own alarms tell a foreign file from a program.
  return dialects().front();
}

Schema schema_of(const Dialect& dialect) {
  static constexpr std::array<std::string_view, 2> kForeignSections{"omron", "melsec"};
  return {common_parameters(), dialect.parameters, dialect.defaults, kForeignSections};
}

}  // namespace kerf
