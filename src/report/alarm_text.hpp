#pragma once
// Alarms as one JSON object and as a short name.

#include <string>
#include <string_view>

#include "base/alarm.hpp"

namespace kerf {

/// How people name a kind: its lower-case word (`arc-radius`), or code and details code (`1FC3H 0313H`) where
/// the details are no word.
std::string short_name(const AlarmKind& kind);

/// "alarm" or "warning"; also the value of `event` in JSON.
std::string_view severity_word(Severity severity);

/// Appends {"event":"alarm",...} with the keys of an alarm line of `kerf path --json`, without a line end.
/// `program` is the number of the program it is about; -1: none.
void append_alarm_json(std::string& out, const Alarm& alarm, std::int32_t program = -1);

}  // namespace kerf
