#pragma once
// A run as one self-contained HTML page: nothing is loaded from elsewhere, and no text of the program can
// become code.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "machine/machine.hpp"
#include "motion/run_record.hpp"
#include "report/move_geometry.hpp"

namespace kerf {

/// What the page shows. The record and the machine outlive the call.
struct ReportInput {
  std::string title;      ///< heading; empty: the file name
  std::string file_name;  ///< of the program
  std::string dialect;    ///< "MELSEC", ...; empty: left out
  std::string maker;      ///< who made the page, e.g. "kerf 0.1.0"
  std::string_view source_text;
  /// The text a program number was read from, when subprograms stand in other files. Unset: `source_text`.
  std::function<std::string_view(std::int32_t program)> source_of_program;
  const RunRecord& record;
  const Machine& machine;
  DrawingExtras extras{};  ///< what the views show beside the moves
};

/// The whole page: summary, alarms with their source lines, plan and elevation to zoom into, speed over time,
/// and the table of executed blocks; all linked, so that a block chosen in one is marked in the others.
std::string html_report(const ReportInput& input);

}  // namespace kerf
