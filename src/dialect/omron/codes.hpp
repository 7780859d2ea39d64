#pragma once
// The codes and words of the controller (manual 1-2, 1-4, 1-5).

#include <span>

#include "execute/code_table.hpp"

namespace kerf::omron {

std::span<const CodeRow> code_table();

/// The row of a G code, null when there is none.
const CodeRow* find_g_code(CodeNumber number);

}  // namespace kerf::omron
