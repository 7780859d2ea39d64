#pragma once
// A small dialect of its own for the tests of the machine file: one key of every type, by table and by axis.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "machine/common_parameters.hpp"
#include "machine/settings.hpp"
#include "machine/settings_error.hpp"
#include "machine/settings_file.hpp"

namespace kerf::machine_test {

inline constexpr std::array kDialectParameters{
    Parameter{.key = "mill.decimal_point",
              .type = ValueType::word,
              .default_value = "\"none\"",
              .choices = "none|all",
              .help = "Which numbers need a decimal point."},
    Parameter{.key = "mill.optional_stop",
              .type = ValueType::boolean,
              .default_value = "false",
              .help = "Whether M01 stops."},
    Parameter{.key = "mill.axis.*.time_constant",
              .type = ValueType::number,
              .default_value = "100.0",
              .unit = "ms",
              .minimum = 1.0,
              .maximum = 4000.0,
              .help = "Acceleration time constant."},
    Parameter{.key = "mill.work.interference_check",
              .type = ValueType::word,
              .default_value = "\"alarm\"",
              .choices = "0=alarm|1=invalid|2=avoid",
              .help = "What happens on interference."},
};

inline constexpr std::array kDefaults{
    DefaultOverride{"dialect", "\"mill\""},     DefaultOverride{"axes.X.rapid", "20000.0"},
    DefaultOverride{"axes.Y.rapid", "15000.0"}, DefaultOverride{"axes.C.max_feed", "7200.0"},
    DefaultOverride{"axes.*.jerk", "8000.0"},   DefaultOverride{"tools.2.radius", "3.0"},
};

inline constexpr std::array<std::string_view, 2> kForeignSections{"lathe", "saw"};

/// Axes X, Y and the rotary C, tool 2.
inline Schema mill() {
  return {common_parameters(), kDialectParameters, kDefaults, kForeignSections};
}

inline Settings mill_settings() {
  return Settings::defaults(mill());
}

/// The errors of a file, each as `error_text` writes it.
inline std::vector<std::string> errors_of(Settings& settings, std::string_view text) {
  std::vector<std::string> errors;
  const auto done = apply_toml(settings, text, "m.toml");
  if (done) return errors;
  for (const SettingsError& error : done.error()) errors.push_back(error_text(error));
  return errors;
}

inline std::vector<std::string> errors_of(std::string_view text) {
  Settings settings = mill_settings();
  return errors_of(settings, text);
}

}  // namespace kerf::machine_test
