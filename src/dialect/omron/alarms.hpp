#pragma once
// The alarm catalogue of the OMRON dialect. The manual gives one code, that of a program execution error; the
// words are kerf's own.

#include <span>
#include <string_view>

#include "base/alarm.hpp"

namespace kerf::omron {

std::span<const AlarmKind> alarm_catalogue();

/// The row of a word; asking for one that is not in the catalogue is a bug.
const AlarmKind& alarm_kind(std::string_view detail);

}  // namespace kerf::omron
