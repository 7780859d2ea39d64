#include "geometry/segment_distance.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

/// Whether the ray from the centre through a point meets the arc.
bool is_beside(const PlanarSegment& arc, Vec2 point) {
  const double turn = ahead_deg(arc.start - arc.center, point - arc.center, arc.sweep_deg < 0.0);
  return (turn < 0.0 ? turn + 360.0 : turn) <= std::abs(arc.sweep_deg);
}

bool is_point(const PlanarSegment& segment) {
  return !segment.is_arc && segment.start == segment.end;
}

/// Whether a point of the endless line or the whole circle belongs to the segment.
bool reaches(const PlanarSegment& segment, Vec2 point) {
  if (segment.is_arc) return is_beside(segment, point);
  const Vec2 way = segment.end - segment.start;
  const double at = dot(point - segment.start, way);
  return at >= 0.0 && at <= dot(way, way);
}

/// The least distance that points inside of `a` may have from an arc: those on the line through its centre
/// that is at right angles to `a`.
double nearest_inside(const PlanarSegment& a, const PlanarSegment& arc, double nearest) {
  const auto try_point = [&](Vec2 point) {
    if (reaches(a, point)) nearest = std::min(nearest, distance_to(arc, point));
  };
  if (!a.is_arc) {
    try_point(foot_on(line_through(a.start, a.end), arc.center));
  } else if (const Vec2 axis = unit(arc.center - a.center); axis != Vec2{}) {
    try_point(a.center + a.radius * axis);
    try_point(a.center - a.radius * axis);
  }
  return nearest;
}

}  // namespace

Meeting meeting_of_curves(const PlanarSegment& first, const PlanarSegment& next) {
  const auto line = [](const PlanarSegment& s) { return line_through(s.start, s.end); };
  const auto circle = [](const PlanarSegment& s) { return PlanarCircle{s.center, s.radius}; };
  if (first.is_arc && next.is_arc) return meeting_of(circle(first), circle(next));
  if (first.is_arc) return meeting_of(circle(first), line(next));
  if (next.is_arc) return meeting_of(line(first), circle(next));
  return meeting_of(line(first), line(next));
}

double distance_to(const PlanarSegment& segment, Vec2 point) {
  const double to_ends = std::min(distance(point, segment.start), distance(point, segment.end));
  if (segment.is_arc) {
    if (!is_beside(segment, point)) return to_ends;
    return std::min(to_ends, std::abs(distance(point, segment.center) - segment.radius));
  }
  if (is_point(segment) || !reaches(segment, point)) return to_ends;
  return std::abs(cross(unit(segment.end - segment.start), point - segment.start));
}

double distance_between(const PlanarSegment& a, const PlanarSegment& b) {
  double nearest = std::min(
      {distance_to(a, b.start), distance_to(a, b.end), distance_to(b, a.start), distance_to(b, a.end)});
  if (is_point(a) || is_point(b)) return nearest;
  for (const Vec2 point : meeting_of_curves(a, b).points) {
    if (reaches(a, point) && reaches(b, point)) return 0.0;
  }
  if (b.is_arc) nearest = nearest_inside(a, b, nearest);
  if (a.is_arc) nearest = nearest_inside(b, a, nearest);
  return nearest;
}

}  // namespace kerf
