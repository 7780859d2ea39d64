#pragma once
// The alarms a dialect can raise, for `kerf alarms`.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/alarm.hpp"

namespace kerf {

/// Appends a table: code, detail, name, in the order of the catalogue.
void append_alarm_table(std::string& out, std::span<const AlarmKind> kinds);

/// Appends one kind with its cause and remedy, sentences wrapped to `width` columns.
void append_alarm_explained(std::string& out, const AlarmKind& kind, int width = 100);

/// Appends a JSON array of {"code","detail","name","severity","cause","remedy"}, one kind a line.
void append_alarms_json(std::string& out, std::span<const AlarmKind> kinds);

/// The kinds a user may mean by `key`: the detail (`arc-radius`), the code (`1FC3H`), or both with a space,
/// `-`, `/` or `:` between (`1FC3H-0313H`); upper and lower case are the same.
std::vector<const AlarmKind*> find_alarms(std::span<const AlarmKind> kinds, std::string_view key);

}  // namespace kerf
