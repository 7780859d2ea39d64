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

Interference remove_interference(Corner& begin, const OffsetSegment& segment, Corner& end) {
  std::size_t first = begin.points.size();
  std::size_t last = end.points.size();
  const auto good = [&] {
    return first > 0 && last > 0 &&
           !runs_back(segment, begin.points[first - 1], end.points[end.points.size() - last]);
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
