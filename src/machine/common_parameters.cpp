#include "machine/common_parameters.hpp"

#include <array>

namespace kerf {
namespace {

/// Farther than any machine travels; wide enough that a test can do without limits.
constexpr double kFar = 1e9;
/// High enough for an ideal machine that follows every program without delay.
constexpr double kFast = 1e12;
/// Largest compensation amount of the MELSEC manual, 6.4 Tool Compensation.
constexpr double kLargestTool = 9999.9999;

constexpr Parameter axis_offset(std::string_view key, std::string_view help) {
  return {.key = key,
          .type = ValueType::number,
          .default_value = "0.0",
          .unit = "mm",
          .minimum = -kFar,
          .maximum = kFar,
          .help = help};
}

constexpr Parameter above_zero(std::string_view key, std::string_view default_value, std::string_view unit,
                               double maximum, std::string_view help) {
  return {.key = key,
          .type = ValueType::number,
          .default_value = default_value,
          .unit = unit,
          .minimum = 0.0,
          .maximum = maximum,
          .help = help,
          .above_minimum = true};
}

constexpr std::array kParameters{
    Parameter{.key = "dialect",
              .type = ValueType::text,
              .default_value = "\"\"",
              .help = "The controller this machine has; the option --dialect overrides it."},

    Parameter{.key = "machine.name",
              .type = ValueType::text,
              .default_value = "\"Machine\"",
              .help = "Name shown in reports."},
    Parameter{.key = "machine.cycle_ms",
              .type = ValueType::number,
              .default_value = "1.0",
              .unit = "ms",
              .minimum = 0.05,
              .maximum = 100.0,
              .help = "Control cycle: the time from one commanded position to the next."},

    Parameter{.key = "axes.*.number",
              .type = ValueType::integer,
              .default_value = "1",
              .minimum = 1,
              .maximum = 64,
              .help = "Servo axis number; left out, the lowest number that no other axis has."},
    Parameter{.key = "axes.*.type",
              .type = ValueType::word,
              .default_value = "\"linear\"",
              .choices = "linear|rotary",
              .help = "Whether the axis moves in mm or turns in degrees."},
    Parameter{.key = "axes.*.limits",
              .type = ValueType::number_pair,
              .default_value = "[-9999.9999, 9999.9999]",
              .unit = "mm",
              .minimum = -kFar,
              .maximum = kFar,
              .help = "Software stroke limits, machine coordinates; a rotary axis with equal ones has none."},
    above_zero("axes.*.rapid", "6000.0", "mm/min", kFast, "Rapid traverse speed."),
    above_zero("axes.*.max_feed", "6000.0", "mm/min", kFast, "Highest speed of the axis while cutting."),
    above_zero("axes.*.acceleration", "500.0", "mm/s2", kFast,
               "Highest acceleration, for laws that plan with it."),
    above_zero("axes.*.jerk", "5000.0", "mm/s3", 1e15, "Highest jerk, for laws that plan with it."),
    axis_offset("axes.*.home", "Machine coordinate of the reference point."),
    axis_offset("axes.*.start", "Machine coordinate where the axis stands when the program starts."),

    axis_offset("offsets.EXT.*", "External offset, added to every work coordinate system."),
    axis_offset("offsets.G54.*", "Work coordinate system 1: its origin in machine coordinates."),
    axis_offset("offsets.G55.*", "Work coordinate system 2."),
    axis_offset("offsets.G56.*", "Work coordinate system 3."),
    axis_offset("offsets.G57.*", "Work coordinate system 4."),
    axis_offset("offsets.G58.*", "Work coordinate system 5."),
    axis_offset("offsets.G59.*", "Work coordinate system 6."),

    Parameter{.key = "tools.*.radius",
              .type = ValueType::number,
              .default_value = "0.0",
              .unit = "mm",
              .minimum = -kLargestTool,
              .maximum = kLargestTool,
              .help = "Tool radius compensation amount."},
    Parameter{.key = "tools.*.length",
              .type = ValueType::number,
              .default_value = "0.0",
              .unit = "mm",
              .minimum = -kLargestTool,
              .maximum = kLargestTool,
              .help = "Tool length compensation amount."},

    Parameter{
        .key = "motion.law",
        .type = ValueType::word,
        .default_value = "\"controller\"",
        .choices = "controller|optimal",
        .help = "How speeds are planned: as the dialect's controller does, or as fast as the axes allow."},
    Parameter{.key = "motion.junction_deviation",
              .type = ValueType::number,
              .default_value = "0.01",
              .unit = "mm",
              .minimum = 0.0,
              .maximum = 10.0,
              .help = "How far the optimal law may treat a corner as rounded; 0 stops at every corner."},
    above_zero("motion.servo_gain", "60.0", "1/s", 10000.0, "Position loop gain of the simulated drives."),
    Parameter{.key = "motion.look_ahead",
              .type = ValueType::integer,
              .default_value = "1024",
              .unit = "blocks",
              .minimum = 16,
              .maximum = 1000000,
              .help = "How many blocks the speed plan looks ahead, at least."},
};

constexpr std::array kDefaults{
    DefaultOverride{"axes.A.type", "\"rotary\""},
    DefaultOverride{"axes.B.type", "\"rotary\""},
    DefaultOverride{"axes.C.type", "\"rotary\""},
};

}  // namespace

std::span<const Parameter> common_parameters() {
  return kParameters;
}

std::span<const DefaultOverride> common_defaults() {
  return kDefaults;
}

}  // namespace kerf
