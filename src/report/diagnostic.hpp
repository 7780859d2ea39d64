#pragma once
// An alarm printed for people: where it is, the source line with a caret, why, and what to write instead.
//
//     part.nc:12:8: alarm arc-radius: the end point is 0.2 mm off the arc
//       12 | G2 X10 Y0 I5 J1
//          |       ^~~
//          = cause: the distances of start and end from the centre differ
//          = write: I and J so that both distances agree, or the radius as R

#include <string>
#include <string_view>

#include "base/alarm.hpp"

namespace kerf {

struct DiagnosticStyle {
  bool color = false;  ///< ANSI colours; only when the output is a terminal that shows them
  int width = 100;     ///< columns of the output; longer source lines are cut, longer sentences wrapped
};

/// Appends the alarm with line ends. `source` is the text the alarm's span points into; when it is empty or
/// another text, the source line is left out. Bytes of the source never reach the terminal as control codes.
void append_diagnostic(std::string& out, std::string_view file_name, std::string_view source,
                       const Alarm& alarm, const DiagnosticStyle& style);

/// append_diagnostic() as a value.
std::string diagnostic_text(std::string_view file_name, std::string_view source, const Alarm& alarm,
                            const DiagnosticStyle& style = {});

}  // namespace kerf
