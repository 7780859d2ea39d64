#include "geometry/circular_arc.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {

double ahead_deg(Vec2 from, Vec2 to, bool clockwise) {
  const double turn = clockwise ? -turn_deg(from, to) : turn_deg(from, to);
  return turn <= -180.0 ? turn + 360.0 : turn;
}

CircularArc arc_through(Vec2 start, Vec2 center, double sweep_deg) {
  return {center, distance(center, start), angle_of_deg(start - center), sweep_deg};
}

Vec2 start_of(const CircularArc& arc) {
  return point_on(arc, 0.0);
}

Vec2 end_of(const CircularArc& arc) {
  return point_on(arc, arc.sweep_deg);
}

Vec2 point_on(const CircularArc& arc, double swept_deg) {
  return arc.center + arc.radius * direction_at(arc.start_angle_deg + swept_deg);
}

Vec2 tangent_on(const CircularArc& arc, double swept_deg) {
  const Vec2 outward = direction_at(arc.start_angle_deg + swept_deg);
  return arc.sweep_deg < 0.0 ? -left_of(outward) : left_of(outward);
}

double length_of(const CircularArc& arc) {
  return arc.radius * radians(std::abs(arc.sweep_deg));
}

PlanarBox bounds_of(const CircularArc& arc) {
  const Vec2 a = start_of(arc);
  const Vec2 b = end_of(arc);
  PlanarBox box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  const double from = std::min(arc.start_angle_deg, arc.start_angle_deg + arc.sweep_deg);
  const double to = std::max(arc.start_angle_deg, arc.start_angle_deg + arc.sweep_deg);
  const auto passes = [&](double angle_deg) {
    return angle_deg + 360.0 * std::ceil((from - angle_deg) / 360.0) <= to;
  };
  if (passes(0.0)) box.high.x = arc.center.x + arc.radius;
  if (passes(90.0)) box.high.y = arc.center.y + arc.radius;
  if (passes(180.0)) box.low.x = arc.center.x - arc.radius;
  if (passes(270.0)) box.low.y = arc.center.y - arc.radius;
  return box;
}

}  // namespace kerf
