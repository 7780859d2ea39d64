#pragma once
// The words of the DGSHAPE dialect (manual 2-7): what `kerf codes` lists and the interpreter knows.

#include <span>

#include "execute/code_table.hpp"

namespace kerf::dgshape {

std::span<const CodeRow> code_table();

/// What to write instead of a G or M code that other controls know and this one does not, or of a mistyped
/// one; empty when there is nothing to propose. `number` is the number as written, G05 being 5.
FixedText<200> remedy_for_unknown(char letter, std::int64_t number);

}  // namespace kerf::dgshape
