#include "toolpath/interference.hpp"

#include <cmath>

#include "geometry/segment_distance.hpp"

namespace kerf {

double advance_along(const OffsetSegment& segment, Vec2 from, Vec2 to) {
  const PlanarSegment& programmed = segment.programmed;
  if (!programmed.is_arc) return dot(to - from, segment.begins);
  const bool turned_over = offset_radius(programmed, segment.left_mm) <= 0.0;
  if (turned_over) return dot(to - from, unit(programmed.end - programmed.start));
  const bool clockwise = programmed.sweep_deg < 0.0;
  // Both are seen alike from the centre; the programmed one may be a mere corner.
  const PlanarSegment& arc = programmed.radius > 0.0 ? programmed : segment.offset;
  const Vec2 center = arc.center;
  const double left_deg = std::abs(arc.sweep_deg) - ahead_deg(arc.start - center, from - center, clockwise) +
                          ahead_deg(arc.end - center, to - center, clockwise);
  return segment.offset.radius * radians(left_deg);
}

namespace {

constexpr double kCut = 5e-4;  // mm; no deeper into a block than this

bool runs_back(const OffsetSegment& segment, Vec2 from, Vec2 to) {
  return advance_along(segment, from, to) < -kBack;
}

/// By how much an arc, as the program rounded it, ends off its circle. mm
double out_of_round(const PlanarSegment& segment) {
  return segment.is_arc ? std::abs(distance(segment.end, segment.center) - segment.radius) : 0.0;
}

/// The other straight segment lies on one side of the line through this one, at least so far away: a
/// sufficient sign of a distance, which takes no root.
bool lies_beyond(const PlanarSegment& line, const PlanarSegment& other, double distance) {
  const Vec2 along = line.end - line.start;
  const double from = cross(along, other.start - line.start);
  const double to = cross(along, other.end - line.start);
  const double least = distance * distance * dot(along, along);
  return least > 0.0 && (from < 0.0) == (to < 0.0) && from * from >= least && to * to >= least;
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

bool keeps_clear(const OffsetSegment& block, const PlanarSegment& way) {
  const double allowed = kCut + out_of_round(block.programmed) + out_of_round(way);
  const double least = std::abs(block.left_mm) - allowed;
  const PlanarSegment& cut = block.programmed;
  if (least <= 0.0) return true;
  if (!cut.is_arc && !way.is_arc && (lies_beyond(cut, way, least) || lies_beyond(way, cut, least)))
    return true;
  return distance_between(way, cut) >= least;
}

Interference remove_interference(Corner& begin, const OffsetSegment& segment, Corner& end,
                                 const Neighbours& neighbours) {
  std::size_t first = begin.points.size();
  std::size_t last = end.points.size();
  const auto is_clear = [&](const PlanarSegment& way) {
    return keeps_clear(segment, way) &&
           (neighbours.before == nullptr || keeps_clear(*neighbours.before, way)) &&
           (neighbours.behind == nullptr || keeps_clear(*neighbours.behind, way));
  };
  const auto good = [&] {
    if (first == 0 || last == 0) return false;
    const Vec2 from = begin.points[first - 1];
    const Vec2 to = end.points[end.points.size() - last];
    const bool whole = first == begin.points.size() && last == end.points.size();
    return !runs_back(segment, from, to) && (whole || is_clear(straight(from, to)));
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
  begin.gentle = end.gentle = false;
  return Interference::partly;
}

std::optional<Vec2> avoiding_point(const OffsetSegment& before, Vec2 from, const OffsetSegment& behind) {
  const PlanarSegment first =
      before.programmed.is_arc ? before.offset : offset_segment(before.programmed, before.left_mm);
  const PlanarSegment next =
      behind.programmed.is_arc ? behind.offset : offset_segment(behind.programmed, behind.left_mm);
  // Avoiding something else may have left nothing of the path beside an arc.
  if (length_of(first) <= kBack && !first.is_arc) return std::nullopt;
  const auto point = nearest_point(meeting_of_curves(first, next), before.programmed.end);
  if (!point) return std::nullopt;
  const bool on_first = !runs_back(before, from, *point) && !runs_back(before, *point, before.offset.end);
  const bool on_next =
      !runs_back(behind, behind.offset.start, *point) && !runs_back(behind, *point, behind.offset.end);
  if (!on_first || !on_next) return std::nullopt;
  return point;
}

}  // namespace kerf
