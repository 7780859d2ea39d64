#include "machine/settings_error.hpp"

#include <fmt/format.h>

namespace kerf {

std::string error_text(const SettingsError& error) {
  std::string text = error.file;
  if (error.line != 0) text += fmt::format(":{}:{}", error.line, error.column);
  if (!text.empty()) text += ": ";
  text += error.message;
  if (!error.remedy.empty()) text += "; " + error.remedy;
  return text;
}

}  // namespace kerf
