#pragma once
// The user variables of a program (manual 4-3) as kerf numbers them: L, then Q, then P.

#include <cstdint>
#include <optional>
#include <string_view>

#include "execute/macro_variables.hpp"

namespace kerf::omron {

inline constexpr std::int64_t kLocalVariables = 256;     ///< L, for each level of programs
inline constexpr std::int64_t kSystemVariables = 4096;   ///< Q, of the coordinate system
inline constexpr std::int64_t kSharedVariables = 32768;  ///< P, of the controller
inline constexpr std::size_t kDeepestCall = 8;           ///< subprograms within each other

/// The number of a variable, nothing when there is none. `bank` is L, Q or P.
std::optional<std::int64_t> variable_number(char bank, std::int64_t address);

/// The number of a variable from its name: L12.
std::optional<std::int64_t> variable_named(std::string_view name);

/// System values are the positions captured of each motor.
MacroVariableLayout variable_layout(int motors);

}  // namespace kerf::omron
