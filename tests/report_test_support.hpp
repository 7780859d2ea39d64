#pragma once
// What the tests of the reports share: a machine, actions, golden files, a check of XML.

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "execute/action.hpp"
#include "machine/machine.hpp"
#include "motion/run_record.hpp"

namespace kerf::report_test {

inline constexpr AlarmKind kArcRadius{
    "DGS",
    "arc-radius",
    "Arc radius difference over",
    "The distances of start and end from the centre differ.",
    "I and J so that both distances agree, or the radius as R. Either way the end point must lie on the arc.",
    Severity::alarm};
inline constexpr AlarmKind kFeedClamped{"DGS",
                                        "feed-clamped",
                                        "Feed clamped",
                                        "The feed is above the highest one.",
                                        "Write a lower F.",
                                        Severity::warning};
inline constexpr AlarmKind kNumbered{
    "1FC3H", "0313H", "Arc radius difference over", "The radii differ.", "Correct I and J.", Severity::alarm};

inline std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline std::string golden(const std::string& name) {
  return read_file(std::string(KERF_SOURCE_DIR) + "/tests/golden/report/" + name);
}

inline Machine machine_with(AxisSet axes) {
  Machine machine;
  machine.axes = axes;
  machine.axis[index(Axis::A)].type = AxisType::rotary;
  return machine;
}

inline AxisVector at(double x, double y, double z, double a = 0.0) {
  AxisVector position;
  position[Axis::X] = x;
  position[Axis::Y] = y;
  position[Axis::Z] = z;
  position[Axis::A] = a;
  return position;
}

inline Origin origin_of(std::uint32_t line, std::int32_t program = -1, std::int32_t sequence_number = -1) {
  Origin origin;
  origin.span.line = line;
  origin.span.column = 1;
  origin.block = line;
  origin.program = program;
  origin.sequence_number = sequence_number;
  return origin;
}

inline Move straight(MoveMode mode, AxisVector start, AxisVector end, double feed = 0.0) {
  Move move;
  move.mode = mode;
  move.start = start;
  move.end = end;
  move.commanded = end;
  move.feed = feed;
  return move;
}

/// An arc in the plane X-Y; the direction follows from the sign of the sweep.
inline Move arc_xy(AxisVector start, AxisVector end, double center_x, double center_y, double sweep,
                   double feed = 100.0) {
  const MoveMode mode = sweep < 0.0 ? MoveMode::clockwise : MoveMode::counterclockwise;
  Move move = straight(mode, start, end, feed);
  move.arc.center = {center_x, center_y};
  move.arc.radius = std::hypot(start[Axis::X] - center_x, start[Axis::Y] - center_y);
  move.arc.sweep = sweep;
  return move;
}

inline TimedAction timed(ActionVariant what, std::uint32_t line = 1) {
  TimedAction action;
  action.action = {origin_of(line), std::move(what)};
  return action;
}

inline std::vector<TimedAction> timed_moves(const std::vector<Move>& moves) {
  std::vector<TimedAction> actions;
  std::uint32_t line = 0;
  for (const Move& move : moves) actions.push_back(timed(move, ++line));
  return actions;
}

/// Empty when every element of an XML text is closed in order, every attribute quoted and every `&` an
/// entity; otherwise what is wrong.
inline std::string xml_fault(std::string_view text) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '&') {
      const std::size_t end = text.find(';', i);
      if (end == std::string_view::npos || end - i > 8) return "bare & at " + std::to_string(i);
      continue;
    }
    if (text[i] == '>') return "bare > at " + std::to_string(i);
    if (text[i] != '<') continue;
    std::size_t end = i + 1;
    bool quoted = false;
    for (; end < text.size() && (quoted || text[end] != '>'); ++end) {
      if (text[end] == '"') quoted = !quoted;
      if (text[end] == '<') return "< inside a tag at " + std::to_string(end);
    }
    if (end == text.size()) return "open tag at " + std::to_string(i);
    const std::string_view tag = text.substr(i + 1, end - i - 1);
    const std::string name(tag.substr(0, tag.find_first_of(" /\n", tag.front() == '/' ? 1 : 0)));
    if (name.empty()) return "no name at " + std::to_string(i);
    if (name.front() == '/') {
      if (open.empty() || open.back() != name.substr(1)) return "closes " + name + " at " + std::to_string(i);
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    i = end;
  }
  return open.empty() ? "" : "never closed: " + open.back();
}

inline std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at_ = text.find(part); at_ != std::string_view::npos; at_ = text.find(part, at_ + 1))
    ++count;
  return count;
}

}  // namespace kerf::report_test
