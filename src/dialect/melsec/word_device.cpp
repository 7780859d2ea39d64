#include "dialect/melsec/word_device.hpp"

#include <array>
#include <charconv>
#include <fmt/format.h>

namespace kerf::melsec {
namespace {

struct DeviceRow {
  std::string_view prefix;
  int base;
  std::int64_t last;
};

// By DeviceKind. How many there are is not in the manual of the G-code control; these are the points of the
// MELSEC iQ-R assignment (decisions.md).
constexpr std::array<DeviceRow, 5> kDevices{{
    {"D", 10, 57343},
    {"W", 16, 0x1FFF},
    {"#", 10, 12287},
    {"U3E1\\G", 10, 2097151},
    {"U3E1\\HG", 10, 12287},
}};

const DeviceRow& row_of(DeviceKind kind) {
  return kDevices[static_cast<std::size_t>(kind)];
}

std::optional<std::int64_t> whole_number(std::string_view text, int base) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  const bool whole = error == std::errc{} && end == text.data() + text.size() && text[0] != '-';
  return whole ? std::optional(number) : std::nullopt;
}

/// Why a device with a module or CPU number in front cannot be used: `U3E0\G100` or `U0\G100`.
DeviceFault fault_of(std::string_view text) {
  const std::size_t slash = text.find('\\');
  if (!text.starts_with('U') || slash == std::string_view::npos) return DeviceFault::no_word_device;
  if (!whole_number(text.substr(1, slash - 1), 16)) return DeviceFault::no_word_device;
  return text.starts_with("U3E") && slash == 4 ? DeviceFault::other_cpu : DeviceFault::module;
}

}  // namespace

tl::expected<WordDevice, DeviceFault> word_device(std::string_view text) {
  for (std::size_t i = 0; i < kDevices.size(); ++i) {
    if (!text.starts_with(kDevices[i].prefix)) continue;
    const auto number = whole_number(text.substr(kDevices[i].prefix.size()), kDevices[i].base);
    if (number) return WordDevice{static_cast<DeviceKind>(i), *number};
  }
  const bool own = text.starts_with("U3E1\\");
  return tl::unexpected(own ? DeviceFault::no_word_device : fault_of(text));
}

std::int64_t last_number(DeviceKind kind) {
  return row_of(kind).last;
}

std::string device_text(const WordDevice& device) {
  const DeviceRow& row = row_of(device.kind);
  return row.base == 16 ? fmt::format("{}{:X}", row.prefix, device.number)
                        : fmt::format("{}{}", row.prefix, device.number);
}

bool overlap(const DeviceArea& a, const DeviceArea& b) {
  return a.first.kind == b.first.kind && a.first.number <= b.last() && b.first.number <= a.last();
}

}  // namespace kerf::melsec
