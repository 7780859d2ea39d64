#pragma once
// The arguments of a macro call (manual 5.6, G65).

#include <optional>

#include "base/alarm.hpp"
#include "execute/macro_variables.hpp"
#include "syntax/block.hpp"

namespace kerf::melsec {

struct MacroCall {
  std::int32_t program = 0;
  std::int32_t repetitions = 1;
  std::uint64_t given = 0;  ///< bit i - 1: argument for the local variable i
  MacroVariables::Locals arguments{};
};

/// Reads the words of a block from `first` on, behind G65. Specification I gives each address a variable of
/// its own; repeated I, J and K are groups of specification II; of two addresses of one variable the last
/// counts. False: `alarm` says what is wrong.
bool read_macro_call(const Block& block, std::size_t first, MacroCall& call, std::optional<Alarm>& alarm);

}  // namespace kerf::melsec
