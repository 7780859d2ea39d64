#include "report/summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <optional>
#include <string_view>

#include "report/alarm_text.hpp"
#include "report/number_text.hpp"

namespace kerf {
namespace {

/// "72 %" of a whole; "-" when there is no whole.
std::string share_text(double part, double whole) {
  if (!(whole > 0.0) || !std::isfinite(part)) return "-";
  return fmt::format("{} %", fixed_text(part / whole * 100.0, 0));
}

void append_time_row(std::string& out, std::string_view label, double part_s, double whole_s,
                     std::optional<double> length_mm) {
  std::string row =
      fmt::format("  {:<14}{:>12}{:>8}", label, clock_text(part_s), share_text(part_s, whole_s));
  if (length_mm) row += fmt::format("{:>16} mm", fixed_text(*length_mm, 3));
  out += row;
  out += '\n';
}

void append_times(std::string& out, const RunSummary& summary) {
  out += fmt::format("{:<16}{:>12}\n", "time", clock_text(summary.time_s));
  append_time_row(out, "cutting", summary.cutting_s, summary.time_s, summary.cutting_mm);
  append_time_row(out, "rapid", summary.rapid_s, summary.time_s, summary.rapid_mm);
  append_time_row(out, "dwell", summary.dwell_s, summary.time_s, std::nullopt);
  append_time_row(out, "tool change", summary.tool_change_s, summary.time_s, std::nullopt);
  append_time_row(out, "spindle wait", summary.spindle_wait_s, summary.time_s, std::nullopt);
}

void append_axes(std::string& out, const RunSummary& summary, const Machine& machine) {
  out += fmt::format("{:<4}{:>12}{:>12}{:>12}{:>18}{:>18}{:>17}\n", "axis", "low", "high", "travel",
                     "peak speed /min", "peak accel. /s2", "corner step /s");
  for (const Axis axis : summary.axes) {
    const AxisBounds& bounds = summary.bounds[index(axis)];
    const AxisPeak& peak = summary.peak[index(axis)];
    const std::string speed = fmt::format("{} ({})", fixed_text(peak.velocity, 1),
                                          share_text(peak.velocity, speed_limit(machine[axis])));
    const std::string acceleration = fmt::format("{} ({})", fixed_text(peak.acceleration, 1),
                                                 share_text(peak.acceleration, machine[axis].acceleration));
    out += fmt::format("{:<4}{:>12}{:>12}{:>12}{:>18}{:>18}{:>17}\n", letter(axis), fixed_text(bounds.low, 4),
                       fixed_text(bounds.high, 4), fixed_text(bounds.high - bounds.low, 4), speed,
                       acceleration, fixed_text(peak.corner_step, 2));
  }
}

void append_alarm_count(std::string& out, const RunSummary& summary) {
  const auto warnings =
      static_cast<std::size_t>(std::count_if(summary.alarms.begin(), summary.alarms.end(),
                                             [](const Alarm& alarm) { return !stops_program(alarm); }));
  out += fmt::format("alarms {}, warnings {}\n", summary.alarms.size() - warnings, warnings);
}

/// Writes members of a JSON object one after the other.
class ObjectWriter {
 public:
  explicit ObjectWriter(std::string& out) : out_(out) { out_ += '{'; }
  void key(std::string_view name) {
    if (!first_) out_ += ',';
    first_ = false;
    out_ += '"';
    out_ += name;
    out_ += "\":";
  }
  void number(std::string_view name, double value) {
    key(name);
    append_number(out_, value);
  }
  void count(std::string_view name, std::uint64_t value) {
    key(name);
    out_ += fmt::format_int(value).c_str();
  }
  void close() { out_ += '}'; }

 private:
  std::string& out_;
  bool first_ = true;
};

void append_bounds_json(std::string& out, const RunSummary& summary) {
  ObjectWriter object(out);
  for (const Axis axis : summary.axes) {
    const AxisBounds& bounds = summary.bounds[index(axis)];
    object.key(std::string(1, letter(axis)));
    out += '[';
    append_number(out, bounds.low);
    out += ',';
    append_number(out, bounds.high);
    out += ']';
  }
  object.close();
}

void append_peaks_json(std::string& out, const RunSummary& summary) {
  ObjectWriter object(out);
  for (const Axis axis : summary.axes) {
    const AxisPeak& peak = summary.peak[index(axis)];
    object.key(std::string(1, letter(axis)));
    ObjectWriter values(out);
    values.number("velocity", peak.velocity);
    values.number("acceleration", peak.acceleration);
    values.number("corner_step", peak.corner_step);
    values.number("jerk", peak.jerk);
    values.close();
  }
  object.close();
}

}  // namespace

double speed_limit(const AxisSettings& axis) {
  return std::max(axis.rapid, axis.max_feed);
}

void append_summary(std::string& out, const RunSummary& summary, const Machine& machine) {
  append_times(out, summary);
  out += fmt::format("blocks {}, moves {}, control cycles {}\n", grouped_text(summary.blocks),
                     grouped_text(summary.moves), grouped_text(summary.cycles));
  if (!summary.axes.empty()) append_axes(out, summary, machine);
  append_alarm_count(out, summary);
}

void append_summary_json(std::string& out, const RunSummary& summary) {
  ObjectWriter object(out);
  object.number("time_s", summary.time_s);
  object.number("cutting_s", summary.cutting_s);
  object.number("rapid_s", summary.rapid_s);
  object.number("dwell_s", summary.dwell_s);
  object.number("tool_change_s", summary.tool_change_s);
  object.number("spindle_wait_s", summary.spindle_wait_s);
  object.number("cutting_mm", summary.cutting_mm);
  object.number("rapid_mm", summary.rapid_mm);
  object.count("blocks", summary.blocks);
  object.count("moves", summary.moves);
  object.count("cycles", summary.cycles);
  object.key("bounds");
  append_bounds_json(out, summary);
  object.key("peak");
  append_peaks_json(out, summary);
  object.key("alarms");
  out += '[';
  std::string_view separator;
  for (const Alarm& alarm : summary.alarms) {
    out += separator;
    separator = ",";
    append_alarm_json(out, alarm);
  }
  out += ']';
  object.close();
  out += '\n';
}

}  // namespace kerf
