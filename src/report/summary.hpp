#pragma once
// The totals of a run, as text and as the object of `kerf run --json`.

#include <string>

#include "machine/machine.hpp"
#include "motion/run_record.hpp"

namespace kerf {

/// The largest speed an axis may have, mm/min or degree/min: the faster of rapid and cutting feed.
double speed_limit(const AxisSettings& axis);

/// Appends the summary for people: times with their shares, path lengths, counts, and for each axis the range
/// used, peak speed and acceleration against the machine's limits. Lines have at most 100 columns. The jerk
/// stands in the JSON object only: of a law without a limit of jerk it says nothing but the length of the
/// cycle.
void append_summary(std::string& out, const RunSummary& summary, const Machine& machine);

/// Appends one JSON object and a line end. Keys: time_s, cutting_s, rapid_s, dwell_s, tool_change_s,
/// spindle_wait_s, cutting_mm, rapid_mm, blocks, moves, cycles, bounds {axis: [low, high]}, peak {axis:
/// {velocity mm/min, acceleration mm/s2, jerk mm/s3}} (degrees for rotary axes), alarms (warnings included).
void append_summary_json(std::string& out, const RunSummary& summary);

}  // namespace kerf
