#pragma once
// The machine as plain numbers, from settings.

#include <tl/expected.hpp>
#include <vector>

#include "machine/machine.hpp"
#include "machine/settings.hpp"
#include "machine/settings_error.hpp"

namespace kerf {

/// The machine of the settings when all files and options are applied. Errors: contradictions(settings).
/// The schema's common keys are common_parameters().
tl::expected<Machine, std::vector<SettingsError>> build_machine(const Settings& settings);

}  // namespace kerf
