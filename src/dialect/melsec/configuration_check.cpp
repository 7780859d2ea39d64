#include "dialect/melsec/configuration_check.hpp"

#include <fmt/format.h>

#include "dialect/melsec/alarms.hpp"
#include "machine/contradictions.hpp"

namespace kerf::melsec {

std::string ConfigurationCheck::stated(std::string_view key) const {
  return fmt::format("'{}' = {}", key, printable(toml_text(settings_.find(key)->value)));
}

void ConfigurationCheck::refuse(std::string_view detail, std::initializer_list<std::string_view> keys,
                                std::string message, std::string remedy) {
  const Setting* to_blame = nullptr;
  for (const std::string_view key : keys) {
    const Setting* setting = settings_.find(key);
    if (to_blame == nullptr || (setting->is_explicit() && !to_blame->is_explicit())) to_blame = setting;
  }
  SettingsError error;
  if (to_blame != nullptr) {
    error = error_at(*to_blame, std::move(message), std::move(remedy));
  } else {
    error.message = std::move(message);
    error.remedy = std::move(remedy);
  }
  if (!detail.empty()) name_alarm(error, alarm_kind(detail));
  errors_.push_back(std::move(error));
}

void ConfigurationCheck::refuse_device(std::string_view code, std::string_view key, std::string message,
                                       std::string remedy) {
  refuse({}, {key}, fmt::format("{}: {}", code, message), std::move(remedy));
  errors_.back().alarm = code;
}

}  // namespace kerf::melsec
