#include "toolpath/contour_view.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/segment_distance.hpp"
#include "toolpath/interference.hpp"

namespace kerf {
namespace {

constexpr double kReversal = 180.0 - 1e-3;  // degrees
constexpr double kAngleRounding = 1e-6;     // degrees
constexpr int kSamples = 16;                // of a way or a block that is an arc
// Degrees that the contour turns towards the tool until a block that the tool runs into: 0 to 180, and some
// more, since at the corner of two blocks it is enough that one of them is told. Half a turn off are those
// that it crosses again.
constexpr double kLeastTurn = -90.0;
constexpr double kMostTurn = 200.0;

/// The place of a point along an arc, from its start on. Degrees, with the sign of the sweep.
double swept_at(const PlanarSegment& arc, Vec2 point) {
  const double sweep = std::abs(arc.sweep_deg);
  double ahead = ahead_deg(arc.start - arc.center, point - arc.center, arc.sweep_deg < 0.0);
  if (ahead < -kAngleRounding && ahead + 360.0 <= sweep) ahead += 360.0;
  if (ahead < 0.0 || ahead > sweep)
    ahead = distance(point, arc.start) < distance(point, arc.end) ? 0.0 : sweep;
  return std::copysign(ahead, arc.sweep_deg);
}

// Seen from the centre the arc and the path beside it are the same; one of them may be a point.
double heading_at(const SeenBlock& block, Vec2 point) {
  const OffsetSegment& segment = block.segment;
  const PlanarSegment& path = segment.offset.radius > 0.0 ? segment.offset : segment.programmed;
  return block.heading_deg + (path.is_arc ? swept_at(path, point) : 0.0);
}

struct Circle {
  Vec2 middle;
  double radius = 0.0;
};

Circle circle_around(const PlanarSegment& path) {
  if (path.is_arc) return {path.center, path.radius};
  return {0.5 * (path.start + path.end), 0.5 * distance(path.start, path.end)};
}

SeenWay seen_way(const PlanarSegment& path, double heading_deg) {
  const Circle around = circle_around(path);
  return {path, heading_deg, around.middle, around.radius};
}

Vec2 point_along(const PlanarSegment& path, double part) {
  if (!path.is_arc) return path.start + part * (path.end - path.start);
  return point_on(arc_through(path.start, path.center, path.sweep_deg), part * path.sweep_deg);
}

/// The contour turns between the way and a block as it does where the tool runs into it, as seen from a point
/// of the way.
bool is_met(const SeenWay& way, double part, const SeenBlock& block, Place place) {
  const double own = way.heading_deg + (way.path.is_arc ? part * way.path.sweep_deg : 0.0);
  const double ahead = heading_at(block, point_along(way.path, part)) - own;
  const double turn = (block.segment.left_mm < 0.0) == (place == Place::ahead) ? -ahead : ahead;
  return turn >= kLeastTurn && turn <= kMostTurn;
}

}  // namespace

double turn_between(const OffsetSegment& first, const OffsetSegment& next) {
  const double turn = turn_deg(first.ends, next.begins);
  return std::abs(turn) < kReversal ? turn : std::copysign(180.0, -first.left_mm);
}

SeenBlock seen_block(const OffsetSegment& segment, std::uint32_t number, double heading_deg) {
  const Circle around = circle_around(segment.programmed);
  return {segment, heading_deg, number, around.middle, around.radius};
}

SeenBlock seen_corner(const SeenBlock& first, const Corner& corner) {
  OffsetSegment segment;
  segment.left_mm = first.segment.left_mm;
  segment.offset = way_between(corner, 1, segment.left_mm);
  segment.programmed = curved(corner.about, corner.about, corner.about, 0.0, segment.offset.sweep_deg);
  segment.begins = start_tangent(segment.offset);
  segment.ends = end_tangent(segment.offset);
  return seen_block(segment, first.number, heading_at_end(first));
}

double heading_at_end(const SeenBlock& block) {
  const PlanarSegment& path = block.segment.programmed;
  return block.heading_deg + (path.is_arc ? path.sweep_deg : 0.0);
}

SeenWay way_beside(const SeenBlock& block, Vec2 from, Vec2 to) {
  PlanarSegment path = block.segment.offset;
  const double heading = heading_at(block, from);
  if (!path.is_arc) return seen_way(straight(from, to), heading);
  begin_at(path, from);
  const double left_deg = end_at(path, to);
  if (left_deg <= 0.0) return seen_way(straight(from, to), heading);
  path.radius = distance(path.center, path.start);
  return seen_way(path, heading);
}

SeenWay way_behind(const SeenBlock& block, const PlanarSegment& path) {
  return seen_way(path, heading_at_end(block) + turn_deg(block.segment.ends, start_tangent(path)));
}

bool cuts_into(const SeenWay& way, const SeenBlock& block, Place place) {
  const double far = way.reach_mm + block.reach_mm + std::abs(block.segment.left_mm);
  const Vec2 apart = way.middle - block.middle;
  if (dot(apart, apart) >= far * far || keeps_clear(block.segment, way.path)) return false;
  const PlanarSegment& cut = block.segment.programmed;
  if (!way.path.is_arc && !cut.is_arc) return is_met(way, 0.0, block, place);
  // Along an arc the contour turns: what counts is the turn where the tool comes too near.
  double nearest = HUGE_VAL;
  double nearest_part = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const double part = static_cast<double>(i) / kSamples;
    const Vec2 at = point_along(way.path, part);
    const double away = distance_to(cut, at);
    if (away < nearest) nearest_part = part;
    nearest = std::min(nearest, away);
    if (!keeps_clear(block.segment, straight(at, at)) && is_met(way, part, block, place)) return true;
  }
  return is_met(way, nearest_part, block, place);
}

bool takes_over(const SeenBlock& from, const SeenBlock& ahead, Vec2 at) {
  const double side = from.segment.left_mm < 0.0 ? -1.0 : 1.0;
  const double turn = side * (heading_at(ahead, at) - heading_at(from, at));
  return turn >= -kBack && turn <= 180.0 + kBack;
}

bool is_on_path(const SeenBlock& block, Vec2 point, const Extensions& extensions) {
  const PlanarSegment& path = block.segment.offset;
  if (path.is_arc) return path.radius > 0.0 && distance_to(path, point) <= kBack;
  const double from_start = dot(point - path.start, block.segment.begins);
  const double to_end = dot(path.end - point, block.segment.begins);
  return from_start >= -extensions.before_mm - kBack && to_end >= -extensions.behind_mm - kBack;
}

}  // namespace kerf
