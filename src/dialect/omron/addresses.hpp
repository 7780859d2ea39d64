#pragma once
// The words of the language. Those with names of several letters have an address of one lower-case letter
// inside of kerf (manual 1-5).

#include <string_view>

namespace kerf::omron {

inline constexpr char kAccelerationTime = 'a';  ///< ta
inline constexpr char kDecelerationTime = 'd';  ///< td
inline constexpr char kJerkTime = 's';          ///< ts

/// The addresses of VA to VH, in this order.
inline constexpr std::string_view kArguments = "mnopqrtu";

/// How the address of a word is written.
std::string_view spelling(char address);

}  // namespace kerf::omron
