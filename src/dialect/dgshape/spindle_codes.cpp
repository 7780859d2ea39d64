#include "dialect/dgshape/spindle_codes.hpp"

#include <array>
#include <cassert>

namespace kerf::dgshape {

double spindle_code_rpm(int code) {
  assert(code >= 1 && code <= 98);
  // Hundredths of rpm of codes 0 to 19 and powers of ten for the decades, so that every speed is the printed
  // one.
  constexpr std::array<int, 20> kHundredths{100, 112, 125, 140, 160, 180, 200, 224, 250, 280,
                                            315, 355, 400, 450, 500, 560, 630, 710, 800, 900};
  constexpr std::array<double, 5> kDecades{1.0, 10.0, 100.0, 1000.0, 10000.0};
  const auto step = static_cast<std::size_t>(code % 20);
  const auto decade = static_cast<std::size_t>(code / 20);
  return kHundredths[step] * kDecades[decade] / 100.0;
}

}  // namespace kerf::dgshape
