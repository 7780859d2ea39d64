// The keys of the [omron] section.

#include <string>
#include <vector>

#include "dialect/omron/settings.hpp"

namespace kerf::omron {
namespace {

constexpr std::string_view kCoordinateSystem = "CNC coordinate system";
constexpr std::string_view kDefaults = "NC program default settings";
constexpr std::string_view kSpindle = "Spindle";
constexpr std::string_view kMCodeGroup = "M codes";
constexpr std::string_view kInputs = "Signals";
constexpr std::string_view kMotor = "CNC motor";
constexpr std::string_view kExtended = "Extended operation settings (G500 and G501 with P)";

constexpr Parameter number(std::string_view group, std::string_view key, std::string_view default_value,
                           std::string_view unit, double low, double high, std::string_view help) {
  return {.key = key,
          .type = ValueType::number,
          .default_value = default_value,
          .unit = unit,
          .minimum = low,
          .maximum = high,
          .help = help,
          .group = group};
}

constexpr Parameter integer(std::string_view group, std::string_view key, std::string_view default_value,
                            double low, double high, std::string_view help) {
  Parameter parameter = number(group, key, default_value, "", low, high, help);
  parameter.type = ValueType::integer;
  return parameter;
}

constexpr Parameter text(std::string_view group, std::string_view key, std::string_view help) {
  return {.key = key, .type = ValueType::text, .default_value = "\"\"", .help = help, .group = group};
}

constexpr double kFar = 1e9;

constexpr Parameter kParameters[] = {
    Parameter{.key = "omron.cnc_version",
              .type = ValueType::word,
              .default_value = "\"1.02\"",
              .choices = "1.01|1.02",
              .help = "CNC version: 1.01 stands for that and all before, 1.02 for that and all behind.",
              .group = kCoordinateSystem},
    Parameter{.key = "omron.command_unit",
              .type = ValueType::word,
              .default_value = "\"mm\"",
              .choices = "mm|inch",
              .help = "Unit of lengths in programs until G20 or G21.",
              .group = kCoordinateSystem},
    number(kCoordinateSystem, "omron.maximum_feedrate", "10000.0", "mm/min", 0.0, 1e12,
           "Highest F of a program."),
    number(kCoordinateSystem, "omron.rotary_axis_velocity", "3600.0", "degree/min", 0.0, 1e12,
           "Speed of A, B and C in cutting moves."),
    number(kDefaults, "omron.acceleration_time", "100.0", "ms", 0, 250000,
           "Acceleration time until a program has ta."),
    number(kDefaults, "omron.deceleration_time", "100.0", "ms", 0, 250000,
           "Deceleration time until a program has td."),
    number(kDefaults, "omron.jerk_time", "0.0", "ms", 0, 125000, "Jerk time until a program has ts."),
    Parameter{.key = "omron.spindle_axis",
              .type = ValueType::boolean,
              .default_value = "true",
              .help = "Whether the spindle is an axis of the coordinate system: tapping turns it with Z.",
              .group = kSpindle},
    number(kSpindle, "omron.spindle_maximum_speed", "10000.0", "r/min", 0, 1e6, "Highest S of a program."),
    number(kSpindle, "omron.spindle_orientation_velocity", "100.0", "r/min", 0, 1e6, "Speed of M19."),
    number(kSpindle, "omron.spindle_orientation_position", "0.0", "degree", 0, 360,
           "Angle at which M19 stops the spindle."),
    text(kMCodeGroup, "omron.immediate_m_codes",
         "M codes of output timing 1, on when the block is interpreted: \"8 20-25\"."),
    text(kMCodeGroup, "omron.not_waiting_m_codes",
         "M codes of output timing 2, on when the next move begins; all others have timing 0."),
    integer(kMCodeGroup, "omron.tool_m_code", "100", -1, 191,
            "M code whose argument VA is the number of the tool selected, as the PLC would do it; -1: none."),
    integer(kMCodeGroup, "omron.tool", "0", 0, 9999, "Tool selected when the program starts; 0: none."),
    Parameter{.key = "omron.optional_stop",
              .type = ValueType::boolean,
              .default_value = "false",
              .help = "Whether the optional stop input is on: M01 stops.",
              .group = kInputs},
    Parameter{.key = "omron.overcut_operation_mode",
              .type = ValueType::word,
              .default_value = "\"detection\"",
              .choices = "detection|prevention",
              .help = "What becomes of blocks in which the tool would cut into the contour: an alarm, or "
                      "they are left out.",
              .group = kCoordinateSystem},
    Parameter{.key = "omron.compensated_feed",
              .type = ValueType::word,
              .default_value = "\"center\"",
              .choices = "center|edge",
              .help = "What F counts for on arcs under G41 and G42: the centre of the tool or its edge.",
              .group = kCoordinateSystem},
    text(kInputs, "omron.block_skip", "Optional skip signals that are on: \"1 3 5-7\"."),
    Parameter{.key = "omron.all_block_skips",
              .type = ValueType::boolean,
              .default_value = "false",
              .help = "Whether all optional skip signals are on.",
              .group = kInputs},
    number(kMotor, "omron.axis.*.reference_2", "0.0", "mm", -kFar, kFar,
           "Machine coordinate of the 2nd reference point (G30)."),
    number(kMotor, "omron.axis.*.reference_3", "0.0", "mm", -kFar, kFar,
           "The same of the 3rd reference point."),
    number(kMotor, "omron.axis.*.reference_4", "0.0", "mm", -kFar, kFar,
           "The same of the 4th reference point."),
    number(kMotor, "omron.axis.*.rapid_acceleration", "0.0", "mm/s2", 0.0, 1e12,
           "Acceleration of rapid moves; 0: axes.X.acceleration and so on."),
    Parameter{.key = "omron.axis.*.skip_velocity",
              .type = ValueType::number,
              .default_value = "600.0",
              .unit = "mm/min",
              .minimum = 0.0,
              .maximum = 1e12,
              .help = "Speed of the motor in G31.",
              .above_minimum = true,
              .group = kMotor},
    Parameter{.key = "omron.axis.*.skip_input",
              .type = ValueType::word,
              .default_value = "\"none\"",
              .choices = "none|position|time|X|Y|Z|A|B|C",
              .help =
                  "When the simulated skip input of the motor turns on in G31: never, at a position, at a "
                  "time, or with that of another motor.",
              .group = kMotor},
    number(kMotor, "omron.axis.*.skip_position", "0.0", "mm", -kFar, kFar,
           "Machine coordinate at which it turns on, with \"position\"."),
    number(kMotor, "omron.axis.*.skip_time", "0.0", "s", 0.0, kFar,
           "Seconds from the start of the movement until it turns on, with \"time\"."),
};

/// What a parameter set of G500 has in place of the normal settings. `#` in a key is the number of the set.
constexpr Parameter kExtendedParameters[] = {
    number(kExtended, "omron.extended_#.maximum_feedrate", "0.0", "mm/min", 0.0, 1e12,
           "Highest cutting feed; 0 here and below: that of the normal settings."),
    number(kExtended, "omron.extended_#.rotary_axis_velocity", "0.0", "degree/min", 0.0, 1e12,
           "Speed of A, B and C in cutting moves."),
    number(kExtended, "omron.extended_#.acceleration_time", "-1.0", "ms", -1, 250000,
           "Acceleration time; -1 here and below: that of the program default settings."),
    number(kExtended, "omron.extended_#.deceleration_time", "-1.0", "ms", -1, 250000, "Deceleration time."),
    number(kExtended, "omron.extended_#.jerk_time", "-1.0", "ms", -1, 125000, "Jerk time."),
    number(kExtended, "omron.extended_#.axis.*.maximum_acceleration", "0.0", "mm/s2", 0.0, 1e12,
           "Highest acceleration of the motor; 0 here and below: that of the normal settings."),
    number(kExtended, "omron.extended_#.axis.*.rapid", "0.0", "mm/min", 0.0, 1e12,
           "Rapid speed of the motor."),
    number(kExtended, "omron.extended_#.axis.*.rapid_acceleration", "0.0", "mm/s2", 0.0, 1e12,
           "Acceleration of rapid moves."),
};

/// All keys: those above, and the extended ones for each set.
struct Declarations {
  std::vector<std::string> keys;  ///< of the extended ones, which the parameters point to
  std::vector<Parameter> parameters;

  Declarations() : parameters(std::begin(kParameters), std::end(kParameters)) {
    keys.reserve(kExtendedSets * std::size(kExtendedParameters));
    for (std::size_t set = 0; set < kExtendedSets; ++set) {
      for (Parameter parameter : kExtendedParameters) {
        parameter.key = keys.emplace_back(extended_key(parameter.key, set));
        parameters.push_back(parameter);
      }
    }
  }
};

}  // namespace

std::string extended_key(std::string_view key, std::size_t set) {
  std::string expanded(key);
  expanded[expanded.find('#')] = static_cast<char>('0' + set);
  return expanded;
}

std::span<const Parameter> parameters() {
  static const Declarations kDeclarations;
  return kDeclarations.parameters;
}

}  // namespace kerf::omron
