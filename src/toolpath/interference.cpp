#include "toolpath/interference.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kBack = 1e-6;  // mm; a way back that rounding may make

/// How far a segment goes on from one point to another, less than 0 when it runs back. mm
double advance_along(const OffsetSegment& segment, Vec2 from, Vec2 to) {
  const PlanarSegment& programmed = segment.programmed;
  if (!programmed.is_arc) return dot(to - from, start_tangent(programmed));
  const bool turned_over = offset_radius(programmed, segment.left_mm) <= 0.0;
  if (turned_over) return dot(to - from, unit(programmed.end - programmed.start));
  const bool clockwise = programmed.sweep_deg < 0.0;
  const Vec2 center = programmed.center;
  const double left_deg = std::abs(programmed.sweep_deg) -
                          ahead_deg(programmed.start - center, from - center, clockwise) +
                          ahead_deg(programmed.end - center, to - center, clockwise);
  return segment.offset.radius * radians(left_deg);
}

bool runs_back(const OffsetSegment& segment, Vec2 from, Vec2 to) {
  return advance_along(segment, from, to) < -kBack;
}

/// The point of the straight way that is nearest to another point.
Vec2 foot_between(Vec2 from, Vec2 to, Vec2 point) {
  const Vec2 way = to - from;
  const double square = dot(way, way);
  return from + (square > 0.0 ? std::clamp(dot(point - from, way) / square, 0.0, 1.0) : 0.0) * way;
}

double distance_to_way(Vec2 from, Vec2 to, Vec2 point) {
  return distance(point, foot_between(from, to, point));
}

bool is_beside(const PlanarSegment& arc, Vec2 point) {
  const double turn = ahead_deg(arc.start - arc.center, point - arc.center, arc.sweep_deg < 0.0);
  return (turn < 0.0 ? turn + 360.0 : turn) <= std::abs(arc.sweep_deg);
}

/// Keeps the first `count` points.
void keep_first(Corner& corner, std::size_t count) {
  corner.points.resize(count);
}

/// Keeps the last `count` points.
void keep_last(Corner& corner, std::size_t count) {
  const std::size_t dropped = corner.points.size() - count;
  for (std::size_t i = 0; i < count; ++i) corner.points[i] = corner.points[i + dropped];
  corner.points.resize(count);
}

}  // namespace

bool keeps_clear(const OffsetSegment& segment, Vec2 from, Vec2 to) {
  const PlanarSegment& block = segment.programmed;
  const double tool = std::abs(segment.left_mm) - kBack;
  if (distance_to_way(from, to, block.start) < tool || distance_to_way(from, to, block.end) < tool)
    return false;
  const auto too_near = [&](Vec2 point) {
    if (!block.is_arc) return distance_to_way(block.start, block.end, point) < tool;
    return is_beside(block, point) && std::abs(distance(point, block.center) - block.radius) < tool;
  };
  if (too_near(from) || too_near(to)) return false;
  const bool passes_center = distance(from, to) > kBack;
  return !block.is_arc || !passes_center || !too_near(foot_between(from, to, block.center));
}

Interference remove_interference(Corner& begin, const OffsetSegment& segment, Corner& end) {
  std::size_t first = begin.points.size();
  std::size_t last = end.points.size();
  const auto good = [&] {
    if (first == 0 || last == 0) return false;
    const Vec2 from = begin.points[first - 1];
    const Vec2 to = end.points[end.points.size() - last];
    const bool whole = first == begin.points.size() && last == end.points.size();
    return !runs_back(segment, from, to) && (whole || keeps_clear(segment, from, to));
  };
  if (good() || (begin.fixed && end.fixed)) return Interference::none;
  while (first > 0 && last > 0 && !good()) {
    const bool drop_first = !begin.fixed && (first >= last || end.fixed);
    const bool drop_last = !end.fixed && (last >= first || begin.fixed);
    first -= drop_first ? 1 : 0;
    last -= drop_last ? 1 : 0;
  }
  if (first == 0 || last == 0) return Interference::wholly;
  keep_first(begin, first);
  keep_last(end, last);
  return Interference::partly;
}

std::optional<Vec2> avoiding_point(const OffsetSegment& before, Vec2 from, const OffsetSegment& behind) {
  const PlanarSegment first =
      before.programmed.is_arc ? before.offset : offset_segment(before.programmed, before.left_mm);
  const PlanarSegment next =
      behind.programmed.is_arc ? behind.offset : offset_segment(behind.programmed, behind.left_mm);
  const auto point = nearest_point(meeting_of_curves(first, next), before.programmed.end);
  if (!point) return std::nullopt;
  const bool on_first = !runs_back(before, from, *point) && !runs_back(before, *point, before.offset.end);
  const bool on_next =
      !runs_back(behind, behind.offset.start, *point) && !runs_back(behind, *point, behind.offset.end);
  if (!on_first || !on_next) return std::nullopt;
  return point;
}

}  // namespace kerf
