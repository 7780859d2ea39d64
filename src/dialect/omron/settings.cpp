#include "dialect/omron/settings.hpp"

#include <charconv>
#include <limits>
#include <optional>

#include "machine/key_check.hpp"

namespace kerf::omron {
namespace {

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

OperationSettings normal_operation(const Settings& settings) {
  OperationSettings normal;
  normal.maximum_feedrate = settings.number("omron.maximum_feedrate");
  normal.rotary_velocity = settings.number("omron.rotary_axis_velocity");
  normal.ramps = {settings.number("omron.acceleration_time"), settings.number("omron.deceleration_time"),
                  settings.number("omron.jerk_time")};
  return normal;
}

OperationSettings extended_operation(const Settings& settings, const OperationSettings& normal,
                                     std::size_t set) {
  OperationSettings own = normal;
  const auto take = [&](std::string_view key, double& value, double least) {
    const double number = settings.number(extended_key(key, set));
    if (number >= least) value = number;
  };
  constexpr double kGiven = std::numeric_limits<double>::min();
  take("omron.extended_#.maximum_feedrate", own.maximum_feedrate, kGiven);
  take("omron.extended_#.rotary_axis_velocity", own.rotary_velocity, kGiven);
  take("omron.extended_#.acceleration_time", own.ramps.acceleration, 0.0);
  take("omron.extended_#.deceleration_time", own.ramps.deceleration, 0.0);
  take("omron.extended_#.jerk_time", own.ramps.jerk, 0.0);
  return own;
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
  c.normal = normal_operation(settings);
  for (std::size_t set = 0; set < kExtendedSets; ++set)
    c.extended[set] = extended_operation(settings, c.normal, set);
  c.has_spindle_axis = settings.boolean("omron.spindle_axis");
  c.spindle_maximum = settings.number("omron.spindle_maximum_speed");
  c.orientation_velocity = settings.number("omron.spindle_orientation_velocity");
  c.orientation_angle = settings.number("omron.spindle_orientation_position");
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
