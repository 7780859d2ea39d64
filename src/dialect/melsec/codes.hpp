#pragma once
// The words of the MELSEC G-code control (manual 5.4, 5.6, 5.7): what `kerf codes` lists and the interpreter
// knows.

#include <span>

#include "execute/code_table.hpp"

namespace kerf::melsec {

std::span<const CodeRow> code_table();

}  // namespace kerf::melsec
