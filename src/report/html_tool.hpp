#pragma once
// What compensation and normal line control do with the tool, in the data of the HTML report.

#include <optional>
#include <string>

#include "report/html_report.hpp"

namespace kerf {

/// The axis of normal line control when a move is under it.
std::optional<Axis> shown_normal_axis(const ReportInput& input);

/// Appends the members programmed, swept and pointing (see append_report_data), with a comma behind.
void append_tool_layers(std::string& out, const ReportInput& input);

}  // namespace kerf
