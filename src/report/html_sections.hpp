#pragma once
// The parts of the HTML report that need no script: totals, axes, alarms.

#include <string>

#include "report/html_report.hpp"

namespace kerf {

/// Appends the cards with times, lengths and counts.
void append_cards(std::string& out, const RunSummary& summary);

/// Appends the table of axes: range, and peaks against the machine's limits.
void append_axis_table(std::string& out, const RunSummary& summary, const Machine& machine);

/// Appends each alarm with its source line and a caret; nothing when there is none.
void append_alarms(std::string& out, const ReportInput& input);

}  // namespace kerf
