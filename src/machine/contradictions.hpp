#pragma once
// Settings that are right each by itself but not together.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/axis.hpp"
#include "machine/settings.hpp"
#include "machine/settings_error.hpp"

namespace kerf {

/// Every relation that does not hold, at the place where one of its values was set: an axis whose lower limit
/// is not below its upper one (equal limits of a rotary axis stand for none), that starts outside them or has
/// a reference point set there, two axes with one servo number, a machine without axes. Nothing is said about
/// the axes in `skipped`.
std::vector<SettingsError> contradictions(const Settings& settings, AxisSet skipped = {});

/// A complaint at the place where the setting was made; without a place for a default.
SettingsError error_at(const Setting& setting, std::string message, std::string remedy);

/// The complaint that the value of `low_key` is above that of `high_key`, both numbers; none when it is not.
std::optional<SettingsError> wrong_order(const Settings& settings, std::string_view low_key,
                                         std::string_view high_key);

}  // namespace kerf
