#include "machine/settings_error.hpp"

#include <fmt/format.h>

namespace kerf {

void name_alarm(SettingsError& error, const AlarmKind& kind) {
  error.alarm = kind.detail;
  error.message = fmt::format("{}/{} {}: {}", kind.code, kind.detail, kind.name, error.message);
}

std::string error_text(const SettingsError& error) {
  std::string text = error.file;
  if (error.line != 0) text += fmt::format(":{}:{}", error.line, error.column);
  if (!text.empty()) text += ": ";
  text += error.message;
  if (!error.remedy.empty()) text += "; " + error.remedy;
  return text;
}

}  // namespace kerf
