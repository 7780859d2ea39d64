#include "motion/junction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {
namespace {

/// Square of the acceleration that every axis has in every direction of the plane spanned by the unit vectors
/// along difference and sum of the two directions: the projection of axis i on that plane has the length
/// sqrt(d_i2 + s_i2).
double plane_acceleration_squared(const AxisVector& from, const AxisVector& to, double difference_squared,
                                  const AxisLimits& limits) {
  double sum_squared = 0.0;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const double sum = to.values[i] + from.values[i];
    sum_squared += sum * sum;
  }
  const double inverse_difference = 1.0 / difference_squared;
  const double inverse_sum = sum_squared > 1e-20 ? 1.0 / sum_squared : 0.0;
  double need = 0.0;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const double difference = to.values[i] - from.values[i];
    const double sum = to.values[i] + from.values[i];
    const double share = difference * difference * inverse_difference + sum * sum * inverse_sum;
    const double inverse = limits.inverse_acceleration.values[i];
    need = std::max(need, share * inverse * inverse);
  }
  return need > 0.0 ? 1.0 / need : std::numeric_limits<double>::max();
}

}  // namespace

double junction_speed_squared(const AxisVector& from, const AxisVector& to, double mean_length,
                              double deviation, const AxisLimits& limits) {
  double difference_squared = 0.0;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const double difference = to.values[i] - from.values[i];
    difference_squared += difference * difference;
  }
  if (difference_squared < 1e-24) return std::numeric_limits<double>::infinity();
  // |to - from| = 2 sin(t / 2); computed from the difference, small angles keep their digits.
  const double sine_squared = std::min(1.0, 0.25 * difference_squared);
  const double turn = 2.0 * std::asin(std::sqrt(sine_squared));
  const double acceleration = std::sqrt(plane_acceleration_squared(from, to, difference_squared, limits));
  const double chord_limit = acceleration * mean_length / turn;
  if (deviation <= 0.0) return turn > kTangentTurn ? 0.0 : chord_limit;
  // sin(h) = cos(t / 2), and 1 / (1 - sin h) = (1 + sin h) / sin2(t / 2).
  const double sin_h = std::sqrt(1.0 - sine_squared);
  const double deviation_limit = acceleration * deviation * sin_h * (1.0 + sin_h) / sine_squared;
  return std::min(chord_limit, deviation_limit);
}

}  // namespace kerf
