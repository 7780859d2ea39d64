#include "dialect/omron/settings.hpp"

#include <charconv>
#include <optional>

#include "machine/key_check.hpp"

namespace kerf::omron {
namespace {

constexpr std::string_view kCoordinateSystem = "CNC coordinate system";
constexpr std::string_view kDefaults = "NC program default settings";
constexpr std::string_view kSpindle = "Spindle";
constexpr std::string_view kMCodeGroup = "M codes";
constexpr std::string_view kInputs = "Signals";
constexpr std::string_view kMotor = "CNC motor";

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

constexpr std::string_view kNotShared[] = {"offsets.EXT.*"};

constexpr DefaultOverride kDefaultMachine[] = {
    {"axes.X.number", "1"},     {"axes.Y.number", "2"},         {"axes.Z.number", "3"},
    {"axes.A.number", "4"},     {"axes.B.number", "5"},         {"axes.C.number", "6"},
    {"axes.*.rapid", "6000.0"}, {"axes.*.max_feed", "10000.0"},
};

std::optional<int> read_number(const char*& at, const char* end) {
  int value = 0;
  const auto [behind, error] = std::from_chars(at, end, value);
  if (error != std::errc()) return std::nullopt;
  at = behind;
  return value;
}

void set_timing(ControllerSettings& settings, std::string_view list, OutputTiming timing) {
  for (const int code : numbers_in(list, 0, kMCodes - 1).value_or(std::vector<int>{}))
    settings.timing[static_cast<std::size_t>(code)] = timing;
}

SkipInput skip_input(const Settings& settings, Axis axis) {
  SkipInput input;
  input.position = settings.number(expanded("omron.axis.*.skip_position", axis));
  input.seconds = settings.number(expanded("omron.axis.*.skip_time", axis));
  const std::string_view word = settings.text(expanded("omron.axis.*.skip_input", axis));
  if (word == "position") input.source = SkipInput::Source::position;
  if (word == "time") input.source = SkipInput::Source::time;
  if (const std::optional<Axis> other = axis_of(word)) {
    input.source = SkipInput::Source::shared;
    input.axis = *other;
  }
  return input;
}

}  // namespace

std::optional<std::vector<int>> numbers_in(std::string_view list, int least, int greatest) {
  std::vector<int> numbers;
  const char* at = list.data();
  const char* const end = at + list.size();
  for (;;) {
    while (at < end && (*at == ' ' || *at == ',')) ++at;
    if (at == end) return numbers;
    const std::optional<int> first = read_number(at, end);
    std::optional<int> last = first;
    if (at < end && *at == '-') last = read_number(++at, end);
    if (!first || !last || *first < least || *last > greatest || *first > *last) return std::nullopt;
    for (int i = *first; i <= *last; ++i) numbers.push_back(i);
  }
}

std::span<const Parameter> parameters() {
  return kParameters;
}

std::span<const std::string_view> keys_not_shared() {
  return kNotShared;
}

std::span<const DefaultOverride> default_machine() {
  return kDefaultMachine;
}

ControllerSettings controller_settings(const Settings& settings, const Machine& machine) {
  ControllerSettings c;
  c.version_1_02 = settings.text("omron.cnc_version") == "1.02";
  c.inch = settings.text("omron.command_unit") == "inch";
  c.maximum_feedrate = settings.number("omron.maximum_feedrate");
  c.rotary_velocity = settings.number("omron.rotary_axis_velocity");
  c.acceleration_time = settings.number("omron.acceleration_time");
  c.deceleration_time = settings.number("omron.deceleration_time");
  c.jerk_time = settings.number("omron.jerk_time");
  c.has_spindle_axis = settings.boolean("omron.spindle_axis");
  c.spindle_maximum = settings.number("omron.spindle_maximum_speed");
  c.orientation_velocity = settings.number("omron.spindle_orientation_velocity");
  c.tool_m_code = static_cast<std::int32_t>(settings.integer("omron.tool_m_code"));
  c.tool = static_cast<std::int32_t>(settings.integer("omron.tool"));
  c.optional_stop = settings.boolean("omron.optional_stop");
  for (const int skip : numbers_in(settings.text("omron.block_skip"), 1, 31).value_or(std::vector<int>{}))
    c.skips.set(static_cast<std::size_t>(skip));
  if (settings.boolean("omron.all_block_skips")) c.skips.set();
  set_timing(c, settings.text("omron.immediate_m_codes"), OutputTiming::immediate);
  set_timing(c, settings.text("omron.not_waiting_m_codes"), OutputTiming::with_next_move);
  constexpr std::array<std::string_view, kReferencePoints> kKeys{
      "omron.axis.*.reference_2", "omron.axis.*.reference_3", "omron.axis.*.reference_4"};
  for (const Axis axis : machine.axes) {
    c.skip_inputs[index(axis)] = skip_input(settings, axis);
    for (std::size_t i = 0; i < kKeys.size(); ++i)
      c.references[i][axis] = settings.number(expanded(kKeys[i], axis));
  }
  return c;
}

}  // namespace kerf::omron
