#pragma once
// The alarm catalogue of the MELSEC dialect: the details codes of the manual's appendix 1, and under the code
// KERF the refusals that are kerf's own.

#include <optional>
#include <span>
#include <string_view>

#include "base/alarm.hpp"

namespace kerf::melsec {

std::span<const AlarmKind> alarm_catalogue();

/// The row of a details code ("0313H") or of a word of kerf's own ("endless-loop"); asking for one that is
/// not in the catalogue is a bug.
const AlarmKind& alarm_kind(std::string_view detail);

/// Writes why a block is refused into `alarm`; always false, so that a step can return it.
inline bool refuse(std::optional<Alarm>& alarm, std::string_view detail, const SourceSpan& span,
                   const FixedText<200>& message = {}) {
  alarm = Alarm{&alarm_kind(detail), span, message, {}};
  return false;
}

}  // namespace kerf::melsec
