#pragma once
// The words of the DGSHAPE dialect (manual 2-7): what `kerf codes` lists and the interpreter knows.

#include <span>

#include "execute/code_table.hpp"

namespace kerf::dgshape {

std::span<const CodeRow> code_table();

}  // namespace kerf::dgshape
