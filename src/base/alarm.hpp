#pragma once
// Alarms: what a controller says when it refuses a program, and where.

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/fixed_text.hpp"
#include "base/source_span.hpp"

namespace kerf {

enum class Severity : std::uint8_t { warning, alarm };

/// One row of a dialect's alarm catalogue. The catalogue feeds the checker, `kerf alarms` and the
/// documentation.
struct AlarmKind {
  std::string_view code;    ///< the controller's error code; "DGS" where the manual gives none
  std::string_view detail;  ///< details code, or a stable lower-case word
  std::string_view name;    ///< short title, e.g. "Arc radius difference over"
  std::string_view cause;   ///< why the controller refuses, in plain words
  std::string_view remedy;  ///< what to write instead
  Severity severity = Severity::alarm;
};

/// One occurrence of an alarm or warning.
struct Alarm {
  const AlarmKind* kind = nullptr;  ///< never null in an alarm that was raised
  SourceSpan span;
  FixedText<200> message;  ///< what is wrong here, with the values; empty: the kind's cause says it all
  FixedText<200> remedy;   ///< empty: the kind's remedy
};

/// The row of a detail; asking for one that is not in the catalogue is a bug.
inline const AlarmKind& find_alarm(std::span<const AlarmKind> catalogue, std::string_view detail) {
  const auto row = std::find_if(catalogue.begin(), catalogue.end(),
                                [&](const AlarmKind& kind) { return kind.detail == detail; });
  assert(row != catalogue.end());
  return *row;
}

/// An alarm stops the program; a warning is only told.
inline bool stops_program(const Alarm& alarm) {
  return alarm.kind->severity == Severity::alarm;
}

inline std::string_view message_of(const Alarm& alarm) {
  return alarm.message.empty() ? alarm.kind->cause : alarm.message.view();
}
inline std::string_view remedy_of(const Alarm& alarm) {
  return alarm.remedy.empty() ? alarm.kind->remedy : alarm.remedy.view();
}

}  // namespace kerf
