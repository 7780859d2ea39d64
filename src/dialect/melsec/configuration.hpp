#pragma once
// The parameters of the machine as a whole: what of chapter 4 does not go together (30FDH, details codes
// 0010H to 0024H), and the limits that follow from the type of an axis.

#include <vector>

#include "machine/settings.hpp"
#include "machine/settings_error.hpp"

namespace kerf::melsec {

/// Every configuration error that one line can have, in the order of the details codes. Two axes with one
/// number (0020H) and limits in the wrong order (0024H) are wrong for every dialect and so are found with the
/// shared keys.
std::vector<SettingsError> contradictions(const Settings& settings);

/// Limits that nobody has set: none for an axis that turns without end, the whole range for any other.
void complete_limits(Settings& settings);

}  // namespace kerf::melsec
