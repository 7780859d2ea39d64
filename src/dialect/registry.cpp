#include <algorithm>
#include <array>

#include "dialect/dgshape/dialect.hpp"
#include "dialect/dialect.hpp"
#include "dialect/melsec/dialect.hpp"
#include "machine/common_parameters.hpp"

namespace kerf {

std::span<const Dialect> dialects() {
  static const std::array<Dialect, 2> kDialects{dgshape::dialect(), melsec::dialect()};
  return kDialects;
}

const Dialect* find_dialect(std::string_view name) {
  const auto all = dialects();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Dialect& d) { return d.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const Dialect& detect_dialect(std::string_view file_name, std::string_view) {
  return *find_dialect(file_name.ends_with(".gcd") ? "melsec" : "dgshape");
}

Schema schema_of(const Dialect& dialect) {
  static constexpr std::array<std::string_view, 3> kSections{"dgshape", "omron", "melsec"};
  static constexpr std::array<std::string_view, 2> kNotDgshape{kSections[1], kSections[2]};
  static constexpr std::array<std::string_view, 2> kNotMelsec{kSections[0], kSections[1]};
  return {common_parameters(), dialect.parameters, dialect.defaults,
          dialect.name == kSections[0] ? kNotDgshape : kNotMelsec};
}

}  // namespace kerf
