#include "report/action_text.hpp"

#include <fmt/format.h>

#include "report/alarm_text.hpp"
#include "report/number_text.hpp"

namespace kerf {
namespace {

std::string arguments_text(const CodeArguments& arguments) {
  std::string text;
  for (std::size_t i = 0; i < CodeArguments::kMost; ++i) {
    if ((arguments.given >> i & 1U) == 0) continue;
    text += fmt::format(" {}{}", static_cast<char>('A' + i), rounded_text(arguments.values[i], 4));
  }
  return text;
}

std::string spindle_text(const Spindle& spindle) {
  switch (spindle.direction) {
    case SpindleDirection::off:
      return "spindle off";
    case SpindleDirection::orient:
      return "spindle orient " + rounded_text(spindle.angle, 3) + " deg";
    case SpindleDirection::clockwise:
      return "spindle cw " + rounded_text(spindle.rpm, 3) + " rpm";
    case SpindleDirection::counterclockwise:
      return "spindle ccw " + rounded_text(spindle.rpm, 3) + " rpm";
  }
  return {};
}

struct Describer {
  std::string operator()(const Move& move) const {
    switch (move.mode) {
      case MoveMode::rapid:
        return "rapid";
      case MoveMode::linear:
        return "line";
      case MoveMode::clockwise:
        return "arc cw";
      case MoveMode::counterclockwise:
        return "arc ccw";
    }
    return {};
  }
  std::string operator()(const CornerArc&) const { return "corner arc"; }
  std::string operator()(const Dwell& dwell) const {
    return "dwell " + rounded_text(dwell.seconds, 3) + " s";
  }
  std::string operator()(const Auxiliary& auxiliary) const {
    return fmt::format("M{}", auxiliary.code) + arguments_text(auxiliary.arguments);
  }
  std::string operator()(const Spindle& spindle) const {
    return spindle_text(spindle) + arguments_text(spindle.arguments);
  }
  std::string operator()(const ToolChange& change) const {
    return change.number == 0 ? "tool put back" : fmt::format("tool {}", change.number);
  }
  std::string operator()(const Stop& stop) const { return stop.optional ? "optional stop" : "stop"; }
  std::string operator()(const End&) const { return "end"; }
  std::string operator()(const Alarm& alarm) const {
    return fmt::format("{} {}", severity_word(alarm.kind->severity), short_name(*alarm.kind));
  }
};

}  // namespace

std::string describe(const ActionVariant& what) {
  return std::visit(Describer{}, what);
}

}  // namespace kerf
