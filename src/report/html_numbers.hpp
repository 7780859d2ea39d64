#pragma once
// Numbers for the script of the HTML report: integers of a fixed unit, as differences.

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "report/number_text.hpp"

namespace kerf {

inline constexpr double kPerMm = 1000.0;  ///< counts in a millimetre or degree
inline constexpr double kPerSecond = 10'000.0;
inline constexpr double kPerFeed = 10.0;  ///< counts in a mm/min

inline std::int64_t counts_of(double value, double unit) {
  const double counts = value * unit;
  return std::abs(counts) < 9e15 ? std::llround(counts) : 0;
}

/// A JSON array of integers, each the difference from the one before.
class Differences {
 public:
  void add(std::int64_t value) {
    if (!text_.empty()) text_ += ',';
    append_integer(text_, value - last_);
    last_ = value;
  }
  void append_to(std::string& out, std::string_view key) const {
    out += '"';
    out += key;
    out += "\":[";
    out += text_;
    out += ']';
  }

 private:
  std::string text_;
  std::int64_t last_ = 0;
};

}  // namespace kerf
