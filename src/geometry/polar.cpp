#include "geometry/polar.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kerf {
namespace {

bool at_origin(Vec2 point) {
  return length(point) < kThroughOrigin;
}

bool through_origin(const PlanarSegment& arc) {
  return std::abs(length(arc.center) - arc.radius) < kThroughOrigin;
}

/// Direction of the point at `angle_deg` of a circle, without jumps over the angle; `around`: the origin lies
/// inside of the circle.
double direction_deg(Vec2 center, double radius, double angle_deg, bool around) {
  const double away = length(center);
  const double from_center = angle_of_deg(center);
  if (around) {
    return angle_deg + angle_of_deg(Vec2{1.0, 0.0} + (away / radius) * direction_at(from_center - angle_deg));
  }
  return from_center + angle_of_deg(Vec2{1.0, 0.0} + (radius / away) * direction_at(angle_deg - from_center));
}

Vec2 point_after(const PlanarSegment& arc, double part) {
  const Vec2 arm = arc.start - arc.center;
  const double end_radius = distance(arc.center, arc.end);
  const double radius = length(arm) + part * (end_radius - length(arm));
  return arc.center + radius * direction_at(angle_of_deg(arm) + part * arc.sweep_deg);
}

/// A spiral that crosses the circle around its centre on which the origin lies.
double sampled_turn_deg(const PlanarSegment& arc) {
  constexpr int kSteps = 3600;
  double turn = 0.0;
  Vec2 before = arc.start;
  for (int i = 1; i <= kSteps; ++i) {
    const Vec2 now = point_after(arc, static_cast<double>(i) / kSteps);
    turn += turn_deg(before, now);
    before = now;
  }
  return turn;
}

/// Whether an arc passes the direction `angle_deg` seen from its centre; then the part of it before.
bool passes(const PlanarSegment& arc, double angle_deg, double& part) {
  const double turn = std::abs(arc.sweep_deg);
  if (turn <= 0.0) return false;
  const double ahead = ahead_deg(arc.start - arc.center, direction_at(angle_deg), arc.sweep_deg < 0.0);
  part = (ahead < 0.0 ? ahead + 360.0 : ahead) / turn;
  return part < 1.0;
}

void include(PolarRange& range, double turn) {
  range.least_turn_deg = std::min(range.least_turn_deg, turn);
  range.greatest_turn_deg = std::max(range.greatest_turn_deg, turn);
}

PolarRange arc_range(const PlanarSegment& arc, PolarRange range) {
  const double away = length(arc.center);
  const double narrow = std::min(arc.radius, distance(arc.center, arc.end));
  const double wide = std::max(arc.radius, distance(arc.center, arc.end));
  const double outwards = angle_of_deg(arc.center);
  double part = 0.0;
  if (passes(arc, outwards, part)) range.greatest_radius = std::max(range.greatest_radius, away + wide);
  if (passes(arc, outwards + 180.0, part)) {
    const bool inside = away > narrow && away < wide;
    range.least_radius =
        inside ? 0.0 : std::min({range.least_radius, std::abs(away - narrow), std::abs(away - wide)});
  }
  if (away <= wide) return range;
  // Seen from outside, a circle is widest where the line of sight touches it.
  const double touch = degrees(std::acos(wide / away));
  for (const double angle : {outwards + 180.0 - touch, outwards + 180.0 + touch}) {
    if (!passes(arc, angle, part)) continue;
    include(range, turn_around_origin_deg(part_of(arc, 0.0, part)));
  }
  return range;
}

}  // namespace

double shortest_turn_deg(double angle_deg) {
  const double turn = std::remainder(angle_deg, 360.0);
  return turn <= -180.0 ? turn + 360.0 : turn;
}

double turn_around_origin_deg(const PlanarSegment& segment) {
  const bool from_origin = at_origin(segment.start);
  const bool to_origin = at_origin(segment.end);
  if (!segment.is_arc) return from_origin || to_origin ? 0.0 : turn_deg(segment.start, segment.end);
  // An arc seen from a point of its circle: the inscribed angle.
  if (from_origin || to_origin) return 0.5 * segment.sweep_deg;
  const double start_radius = distance(segment.center, segment.start);
  const double end_radius = distance(segment.center, segment.end);
  const double away = length(segment.center);
  if ((start_radius > away) != (end_radius > away) && std::abs(start_radius - end_radius) > kThroughOrigin)
    return sampled_turn_deg(segment);
  if (away < kThroughOrigin) return segment.sweep_deg;
  const bool around = start_radius > away;
  const double angle = angle_of_deg(segment.start - segment.center);
  return direction_deg(segment.center, end_radius, angle + segment.sweep_deg, around) -
         direction_deg(segment.center, start_radius, angle, around);
}

PolarRange polar_range(const PlanarSegment& segment) {
  PolarRange range;
  const double from = length(segment.start);
  const double to = length(segment.end);
  range.least_radius = std::min(from, to);
  range.greatest_radius = std::max(from, to);
  include(range, turn_around_origin_deg(segment));
  if (segment.is_arc) return arc_range(segment, range);
  const Vec2 along = unit(segment.end - segment.start);
  if (dot(segment.start, along) < 0.0 && dot(segment.end, along) > 0.0)
    range.least_radius = std::abs(cross(along, segment.start));
  return range;
}

double part_before_origin(const PlanarSegment& segment) {
  if (at_origin(segment.start) || at_origin(segment.end)) {
    // A full circle or a spiral from the origin back to it is not looked into.
    return 0.0;
  }
  if (!segment.is_arc) {
    const Vec2 way = segment.end - segment.start;
    const double square = dot(way, way);
    if (square <= 0.0) return 0.0;
    const double part = -dot(segment.start, way) / square;
    const bool between = part > 0.0 && part < 1.0;
    return between && std::abs(cross(unit(way), segment.start)) < kThroughOrigin ? part : 0.0;
  }
  double part = 0.0;
  if (length(segment.center) < kThroughOrigin || !passes(segment, angle_of_deg(-segment.center), part))
    return 0.0;
  return at_origin(point_after(segment, part)) ? part : 0.0;
}

PlanarSegment part_of(const PlanarSegment& segment, double from, double to) {
  PlanarSegment part = segment;
  if (!segment.is_arc) {
    const Vec2 way = segment.end - segment.start;
    if (from > 0.0) part.start = segment.start + from * way;
    if (to < 1.0) part.end = segment.start + to * way;
    return part;
  }
  if (from > 0.0) part.start = point_after(segment, from);
  if (to < 1.0) part.end = point_after(segment, to);
  part.radius = distance(part.center, part.start);
  part.sweep_deg = (to - from) * segment.sweep_deg;
  return part;
}

PolarRates polar_rates(const PlanarSegment& segment) {
  const PolarRange range = polar_range(segment);
  const double near = std::max(range.least_radius, kThroughOrigin);
  const double far = std::max(range.greatest_radius, near);
  PolarRates rates;
  if (!segment.is_arc) {
    const double aside = std::abs(cross(unit(segment.end - segment.start), segment.start));
    if (aside < kThroughOrigin) return rates;  // straight in or out
    rates.turn = aside / (near * near);
    rates.least_turn = aside / (far * far);
    rates.turn2 = 2.0 * aside / (near * near * near);
    rates.radius2 = aside * aside / (near * near * near);
    return rates;
  }
  const double radius = std::max(segment.radius, kThroughOrigin);
  if (through_origin(segment)) {
    rates.turn = rates.least_turn = 0.5 / radius;
    rates.radius2 = far / (4.0 * radius * radius);
    return rates;
  }
  const double away = length(segment.center);
  const double rest = (radius - away) * (radius + away);  // R2 - c2
  const auto turn_at = [&](double r) { return (1.0 + rest / (r * r)) / (2.0 * radius); };
  const double at_near = turn_at(near);
  const double at_far = turn_at(far);
  rates.turn = std::max(std::abs(at_near), std::abs(at_far));
  rates.least_turn = (at_near < 0.0) != (at_far < 0.0) ? 0.0 : std::min(std::abs(at_near), std::abs(at_far));
  rates.turn2 = away < kThroughOrigin ? 0.0 : std::abs(rest) / (radius * near * near * near);
  if (away < kThroughOrigin) return rates;
  // Falls evenly with r, so its largest magnitude is at one of the ends.
  const auto bend_at = [&](double r) { return rest / r * (rest / (r * r)) - r; };
  rates.radius2 = std::max(std::abs(bend_at(near)), std::abs(bend_at(far))) / (4.0 * radius * radius);
  return rates;
}

}  // namespace kerf
