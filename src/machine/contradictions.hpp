#pragma once
// Settings that are right each by itself but not together.

#include <vector>

#include "base/axis.hpp"
#include "machine/settings.hpp"
#include "machine/settings_error.hpp"

namespace kerf {

/// Every relation that does not hold, at the place where one of its values was set: an axis that starts
/// outside its limits, two axes with one servo number, a machine without axes. Nothing is said about the axes
/// in `skipped`.
std::vector<SettingsError> contradictions(const Settings& settings, AxisSet skipped = {});

}  // namespace kerf
