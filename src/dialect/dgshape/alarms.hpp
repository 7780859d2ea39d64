#pragma once
// The alarm catalogue of the DGSHAPE dialect. The manual speaks of errors without numbers, so each has a
// stable word.

#include <span>

#include "base/alarm.hpp"
#include "syntax/block_reader.hpp"

namespace kerf::dgshape {

std::span<const AlarmKind> alarm_catalogue();

/// The row of a detail word; asking for a word that is not in the catalogue is a bug.
const AlarmKind& alarm_kind(std::string_view detail);

const AlarmKind& syntax_alarm_kind(SyntaxFault fault);

}  // namespace kerf::dgshape
