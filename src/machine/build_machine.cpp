#include "machine/build_machine.hpp"

#include <array>
#include <limits>
#include <string_view>

#include "machine/contradictions.hpp"

namespace kerf {
namespace {

AxisSettings axis_settings(const Settings& settings, Axis axis) {
  const auto number = [&](std::string_view key) { return settings.number(expanded(key, axis)); };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> limits = settings.pair(expanded("axes.*.limits", axis));
  if (limits[0] == limits[1]) limits = {-kInfinity, kInfinity};  // the axis turns without end
  const bool rotary = settings.text(expanded("axes.*.type", axis)) == "rotary";
  return {
      .number = static_cast<std::int32_t>(settings.integer(expanded("axes.*.number", axis))),
      .type = rotary ? AxisType::rotary : AxisType::linear,
      .lower_limit = limits[0],
      .upper_limit = limits[1],
      .rapid = number("axes.*.rapid"),
      .max_feed = number("axes.*.max_feed"),
      .acceleration = number("axes.*.acceleration"),
      .jerk = number("axes.*.jerk"),
      .home = number("axes.*.home"),
      .start = number("axes.*.start"),
  };
}

MotionSettings motion_settings(const Settings& settings) {
  return {
      .law = settings.text("motion.law"),
      .junction_deviation = settings.number("motion.junction_deviation"),
      .servo_gain = settings.number("motion.servo_gain"),
      .look_ahead = static_cast<std::int32_t>(settings.integer("motion.look_ahead")),
  };
}

}  // namespace

tl::expected<Machine, std::vector<SettingsError>> build_machine(const Settings& settings) {
  if (auto errors = contradictions(settings); !errors.empty()) return tl::unexpected(std::move(errors));
  constexpr std::array<std::string_view, kWorkOffsetCount> kOffsetKeys{
      "offsets.EXT.*", "offsets.G54.*", "offsets.G55.*", "offsets.G56.*",
      "offsets.G57.*", "offsets.G58.*", "offsets.G59.*"};

  Machine machine;
  machine.name = settings.text("machine.name");
  machine.cycle_s = settings.number("machine.cycle_ms") / 1000.0;
  machine.axes = settings.axes();
  for (const Axis axis : machine.axes) {
    machine.axis[index(axis)] = axis_settings(settings, axis);
    for (std::size_t i = 0; i < kOffsetKeys.size(); ++i) {
      const std::string key = expanded(kOffsetKeys[i], axis);
      // A dialect may lack the external offset.
      if (settings.find(key) != nullptr) machine.work_offsets[i][axis] = settings.number(key);
    }
  }
  for (const std::int32_t number : settings.tool_numbers()) {
    const std::string name = std::to_string(number);
    machine.tools.push_back({number, settings.number(expanded("tools.*.radius", name)),
                             settings.number(expanded("tools.*.length", name))});
  }
  machine.motion = motion_settings(settings);
  return machine;
}

}  // namespace kerf
