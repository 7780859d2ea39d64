#include "report/json_lines.hpp"

#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "report/alarm_text.hpp"
#include "report/number_text.hpp"

namespace kerf {
namespace {

std::string_view mode_word(MoveMode mode) {
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
  return "";
}

std::string_view direction_word(SpindleDirection direction) {
  switch (direction) {
    case SpindleDirection::off:
      return "off";
    case SpindleDirection::clockwise:
      return "cw";
    case SpindleDirection::counterclockwise:
      return "ccw";
    case SpindleDirection::orient:
      return "orient";
  }
  return "";
}

/// Ends an event that has nothing after its line number.
void close_with_line(const Origin& origin, std::string& out) {
  out += ",\"line\":";
  append_integer(out, origin.span.line);
  out += '}';
}

void write_arc(const Move& move, std::string& out) {
  const char first = letter(move.plane.first);
  const char second = letter(move.plane.second);
  out += ",\"plane\":\"";
  out += first;
  out += second;
  out += "\",\"center\":{\"";
  out += first;
  out += "\":";
  append_number(out, move.arc.center[0]);
  out += ",\"";
  out += second;
  out += "\":";
  append_number(out, move.arc.center[1]);
  out += "},\"radius\":";
  append_number(out, move.arc.radius);
  out += ",\"sweep\":";
  append_number(out, move.arc.sweep);
}

/// What makes the positions of the axes a figure on the work.
void write_polar(const PolarPlane& polar, std::string& out) {
  out += ",\"polar\":{\"linear\":\"";
  out += letter(polar.linear);
  out += "\",\"rotary\":\"";
  out += letter(polar.rotary);
  out += "\",\"center\":";
  append_number(out, polar.center);
  out += ",\"zero\":";
  append_number(out, polar.zero);
  out += '}';
}

void write_event(const Origin& origin, const Dwell& dwell, std::string& out) {
  out += "{\"event\":\"dwell\",\"seconds\":";
  append_number(out, dwell.seconds);
  close_with_line(origin, out);
}

void append_arguments(const CodeArguments& arguments, std::string& out) {
  if (arguments.given == 0) return;
  char separator = '{';
  out += ",\"args\":";
  for (std::size_t i = 0; i < CodeArguments::kMost; ++i) {
    if ((arguments.given >> i & 1U) == 0) continue;
    out += separator;
    out += '"';
    out += static_cast<char>('A' + i);
    out += "\":";
    append_number(out, arguments.values[i]);
    separator = ',';
  }
  out += '}';
}

/// Of most M codes there is nothing to say.
void append_timing(OutputTiming timing, std::string& out) {
  if (timing == OutputTiming::immediate) out += ",\"timing\":\"immediate\"";
  if (timing == OutputTiming::with_next_move) out += ",\"timing\":\"with-next-move\"";
}

void write_event(const Origin& origin, const Auxiliary& auxiliary, std::string& out) {
  out += "{\"event\":\"m\",\"codes\":[";
  append_integer(out, auxiliary.code);
  out += ']';
  append_arguments(auxiliary.arguments, out);
  append_timing(auxiliary.timing, out);
  close_with_line(origin, out);
}

void write_event(const Origin& origin, const Spindle& spindle, std::string& out) {
  out += "{\"event\":\"spindle\",\"direction\":\"";
  out += direction_word(spindle.direction);
  out += "\",\"rpm\":";
  append_number(out, spindle.rpm);
  if (spindle.direction == SpindleDirection::orient) {
    out += ",\"angle\":";
    append_number(out, spindle.angle);
  }
  append_arguments(spindle.arguments, out);
  append_timing(spindle.timing, out);
  close_with_line(origin, out);
}

void write_event(const Origin& origin, const ToolChange& change, std::string& out) {
  out += "{\"event\":\"tool\",\"number\":";
  append_integer(out, change.number);
  close_with_line(origin, out);
}

void write_event(const Origin& origin, const Stop& stop, std::string& out) {
  out += "{\"event\":\"stop\",\"optional\":";
  out += stop.optional ? "true" : "false";
  close_with_line(origin, out);
}

void write_event(const Origin& origin, const End&, std::string& out) {
  out += "{\"event\":\"end\"";
  close_with_line(origin, out);
}

void write_event(const Origin& origin, const Alarm& alarm, std::string& out) {
  append_alarm_json(out, alarm, origin.program);
}

}  // namespace

JsonLines::JsonLines(const Machine& machine, EffectiveFeed feed)
    : axes_(machine.axes), feed_(std::move(feed)) {}

void JsonLines::write(const Action& action, std::string& out) const {
  if (std::holds_alternative<CornerArc>(action.what)) return;
  std::visit(
      [&](const auto& event) {
        using Event = std::decay_t<decltype(event)>;
        if constexpr (std::is_same_v<Event, Move>) {
          write_move(action.origin, event, out);
        } else if constexpr (!std::is_same_v<Event, CornerArc>) {
          write_event(action.origin, event, out);
        }
      },
      action.what);
  out += '\n';
}

void JsonLines::write_move(const Origin& origin, const Move& move, std::string& out) const {
  out += "{\"event\":\"move\",\"mode\":\"";
  out += mode_word(move.mode);
  out += '"';
  if (origin.program >= 0) {
    out += ",\"program\":";
    append_integer(out, origin.program);
  }
  out += ",\"line\":";
  append_integer(out, origin.span.line);
  if (origin.sequence_number >= 0) {
    out += ",\"n\":";
    append_integer(out, origin.sequence_number);
  }
  out += ",\"start\":{";
  write_axes(move.start, out);
  out += "},\"end\":{";
  write_axes(move.end, out);
  out += "},\"commanded\":{";
  write_axes(move.commanded, out);
  out += "},\"feed\":";
  if (move.mode == MoveMode::rapid) {
    out += "null";
  } else {
    append_number(out, feed_ ? feed_(move) : move.feed);
  }
  if (is_arc(move.mode)) write_arc(move, out);
  if (move.polar.form == PolarForm::axes) write_polar(move.polar, out);
  if (move.spindle_turns != 0.0) {
    out += ",\"spindle_turns\":";
    append_number(out, move.spindle_turns);
  }
  out += '}';
}

void JsonLines::write_axes(const AxisVector& position, std::string& out) const {
  bool first = true;
  for (const Axis axis : axes_) {
    if (!first) out += ',';
    first = false;
    out += '"';
    out += letter(axis);
    out += "\":";
    append_number(out, position[axis]);
  }
}

}  // namespace kerf
