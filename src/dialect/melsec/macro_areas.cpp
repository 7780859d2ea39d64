// Where the macro variables live: 0016H, and 2221H for devices that are not the controller's own.

#include <array>
#include <fmt/format.h>

#include "dialect/melsec/configuration_check.hpp"
#include "dialect/melsec/word_device.hpp"

namespace kerf::melsec {
namespace {

constexpr std::int64_t kMostPoints = 900;
constexpr std::int64_t kWordsOfVariable = 4;
constexpr std::int64_t kLocalPoints = 165;  // #1 to #33 on five levels
constexpr std::string_view kAllPoints = "melsec.system.common_all_points";
constexpr std::string_view kSystemPoints = "melsec.system.common_system_points";

/// One block of variables.
struct Variables {
  std::string_view start_key;
  std::string_view points_key;  ///< empty: the local variables, whose number is fixed
};

constexpr std::array<Variables, 3> kVariables{{
    {"melsec.system.common_all_start_device", kAllPoints},
    {"melsec.system.common_system_start_device", kSystemPoints},
    {"melsec.system.local_start_device", {}},
}};

void check_total(ConfigurationCheck& check) {
  const std::int64_t total = check.settings().integer(kAllPoints) + check.settings().integer(kSystemPoints);
  if (total <= kMostPoints) return;
  check.refuse("0016H", {kAllPoints, kSystemPoints},
               fmt::format("{} and {} are {} points together, and there are {}", check.stated(kAllPoints),
                           check.stated(kSystemPoints), total, kMostPoints),
               fmt::format("lower '{}' or '{}'", kAllPoints, kSystemPoints));
}

/// Complains about a start device that is none.
void refuse_device(ConfigurationCheck& check, std::string_view key, DeviceFault fault) {
  const std::string what = check.stated(key);
  if (fault == DeviceFault::no_word_device) {
    check.refuse(
        "0016H", {key}, fmt::format("{} is no word device", what),
        fmt::format("set '{}' to a device such as D2000, W100, #100, U3E1\\G1000 or U3E1\\HG100", key));
  } else {
    check.refuse_device(
        "2221H", key,
        fmt::format("{} is the memory of {}", what,
                    fault == DeviceFault::other_cpu ? "another CPU" : "a module"),
        fmt::format("set '{}' to a device of the controller, such as D2000 or U3E1\\G1000", key));
  }
}

/// The devices that a block of variables takes; none when it has no variables or a complaint is made.
std::optional<DeviceArea> area_of(ConfigurationCheck& check, const Variables& variables) {
  const std::string& start = check.settings().text(variables.start_key);
  const bool local = variables.points_key.empty();
  const std::int64_t points = local ? kLocalPoints : check.settings().integer(variables.points_key);
  if (start.empty()) {
    if (!local && points > 0) {
      check.refuse("0016H", {variables.points_key},
                   fmt::format("{}, and the variables have no devices", check.stated(variables.points_key)),
                   fmt::format("set '{}', for example to \"D2000\"", variables.start_key));
    }
    return std::nullopt;
  }
  const auto device = word_device(start);
  if (!device) {
    refuse_device(check, variables.start_key, device.error());
    return std::nullopt;
  }
  const DeviceArea area{*device, points * kWordsOfVariable};
  if (device->number % 2 != 0) {
    check.refuse("0016H", {variables.start_key},
                 fmt::format("{} is an odd device number", check.stated(variables.start_key)),
                 fmt::format("set '{}' to an even one", variables.start_key));
  }
  if (!area.exists()) {
    const std::string last = device_text({device->kind, last_number(device->kind)});
    check.refuse("0016H", {variables.start_key},
                 fmt::format("{}: the {} words of the variables go beyond {}",
                             check.stated(variables.start_key), area.words, last),
                 fmt::format("set '{}' to a lower device", variables.start_key));
  }
  return area.words > 0 ? std::optional(area) : std::nullopt;
}

std::string area_text(std::string_view key, const DeviceArea& area) {
  return fmt::format("'{}' takes {} to {}", key, device_text(area.first),
                     device_text({area.first.kind, area.last()}));
}

}  // namespace

void check_macro_areas(ConfigurationCheck& check) {
  check_total(check);
  std::array<std::optional<DeviceArea>, kVariables.size()> areas;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    areas[i] = area_of(check, kVariables[i]);
    for (std::size_t k = 0; k < i; ++k) {
      if (!areas[i] || !areas[k] || !overlap(*areas[i], *areas[k])) continue;
      const std::string_view key = kVariables[i].start_key;
      check.refuse(
          "0016H", {key, kVariables[k].start_key},
          fmt::format("{}, and {}", area_text(key, *areas[i]), area_text(kVariables[k].start_key, *areas[k])),
          fmt::format("move '{}' to other devices", key));
    }
  }
}

}  // namespace kerf::melsec
