#pragma once
// The declared key a mistyped one was probably meant to be.

#include <cstddef>
#include <optional>
#include <string>

#include "base/axis.hpp"
#include "machine/schema.hpp"

namespace kerf {

/// The nearest declared key or section to a path whose segment `fault` (from 0) is unknown; among the axes of
/// the machine where the path names none. In order: by edit distance, as an abbreviation, as the same name in
/// another table.
std::optional<std::string> nearest_key(const Schema& schema, AxisSet axes, const KeyPath& path,
                                       std::size_t fault);

/// The names declared in the section that the path's segments before `fault` lead to: "cycle_ms, name".
std::string names_beside(const Schema& schema, const KeyPath& path, std::size_t fault);

}  // namespace kerf
