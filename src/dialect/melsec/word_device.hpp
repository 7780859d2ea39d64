#pragma once
// The word devices that hold macro variables, as the start device parameters name them: D2000, W1FFE, #100,
// U3E1\G1000, U3E1\HG100.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace kerf::melsec {

enum class DeviceKind : std::uint8_t { data_register, link_register, motion_register, buffer, fixed_buffer };

struct WordDevice {
  DeviceKind kind = DeviceKind::data_register;
  std::int64_t number = 0;
};

enum class DeviceFault : std::uint8_t {
  no_word_device,  ///< another device, or none at all
  other_cpu,       ///< the memory of another CPU; the controller is CPU No. 2, U3E1
  module,          ///< the memory of a module, U0\G100
};

/// W and the module numbers are hexadecimal, all others decimal.
tl::expected<WordDevice, DeviceFault> word_device(std::string_view text);

/// The highest number of its kind.
std::int64_t last_number(DeviceKind kind);

/// The device as it is written.
std::string device_text(const WordDevice& device);

/// Devices in a row.
struct DeviceArea {
  WordDevice first;
  std::int64_t words = 0;

  std::int64_t last() const { return first.number + words - 1; }
  bool exists() const { return last() <= last_number(first.kind); }
};

bool overlap(const DeviceArea& a, const DeviceArea& b);

}  // namespace kerf::melsec
