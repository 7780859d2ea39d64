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
  return bounds_of(arc, arc.radius);
}

PlanarBox bounds_of(const CircularArc& arc, double end_radius) {
  const Vec2 a = start_of(arc);
  const Vec2 b = arc.center + end_radius * direction_at(arc.start_angle_deg + arc.sweep_deg);
  PlanarBox box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  const double from = std::min(arc.start_angle_deg, arc.start_angle_deg + arc.sweep_deg);
  const double to = std::max(arc.start_angle_deg, arc.start_angle_deg + arc.sweep_deg);
  // How far the curve reaches along an axis of the plane, 0 where it does not cross it.
  const auto reach = [&](double angle_deg) {
    const double crossing = angle_deg + 360.0 * std::ceil((from - angle_deg) / 360.0);
    if (crossing > to) return 0.0;
    const double part = arc.sweep_deg == 0.0 ? 0.0 : (crossing - arc.start_angle_deg) / arc.sweep_deg;
    return arc.radius + (end_radius - arc.radius) * part;
  };
  if (const double r = reach(0.0); r > 0.0) box.high.x = std::max(box.high.x, arc.center.x + r);
  if (const double r = reach(90.0); r > 0.0) box.high.y = std::max(box.high.y, arc.center.y + r);
  if (const double r = reach(180.0); r > 0.0) box.low.x = std::min(box.low.x, arc.center.x - r);
  if (const double r = reach(270.0); r > 0.0) box.low.y = std::min(box.low.y, arc.center.y - r);
  return box;
}

}  // namespace kerf
