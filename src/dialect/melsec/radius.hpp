#pragma once
// The tool radius compensation in force, for all ways that a move is made on (manual 5.6, 6.4).

#include <optional>

#include "dialect/melsec/settings.hpp"
#include "execute/action.hpp"
#include "execute/state.hpp"

namespace kerf::melsec {

/// A side is selected, and its number is not 0.
bool is_compensated(const Registers& registers);

/// For a move whose block has no words for the compensation; no side when it is not in force.
RadiusCompensation compensation_in_force(const Registers& registers);

/// The plane that G17, G18 or G19 selects; nothing when the machine has no such axes.
std::optional<Plane> plane_of(CodeNumber selected, const ControllerSettings& settings);

}  // namespace kerf::melsec
