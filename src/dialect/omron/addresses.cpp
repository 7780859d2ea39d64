#include "dialect/omron/addresses.hpp"

#include <array>

namespace kerf::omron {

std::string_view spelling(char address) {
  static constexpr std::string_view kCapitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  static constexpr std::array<std::string_view, 8> kArgumentNames{"VA", "VB", "VC", "VD",
                                                                  "VE", "VF", "VG", "VH"};
  if (address >= 'A' && address <= 'Z') return kCapitals.substr(static_cast<std::size_t>(address - 'A'), 1);
  if (address == kAccelerationTime) return "ta";
  if (address == kDecelerationTime) return "td";
  if (address == kJerkTime) return "ts";
  const std::size_t place = kArguments.find(address);
  return place == std::string_view::npos ? std::string_view() : kArgumentNames[place];
}

}  // namespace kerf::omron
