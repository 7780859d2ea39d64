#pragma once
// Machine files (TOML) and `--set` options into settings.

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "machine/settings.hpp"
#include "machine/settings_error.hpp"

namespace kerf {

inline constexpr std::size_t kLargestMachineFile = std::size_t{16} * 1024 * 1024;  ///< bytes

/// Applies a machine file. Either the whole file is applied or, when anything in it is wrong, nothing; then
/// all errors are returned in the order of their places (at most 100; text that is no TOML gives the first
/// only).
///
/// A file with any [axes.*] table describes the whole machine: its axes replace all earlier ones. Tools are
/// added. Sections of other dialects are passed over. Any bytes are safe input.
tl::expected<void, std::vector<SettingsError>> apply_toml(Settings& settings, std::string_view text,
                                                          std::string_view file_name);

/// Applies one `--set` option, `axes.X.rapid=8000`. Words and texts need no quotes; a pair is [low,high]. An
/// axis or a tool that does not exist yet is added by any key of its own table. Relations between keys (the
/// start within the limits) are left to build_machine(), when all options are known. Refused options change
/// nothing.
tl::expected<void, SettingsError> apply_assignment(Settings& settings, std::string_view key_equals_value);

/// The dialect a machine file names, and where.
struct NamedDialect {
  std::string name;
  ValueOrigin place;
};

/// The top-level `dialect` of a machine file; none when it is absent, no text, or the file is no TOML
/// (apply_toml tells why).
std::optional<NamedDialect> dialect_of(std::string_view toml_text, std::string_view file_name);

}  // namespace kerf
