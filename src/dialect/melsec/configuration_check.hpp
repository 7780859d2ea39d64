#pragma once
// What the checks of configuration.cpp share: reading settings, and complaints with details code and place.

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/axis.hpp"
#include "machine/settings.hpp"
#include "machine/settings_error.hpp"

namespace kerf::melsec {

class ConfigurationCheck {
 public:
  explicit ConfigurationCheck(const Settings& settings) : settings_(settings) {}

  const Settings& settings() const { return settings_; }
  bool on_line(Axis axis) const { return settings_.axes().contains(axis); }
  bool rotary(Axis axis) const { return settings_.text(key("axes.*.type", axis)) == "rotary"; }
  std::string key(std::string_view pattern, Axis axis) const { return expanded(pattern, axis); }
  /// The axis that a key names; none for "none".
  std::optional<Axis> axis_named(std::string_view key) const { return axis_of(settings_.text(key)); }
  /// `'axes.X.max_feed' = 2000.0`
  std::string stated(std::string_view key) const;

  /// Adds a complaint, where the first of the keys stands that was set; without a details code for what the
  /// manual has none for.
  void refuse(std::string_view detail, std::initializer_list<std::string_view> keys, std::string message,
              std::string remedy);
  /// The same for an alarm that is not in the catalogue of details codes.
  void refuse_device(std::string_view code, std::string_view key, std::string message, std::string remedy);

  std::vector<SettingsError> take_errors() { return std::move(errors_); }

 private:
  const Settings& settings_;
  std::vector<SettingsError> errors_;
};

/// The device areas of the macro variables (0016H), in macro_areas.cpp.
void check_macro_areas(ConfigurationCheck& check);

}  // namespace kerf::melsec
