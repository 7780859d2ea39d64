#include "machine/contradictions.hpp"

#include <fmt/format.h>
#include <string>

namespace kerf {
namespace {

/// The complaint about a key that every dialect shares, under the controller's own code where it has one. It
/// stands where `to_blame` was set.
SettingsError shared_error(const Settings& settings, const Setting& setting, const Setting& to_blame,
                           std::string message, std::string remedy) {
  SettingsError error = error_at(to_blame, std::move(message), std::move(remedy));
  if (const AlarmKind* kind = alarm_of(settings.schema(), *setting.parameter)) name_alarm(error, *kind);
  return error;
}

/// Whether the limits of the axis bound anything. Equal ones, of a rotary axis, stand for none.
bool check_limits(const Settings& settings, Axis axis, std::vector<SettingsError>& errors) {
  const Setting* limits = settings.find(expanded("axes.*.limits", axis));
  if (!limits) return false;
  const auto [low, high] = settings.pair(limits->key);
  if (low < high) return true;
  const bool rotary = settings.text(expanded("axes.*.type", axis)) == "rotary";
  if ((low == high && rotary) || !limits->is_explicit()) return false;
  errors.push_back(shared_error(settings, *limits, *limits,
                                fmt::format("'{}' = {}: the low value is not below the high value",
                                            limits->key, toml_text(limits->value)),
                                "write [low, high]"));
  return false;
}

/// A position of the axis, `axes.*.start` for example, that lies outside its limits.
void check_inside(const Settings& settings, std::string_view key, Axis axis,
                  std::vector<SettingsError>& errors) {
  const Setting* inside = settings.find(expanded(key, axis));
  const Setting* limits = settings.find(expanded("axes.*.limits", axis));
  if (!inside) return;
  const double position = settings.number(inside->key);
  const auto [low, high] = settings.pair(limits->key);
  if (position >= low && position <= high) return;
  const Setting& to_blame = inside->is_explicit() ? *inside : *limits;
  errors.push_back(shared_error(settings, *inside, to_blame,
                                fmt::format("'{}' = {} lies outside '{}' = {}", inside->key,
                                            toml_text(inside->value), limits->key, toml_text(limits->value)),
                                fmt::format("give '{}' a value within the limits", inside->key)));
}

/// A reference point left at its default may lie outside: nobody who does not use it need set it.
void check_home(const Settings& settings, Axis axis, std::vector<SettingsError>& errors) {
  const Setting* home = settings.find(expanded("axes.*.home", axis));
  if (home && home->is_explicit()) check_inside(settings, "axes.*.home", axis, errors);
}

void check_servo_number(const Settings& settings, Axis axis, std::vector<SettingsError>& errors) {
  const Setting* setting = settings.find(expanded("axes.*.number", axis));
  if (!setting || !setting->is_explicit()) return;
  for (const Axis other : settings.axes()) {
    if (other >= axis) return;
    const Setting* earlier = settings.find(expanded("axes.*.number", other));
    if (earlier->value != setting->value) continue;
    errors.push_back(shared_error(
        settings, *setting, *setting,
        fmt::format("'{}' and '{}' are both {}", setting->key, earlier->key, toml_text(setting->value)),
        "each axis has a servo number of its own"));
    return;
  }
}

}  // namespace

SettingsError error_at(const Setting& setting, std::string message, std::string remedy) {
  switch (setting.origin.kind) {
    case ValueOrigin::Kind::file:
      return {setting.origin.file, setting.origin.line, setting.origin.column, std::move(message),
              std::move(remedy)};
    case ValueOrigin::Kind::assignment:
      return {"--set " + setting.key, 0, 0, std::move(message), std::move(remedy)};
    case ValueOrigin::Kind::preset:
      break;
  }
  return {{}, 0, 0, std::move(message), std::move(remedy)};
}

std::vector<SettingsError> contradictions(const Settings& settings, AxisSet skipped) {
  std::vector<SettingsError> errors;
  if (settings.axes().empty()) {
    errors.push_back({{}, 0, 0, "the machine has no axis", "give at least one [axes.X] table"});
  }
  for (const Axis axis : settings.axes()) {
    if (skipped.contains(axis)) continue;
    if (check_limits(settings, axis, errors)) {
      check_inside(settings, "axes.*.start", axis, errors);
      check_home(settings, axis, errors);
    }
    check_servo_number(settings, axis, errors);
  }
  return errors;
}

std::optional<SettingsError> wrong_order(const Settings& settings, std::string_view low_key,
                                         std::string_view high_key) {
  if (settings.number(low_key) <= settings.number(high_key)) return std::nullopt;
  const Setting& low = *settings.find(low_key);
  const Setting& high = *settings.find(high_key);
  return error_at(low.is_explicit() ? low : high,
                  fmt::format("'{}' = {} is above '{}' = {}", low_key, toml_text(low.value), high_key,
                              toml_text(high.value)),
                  "raise the higher or lower the lower one");
}

}  // namespace kerf
