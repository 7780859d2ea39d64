#pragma once
// The machine-file keys that every dialect shares.

#include <span>

#include "machine/parameter.hpp"

namespace kerf {

/// `dialect`, [machine], [axes.*], [offsets], [tools.*], [motion].
std::span<const Parameter> common_parameters();

/// Defaults that differ by axis whatever the dialect: A, B and C are rotary. They do not make the axes exist.
std::span<const DefaultOverride> common_defaults();

}  // namespace kerf
