#include "dialect/melsec/configuration.hpp"

#include <array>
#include <fmt/format.h>
#include <initializer_list>
#include <optional>
#include <string>

#include "dialect/melsec/configuration_check.hpp"

namespace kerf::melsec {
namespace {

constexpr std::string_view kBaseKeys[] = {"melsec.system.base_axis_i", "melsec.system.base_axis_j",
                                          "melsec.system.base_axis_k"};
constexpr std::string_view kNormalLine = "melsec.system.normal_line_axis";
constexpr std::string_view kTurnSpeed = "melsec.system.normal_line_rotating_speed";
constexpr std::string_view kPolarLinear = "melsec.system.polar_linear_axis";
constexpr std::string_view kPolarRotary = "melsec.system.polar_rotary_axis";
constexpr std::string_view kMaxSpeed = "melsec.system.pre_accel_max_speed";
constexpr std::string_view kMaster = "melsec.axis.*.master_axis_name";
constexpr std::string_view kTurning = "melsec.axis.*.rotation_axis_type";

/// The base axis key that names the axis; empty: none does.
std::string_view base_key_of(const ConfigurationCheck& check, Axis axis) {
  for (const std::string_view key : kBaseKeys) {
    if (check.axis_named(key) == axis) return key;
  }
  return {};
}

void check_axis_count(ConfigurationCheck& check) {
  constexpr int kMostAxes = 8;
  const int count = check.settings().axes().size();
  if (count <= kMostAxes) return;
  check.refuse({}, {}, fmt::format("the machine has {} axes, and a line has at most {}", count, kMostAxes),
               "leave out an [axes] table");
}

void check_base_axes(ConfigurationCheck& check) {
  for (std::size_t i = 0; i < std::size(kBaseKeys); ++i) {
    const auto axis = check.axis_named(kBaseKeys[i]);
    if (!axis) continue;
    if (!check.on_line(*axis)) {
      check.refuse(
          "0010H", {kBaseKeys[i]},
          fmt::format("{}, and the machine has no axis {}", check.stated(kBaseKeys[i]), letter(*axis)),
          fmt::format("set '{}' to an axis of the machine or to \"none\", or add a table [axes.{}]",
                      kBaseKeys[i], letter(*axis)));
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (check.axis_named(kBaseKeys[k]) != axis) continue;
      check.refuse("0010H", {kBaseKeys[i], kBaseKeys[k]},
                   fmt::format("'{}' and '{}' are both {}", kBaseKeys[i], kBaseKeys[k], letter(*axis)),
                   fmt::format("set '{}' to another axis or to \"none\"", kBaseKeys[i]));
    }
  }
}

void check_normal_line_name(ConfigurationCheck& check) {
  const auto axis = check.axis_named(kNormalLine);
  if (!axis || check.on_line(*axis)) return;
  check.refuse("0011H", {kNormalLine},
               fmt::format("{}, and the machine has no axis {}", check.stated(kNormalLine), letter(*axis)),
               fmt::format("set '{}' to a rotary axis of the machine or to \"none\"", kNormalLine));
}

void check_normal_line_axis(ConfigurationCheck& check) {
  const auto axis = check.axis_named(kNormalLine);
  if (!axis || !check.on_line(*axis)) return;
  if (!check.rotary(*axis)) {
    check.refuse("0012H", {kNormalLine, check.key("axes.*.type", *axis)},
                 fmt::format("{}, and {} is a linear axis", check.stated(kNormalLine), letter(*axis)),
                 fmt::format("set '{}' to a rotary axis", kNormalLine));
  }
  if (const std::string_view base = base_key_of(check, *axis); !base.empty()) {
    check.refuse("0012H", {kNormalLine, base},
                 fmt::format("'{}' and '{}' are both {}", kNormalLine, base, letter(*axis)),
                 fmt::format("set '{}' to an axis that is no base axis", kNormalLine));
  }
  const std::string clamp = check.key("axes.*.max_feed", *axis);
  if (check.settings().number(kTurnSpeed) > check.settings().number(clamp)) {
    check.refuse("0012H", {kTurnSpeed, clamp, kNormalLine},
                 fmt::format("{} is above {}", check.stated(kTurnSpeed), check.stated(clamp)),
                 fmt::format("lower '{}'", kTurnSpeed));
  }
}

void check_polar_names(ConfigurationCheck& check) {
  const auto linear = check.axis_named(kPolarLinear);
  const auto rotary = check.axis_named(kPolarRotary);
  if (linear.has_value() != rotary.has_value()) {
    const std::string_view open = linear ? kPolarRotary : kPolarLinear;
    check.refuse("0013H", {linear ? kPolarLinear : kPolarRotary},
                 fmt::format("{} alone is set", check.stated(linear ? kPolarLinear : kPolarRotary)),
                 fmt::format("set '{}' as well, or both to \"none\"", open));
  }
  for (const std::string_view key : {kPolarLinear, kPolarRotary}) {
    const auto axis = check.axis_named(key);
    if (!axis || check.on_line(*axis)) continue;
    check.refuse("0013H", {key},
                 fmt::format("{}, and the machine has no axis {}", check.stated(key), letter(*axis)),
                 fmt::format("set '{}' to an axis of the machine", key));
  }
}

void check_polar_linear(ConfigurationCheck& check) {
  const auto axis = check.axis_named(kPolarLinear);
  if (!axis || !check.on_line(*axis)) return;
  if (check.rotary(*axis)) {
    check.refuse("0014H", {kPolarLinear, check.key("axes.*.type", *axis)},
                 fmt::format("{}, and {} is a rotary axis", check.stated(kPolarLinear), letter(*axis)),
                 fmt::format("set '{}' to a linear axis", kPolarLinear));
  }
  if (base_key_of(check, *axis).empty()) {
    check.refuse(
        "0014H", {kPolarLinear, kBaseKeys[0], kBaseKeys[1], kBaseKeys[2]},
        fmt::format("{}, and {} is no base axis", check.stated(kPolarLinear), letter(*axis)),
        fmt::format("set '{}' to a base axis, or '{}' to {}", kPolarLinear, kBaseKeys[0], letter(*axis)));
  }
}

void check_polar_rotary(ConfigurationCheck& check) {
  const auto axis = check.axis_named(kPolarRotary);
  if (!axis || !check.on_line(*axis)) return;
  if (!check.rotary(*axis)) {
    check.refuse("0014H", {kPolarRotary, check.key("axes.*.type", *axis)},
                 fmt::format("{}, and {} is a linear axis", check.stated(kPolarRotary), letter(*axis)),
                 fmt::format("set '{}' to a rotary axis", kPolarRotary));
  }
  const auto refuse_double = [&](std::string_view other) {
    check.refuse("0014H", {kPolarRotary, other},
                 fmt::format("'{}' and '{}' are both {}", kPolarRotary, other, letter(*axis)),
                 fmt::format("set '{}' to a rotary axis that is used for nothing else", kPolarRotary));
  };
  if (const std::string_view base = base_key_of(check, *axis); !base.empty()) refuse_double(base);
  if (check.axis_named(kNormalLine) == axis) refuse_double(kNormalLine);
}

constexpr double kFastestPlanned = 999'999.0;  // mm/min, the most that pre_accel_max_speed can be

/// One complaint for all axes: about the fastest of them, since that decides.
void check_high_accuracy(ConfigurationCheck& check) {
  std::string fastest;
  double speed = check.settings().number(kMaxSpeed);
  for (const Axis axis : check.settings().axes()) {
    for (const std::string_view key :
         {"axes.*.max_feed", "melsec.axis.*.high_accuracy_cutting_clamp_speed"}) {
      const std::string own = check.key(key, axis);
      if (check.settings().number(own) <= speed) continue;
      speed = check.settings().number(own);
      fastest = own;
    }
  }
  if (fastest.empty()) return;
  check.refuse("0015H", {kMaxSpeed, fastest},
               fmt::format("{} is below {}", check.stated(kMaxSpeed), check.stated(fastest)),
               speed <= kFastestPlanned
                   ? fmt::format("raise '{}' to {} or more, up to 999999", kMaxSpeed, toml_text(Value(speed)))
                   : fmt::format("lower '{}' to 999999 or less, and raise '{}' to it", fastest, kMaxSpeed));
}

/// Duties that a slave axis cannot have beside its master.
void check_slave(ConfigurationCheck& check, Axis slave, std::string_view own_key) {
  std::vector<std::string_view> duties;
  if (const std::string_view base = base_key_of(check, slave); !base.empty()) duties.push_back(base);
  for (const std::string_view key : {kNormalLine, kPolarLinear, kPolarRotary}) {
    if (check.axis_named(key) == slave) duties.push_back(key);
  }
  for (const std::string_view duty : duties) {
    check.refuse("0023H", {own_key, duty},
                 fmt::format("{}, and {} itself is '{}'", check.stated(own_key), letter(slave), duty),
                 fmt::format("set '{}' to \"none\", or '{}' to another axis", own_key, duty));
  }
  if (slave < Axis::U) {
    check.refuse("0023H", {own_key},
                 fmt::format("{}, and only U, V and W can follow another axis", check.stated(own_key)),
                 fmt::format("set '{}' to \"none\", or name the slave axis U, V or W", own_key));
  }
}

void check_master(ConfigurationCheck& check, Axis slave, Axis master, std::string_view own_key) {
  const auto refuse = [&](std::string_view other, std::string why, std::string remedy) {
    check.refuse("0023H", {own_key, other}, fmt::format("{}, and {}", check.stated(own_key), why),
                 std::move(remedy));
  };
  if (!check.on_line(master)) {
    refuse(own_key, fmt::format("the machine has no axis {}", letter(master)),
           fmt::format("set '{}' to an axis of the machine or to \"none\"", own_key));
    return;
  }
  const std::string of_master = check.key(kMaster, master);
  if (const auto next = check.axis_named(of_master)) {
    refuse(of_master, fmt::format("{} follows {} itself", letter(master), letter(*next)),
           fmt::format("set '{}' to an axis that follows no other", own_key));
  }
  const bool same_type = check.rotary(master) == check.rotary(slave);
  if (!same_type) {
    const std::string type = check.key("axes.*.type", slave);
    refuse(type, fmt::format("one of {} and {} is linear, the other rotary", letter(slave), letter(master)),
           fmt::format("set '{}' as for {}", type, letter(master)));
  }
  const std::string turning = check.key(kTurning, slave);
  const std::string master_turning = check.key(kTurning, master);
  if (same_type && check.rotary(slave) &&
      check.settings().text(turning) != check.settings().text(master_turning)) {
    refuse(turning, fmt::format("{}, but {}", check.stated(turning), check.stated(master_turning)),
           fmt::format("set '{}' as for {}", turning, letter(master)));
  }
}

void check_tandem(ConfigurationCheck& check) {
  for (const Axis slave : check.settings().axes()) {
    const std::string key = check.key(kMaster, slave);
    const auto master = check.axis_named(key);
    if (!master) continue;
    check_slave(check, slave, key);
    check_master(check, slave, *master, key);
  }
}

/// Whether the axis turns without end, so that its software limits mean nothing.
bool turns(const Settings& settings, Axis axis) {
  return settings.text(expanded("axes.*.type", axis)) == "rotary" &&
         settings.text(expanded(kTurning, axis)) != "linear";
}

void check_limits(ConfigurationCheck& check) {
  for (const Axis axis : check.settings().axes()) {
    const std::string key = check.key("axes.*.limits", axis);
    const auto [low, high] = check.settings().pair(key);
    const std::string turning = check.key(kTurning, axis);
    // Limits in the wrong order and equal ones of a linear axis are wrong for every dialect.
    if (low < high && turns(check.settings(), axis)) {
      check.refuse("0024H", {key, turning, check.key("axes.*.type", axis)},
                   fmt::format("{}, and {} turns without end: {}", check.stated(key), letter(axis),
                               check.stated(turning)),
                   fmt::format("set '{}' to [0.0, 0.0], or '{}' to \"linear\"", key, turning));
    }
    if (low == high && check.rotary(axis) && !turns(check.settings(), axis)) {
      check.refuse("0024H", {key, turning},
                   fmt::format("{}: the low value is not below the high value, and {}", check.stated(key),
                               check.stated(turning)),
                   fmt::format("write '{}' = [low, high]", key));
    }
  }
}

}  // namespace

std::vector<SettingsError> contradictions(const Settings& settings) {
  constexpr void (*kChecks[])(ConfigurationCheck&) = {
      check_axis_count,  check_base_axes,    check_normal_line_name, check_normal_line_axis,
      check_polar_names, check_polar_linear, check_polar_rotary,     check_high_accuracy,
      check_macro_areas, check_tandem,       check_limits,
  };
  ConfigurationCheck check(settings);
  for (const auto& find_errors : kChecks) find_errors(check);
  return check.take_errors();
}

void complete_limits(Settings& settings) {
  constexpr std::array<double, 2> kWholeRange{-9999.9999, 9999.9999};
  for (const Axis axis : settings.axes()) {
    const std::string key = expanded("axes.*.limits", axis);
    if (settings.find(key)->is_explicit()) continue;
    settings.assign(key, turns(settings, axis) ? std::array{0.0, 0.0} : kWholeRange, ValueOrigin{});
  }
}

}  // namespace kerf::melsec
