#include "execute/polar_plane.hpp"

#include "geometry/polar.hpp"

namespace kerf {
namespace {

Vec2 point_of(const PolarPlane& polar, const AxisVector& position) {
  const double from_center = position[polar.linear] - polar.center;
  if (polar.form == PolarForm::plane) return {from_center, position[polar.rotary]};
  return from_center * direction_at(position[polar.rotary] - polar.zero);
}

void place(const PolarPlane& polar, Vec2 point, AxisVector& position) {
  position[polar.linear] = polar.center + point.x;
  position[polar.rotary] = point.y;
}

}  // namespace

PlanarSegment polar_contour(const Move& move) {
  const PolarPlane& polar = move.polar;
  const double side = polar.minus ? -1.0 : 1.0;
  const Vec2 start = side * point_of(polar, move.start);
  const Vec2 end = side * point_of(polar, move.end);
  if (!is_arc(move.mode)) return straight(start, end);
  const Vec2 center = side * Vec2{move.arc.center[0] - polar.center, move.arc.center[1]};
  return curved(start, end, center, move.arc.radius, move.arc.sweep);
}

AxisVector between(const AxisVector& from, const AxisVector& to, double part) {
  if (part <= 0.0) return from;
  if (part >= 1.0) return to;
  return from + (to - from) * part;
}

PolarReach polar_reach(const Move& move) {
  const PolarPlane& polar = move.polar;
  const PolarRange range = polar_range(polar_contour(move));
  const double near = polar.minus ? -range.greatest_radius : range.least_radius;
  const double far = polar.minus ? -range.least_radius : range.greatest_radius;
  const double from = move.start[polar.rotary];
  return {polar.center + near, polar.center + far, from + range.least_turn_deg,
          from + range.greatest_turn_deg};
}

Move in_polar_plane(const Move& move) {
  Move flat = move;
  flat.polar.form = PolarForm::plane;
  place(move.polar, point_of(move.polar, move.start), flat.start);
  place(move.polar, point_of(move.polar, move.end), flat.end);
  return flat;
}

}  // namespace kerf
