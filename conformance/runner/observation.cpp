#include "conformance/runner/observation.hpp"

#include <cmath>
#include <string>

namespace kerf::conformance {
namespace {

constexpr double kNoLength = 1e-9;  // mm or degrees

std::string_view mode_name(MoveMode mode) {
  switch (mode) {
    case MoveMode::rapid:
      return "rapid";
    case MoveMode::linear:
      return "linear";
    case MoveMode::clockwise:
      return "cw";
    case MoveMode::counterclockwise:
      return "ccw";
  }
  return {};
}

std::string plane_name(const Plane& plane) {
  return {letter(plane.first), letter(plane.second)};
}

void add_axes(Entry& event, std::string_view prefix, AxisSet axes, const AxisVector& position) {
  for (const Axis axis : axes) event.fields.push_back({std::string(prefix) + letter(axis), position[axis]});
}

void add_arc(Entry& event, const Move& move, const AxisVector& origin) {
  const Plane& plane = move.plane;
  event.fields.push_back({"plane", plane_name(plane)});
  event.fields.push_back({"radius", move.arc.radius});
  event.fields.push_back({"sweep", move.arc.sweep});
  const std::string center = "center";
  event.fields.push_back({center + letter(plane.first), move.arc.center[0] - origin[plane.first]});
  event.fields.push_back({center + letter(plane.second), move.arc.center[1] - origin[plane.second]});
}

bool has_length(const Move& move, AxisSet axes) {
  if (is_arc(move.mode) && std::abs(move.arc.sweep) > kNoLength) return true;
  for (const Axis axis : axes) {
    if (std::abs(move.end[axis] - move.start[axis]) > kNoLength) return true;
  }
  return false;
}

/// Fills in the event of one kind of action. False: there is none.
struct Describe {
  Entry& event;
  const Surroundings& around;

  bool operator()(const Move& move) const {
    const AxisSet axes = around.axes;
    event.name = mode_name(move.mode);
    add_axes(event, "", axes, move.end - around.work_origin);
    if (move.mode != MoveMode::rapid) event.fields.push_back({"F", around.policy.effective(move.feed)});
    if (is_arc(move.mode)) add_arc(event, move, around.work_origin);
    event.fields.push_back({"turns", move.spindle_turns});
    add_axes(event, "m", axes, move.end);
    add_axes(event, "c", axes, move.commanded);
    add_axes(event, "s", axes, move.start - around.work_origin);
    return has_length(move, axes);
  }
  bool operator()(const CornerArc&) const { return false; }
  bool operator()(const Dwell& dwell) const {
    event.name = "dwell";
    event.fields.push_back({"s", dwell.seconds});
    return true;
  }
  bool operator()(const Auxiliary& auxiliary) const {
    event.name = "m";
    event.words.push_back(std::to_string(auxiliary.code));
    add_terms(auxiliary.timing, auxiliary.arguments);
    return true;
  }
  void add_terms(OutputTiming timing, const CodeArguments& arguments) const {
    for (std::size_t i = 0; i < CodeArguments::kMost; ++i) {
      if ((arguments.given >> i & 1U) == 0) continue;
      event.fields.push_back({std::string(1, static_cast<char>('A' + i)), arguments.values[i]});
    }
    constexpr std::array kTimings{"synchronous", "immediate", "with-next-move"};
    event.fields.push_back({"timing", std::string(kTimings[static_cast<std::size_t>(timing)])});
  }
  bool operator()(const Spindle& spindle) const {
    event.name = "spindle";
    switch (spindle.direction) {
      case SpindleDirection::off:
        event.words.emplace_back("off");
        break;
      case SpindleDirection::clockwise:
        event.words.emplace_back("cw");
        break;
      case SpindleDirection::counterclockwise:
        event.words.emplace_back("ccw");
        break;
      case SpindleDirection::orient:
        event.words.emplace_back("orient");
        break;
    }
    if (spindle.direction != SpindleDirection::off) event.fields.push_back({"rpm", spindle.rpm});
    if (spindle.direction == SpindleDirection::orient) event.fields.push_back({"angle", spindle.angle});
    add_terms(spindle.timing, spindle.arguments);
    return true;
  }
  bool operator()(const ToolChange& change) const {
    event.name = "tool";
    event.words.push_back(std::to_string(change.number));
    return true;
  }
  bool operator()(const Stop& stop) const {
    event.name = "stop";
    if (stop.optional) event.words.emplace_back("optional");
    return true;
  }
  bool operator()(const End&) const {
    event.name = "end";
    return true;
  }
  bool operator()(const Alarm& alarm) const {
    event.name = stops_program(alarm) ? "alarm" : "warning";
    event.words.emplace_back(alarm.kind->detail);
    return true;
  }
};

}  // namespace

std::optional<Entry> event_of(const Action& action, const Surroundings& surroundings) {
  Entry event;
  if (!std::visit(Describe{event, surroundings}, action.what)) return std::nullopt;
  const auto* alarm = std::get_if<Alarm>(&action.what);
  const SourceSpan& span = alarm != nullptr ? alarm->span : action.origin.span;
  event.fields.push_back({"line", static_cast<double>(span.line)});
  if (alarm != nullptr) event.fields.push_back({"column", static_cast<double>(span.column)});
  if (action.origin.program >= 0) {
    event.fields.push_back({"program", static_cast<double>(action.origin.program)});
  }
  if (action.origin.sequence_number >= 0) {
    event.fields.push_back({"n", static_cast<double>(action.origin.sequence_number)});
  }
  return event;
}

}  // namespace kerf::conformance
