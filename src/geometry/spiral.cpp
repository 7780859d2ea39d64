#include "geometry/spiral.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {

bool is_spiral(double start_radius, double end_radius) {
  constexpr double kOutOfRound = 1e-3;
  return std::abs(end_radius - start_radius) > kOutOfRound * std::min(start_radius, end_radius);
}

double way_of_arc(double start_radius, double end_radius, double angle) {
  if (!is_spiral(start_radius, end_radius) || angle <= 0.0) return 0.5 * (start_radius + end_radius) * angle;
  return way_after({start_radius, (end_radius - start_radius) / angle}, angle);
}

double way_after(const Spiral& spiral, double angle) {
  const double k = spiral.growth;
  const auto integral = [k](double r) {
    return 0.5 * (r * std::hypot(r, k) / k + k * std::asinh(r / std::abs(k)));
  };
  return integral(radius_after(spiral, angle)) - integral(spiral.radius);
}

double angle_after(const Spiral& spiral, double way, double whole) {
  constexpr int kMostSteps = 8;
  constexpr double kExact = 1e-15;
  const double r = spiral.radius;
  const double k = spiral.growth;
  // As if the way were r d angle: exact for small growth.
  double angle = 2.0 * way / (r + std::sqrt(std::max(r * r + 2.0 * k * way, 0.0)));
  for (int i = 0; i < kMostSteps; ++i) {
    angle = std::clamp(angle, 0.0, whole);
    const double step = (way_after(spiral, angle) - way) / std::hypot(radius_after(spiral, angle), k);
    angle -= step;
    if (std::abs(step) <= kExact * whole) break;
  }
  return std::clamp(angle, 0.0, whole);
}

}  // namespace kerf
