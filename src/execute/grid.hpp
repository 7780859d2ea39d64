#pragma once
// The grid that computed positions lie on.

namespace kerf {

/// Destinations lie on a grid far finer than any increment, so that sums of increments do not drift apart
/// from the coordinates they stand for. Beyond 2^51 grid steps a double has no finer places anyway.
inline double on_grid(double value) {
  constexpr double kGridPerMm = 1e6;
  constexpr double kLargest = 0x1p51;
  // Adding and taking away 1.5 x 2^52 rounds to the nearest whole number without a call of the library.
  constexpr double kRounder = 0x1.8p52;
  const double steps = value * kGridPerMm;
  if (!(steps < kLargest && steps > -kLargest)) return value;
  return ((steps + kRounder) - kRounder) / kGridPerMm;
}

}  // namespace kerf
