#include "geometry/planar_segment.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

Vec2 tangent_at(const PlanarSegment& segment, Vec2 point) {
  if (!segment.is_arc) return unit(segment.end - segment.start);
  const Vec2 left = left_of(unit(point - segment.center));
  return segment.sweep_deg < 0.0 ? -left : left;
}

}  // namespace

PlanarSegment straight(Vec2 start, Vec2 end) {
  return {start, end, false, {}, 0.0, 0.0};
}

PlanarSegment curved(Vec2 start, Vec2 end, Vec2 center, double radius, double sweep_deg) {
  return {start, end, true, center, radius, sweep_deg};
}

Vec2 start_tangent(const PlanarSegment& segment) {
  return tangent_at(segment, segment.start);
}

Vec2 end_tangent(const PlanarSegment& segment) {
  return tangent_at(segment, segment.end);
}

double length_of(const PlanarSegment& segment) {
  if (!segment.is_arc) return distance(segment.start, segment.end);
  return segment.radius * radians(std::abs(segment.sweep_deg));
}

double offset_radius(const PlanarSegment& arc, double left_mm) {
  // The centre of a counterclockwise arc lies on the left.
  return arc.sweep_deg < 0.0 ? arc.radius + left_mm : arc.radius - left_mm;
}

PlanarSegment offset_segment(const PlanarSegment& segment, double left_mm) {
  const Vec2 begins = start_tangent(segment);
  return offset_segment(segment, left_mm, begins, segment.is_arc ? end_tangent(segment) : begins);
}

PlanarSegment offset_segment(const PlanarSegment& segment, double left_mm, Vec2 begins, Vec2 ends) {
  PlanarSegment moved = segment;
  moved.start += left_mm * left_of(begins);
  moved.end += left_mm * left_of(ends);
  if (segment.is_arc) moved.radius = std::max(0.0, offset_radius(segment, left_mm));
  return moved;
}

}  // namespace kerf
