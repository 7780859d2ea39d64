#include "machine/contradictions.hpp"

#include <fmt/format.h>
#include <string>

namespace kerf {
namespace {

SettingsError at(const Setting& setting, std::string message, std::string remedy) {
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

void check_start(const Settings& settings, Axis axis, std::vector<SettingsError>& errors) {
  const Setting* start = settings.find(expanded("axes.*.start", axis));
  const Setting* limits = settings.find(expanded("axes.*.limits", axis));
  if (!start || !limits) return;
  const double position = settings.number(start->key);
  const auto [low, high] = settings.pair(limits->key);
  if (position >= low && position <= high) return;
  const Setting& to_blame = start->is_explicit() ? *start : *limits;
  errors.push_back(at(to_blame,
                      fmt::format("'{}' = {} lies outside '{}' = {}", start->key, toml_text(start->value),
                                  limits->key, toml_text(limits->value)),
                      fmt::format("give '{}' a value within the limits", start->key)));
}

void check_servo_number(const Settings& settings, Axis axis, std::vector<SettingsError>& errors) {
  const Setting* setting = settings.find(expanded("axes.*.number", axis));
  if (!setting || !setting->is_explicit()) return;
  for (const Axis other : settings.axes()) {
    if (other >= axis) return;
    const Setting* earlier = settings.find(expanded("axes.*.number", other));
    if (earlier->value != setting->value) continue;
    errors.push_back(
        at(*setting,
           fmt::format("'{}' and '{}' are both {}", setting->key, earlier->key, toml_text(setting->value)),
           "each axis has a servo number of its own"));
    return;
  }
}

}  // namespace

std::vector<SettingsError> contradictions(const Settings& settings, AxisSet skipped) {
  std::vector<SettingsError> errors;
  if (settings.axes().empty()) {
    errors.push_back({{}, 0, 0, "the machine has no axis", "give at least one [axes.X] table"});
  }
  for (const Axis axis : settings.axes()) {
    if (skipped.contains(axis)) continue;
    check_start(settings, axis, errors);
    check_servo_number(settings, axis, errors);
  }
  return errors;
}

}  // namespace kerf
