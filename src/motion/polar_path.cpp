#include "motion/polar_path.hpp"

#include <algorithm>
#include <cmath>

#include "execute/polar_plane.hpp"
#include "geometry/polar.hpp"

namespace kerf {
namespace {

constexpr double kUnlimited = 1e30;

/// Plane way for a unit of s.
double plane_share(const PathSegment& segment) {
  if (segment.is_arc) return segment.arc.share;
  return std::hypot(segment.slope.values[segment.polar.linear], segment.slope.values[segment.polar.rotary]);
}

}  // namespace

AxisLimits without_polar_axes(const AxisLimits& limits, const PolarPlane& polar) {
  AxisLimits others = limits;
  for (const Axis axis : {polar.linear, polar.rotary}) {
    others.acceleration[axis] = others.feed[axis] = kUnlimited;
    others.inverse_acceleration[axis] = others.inverse_rapid_acceleration[axis] = 0.0;
    others.inverse_feed[axis] = others.inverse_rapid[axis] = 0.0;
  }
  return others;
}

void set_polar_limits(PathSegment& segment, const Move& move, const AxisLimits& limits, double feed_now) {
  const PlanarSegment contour = polar_contour(move);
  const PolarRates rates = polar_rates(contour);
  PolarPath& path = segment.polar;
  path.active = true;
  path.linear = static_cast<std::uint8_t>(index(move.polar.linear));
  path.rotary = static_cast<std::uint8_t>(index(move.polar.rotary));
  path.side = move.polar.minus ? -1.0 : 1.0;
  path.center = move.polar.center;
  path.angle = move.start[move.polar.rotary];
  path.direction = direction_at(path.angle - move.polar.zero);
  path.at_center = path.direction;
  if (length(contour.end) < kThroughOrigin) path.at_center = -end_tangent(contour);
  path.nearest = polar_range(contour).least_radius;
  path.linear_end = move.end[move.polar.linear];
  path.rotary_end = move.end[move.polar.rotary];
  const double share = plane_share(segment);
  if (!(share > 0.0) || segment.length <= 0.0) return;

  const AxisVector& inverse_speed = segment.rapid ? limits.inverse_rapid : limits.inverse_feed;
  const double linear_acceleration = limits.acceleration.values[path.linear];
  const double turning_acceleration = radians(limits.acceleration.values[path.rotary]);
  const double slowest =
      std::max(inverse_speed.values[path.linear], degrees(rates.turn) * inverse_speed.values[path.rotary]);
  double speed = 1.0 / slowest;
  if (!segment.at_maximum) {
    const double feed = 2.0 * std::max({feed_now, segment.feed_mm_min, 0.0}) / segment.feed_per_speed;
    speed = std::min(speed, feed * share);
  }
  const double bend = std::max(rates.radius2 / linear_acceleration, rates.turn2 / turning_acceleration);
  if (bend > 0.0) speed = std::min(speed, std::sqrt(kCentripetalShare / bend));
  const double square = speed * speed;
  double along = linear_acceleration - rates.radius2 * square;
  if (rates.turn > 0.0) along = std::min(along, (turning_acceleration - rates.turn2 * square) / rates.turn);
  segment.speed_limit = std::min(segment.speed_limit, speed / share);
  segment.acceleration = std::min(segment.acceleration, along / share);
}

AxisLimits limits_in_polar_plane(const PolarPath& polar, const AxisLimits& limits) {
  AxisLimits own = limits;
  const double inverse = limits.inverse_acceleration.values[polar.linear];
  const double turning = degrees(limits.inverse_acceleration.values[polar.rotary]);
  const double both = std::max(inverse, turning / std::max(polar.nearest, kThroughOrigin));
  own.inverse_acceleration.values[polar.linear] = both;
  own.inverse_acceleration.values[polar.rotary] = both;
  return own;
}

void extend_polar_range(const PathSegment& segment, AxisVector& low, AxisVector& high) {
  const PolarPath& polar = segment.polar;
  const auto in_plane = [&](const AxisVector& values) {
    return polar.side * Vec2{values.values[polar.linear] - polar.center, values.values[polar.rotary]};
  };
  const auto extend = [&](std::size_t axis, double least, double greatest) {
    low.values[axis] = std::min(low.values[axis], least);
    high.values[axis] = std::max(high.values[axis], greatest);
  };
  PlanarSegment contour = straight(in_plane(segment.start), in_plane(segment.end));
  if (segment.is_arc) {
    const ArcPath& arc = segment.arc;
    const Vec2 center = polar.side * Vec2{arc.center[0] - polar.center, arc.center[1]};
    contour =
        curved(contour.start, contour.end, center, arc.radius, degrees(arc.angle_slope * segment.length));
  }
  const PolarRange range = polar_range(contour);
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (i == polar.linear || i == polar.rotary) continue;
    extend(i, std::min(segment.start.values[i], segment.end.values[i]),
           std::max(segment.start.values[i], segment.end.values[i]));
  }
  const bool plus = polar.side > 0.0;
  extend(polar.linear, polar.center + (plus ? range.least_radius : -range.greatest_radius),
         polar.center + (plus ? range.greatest_radius : -range.least_radius));
  extend(polar.rotary, polar.angle + range.least_turn_deg, polar.angle + range.greatest_turn_deg);
}

void turn_into_axes(const PolarPath& polar, PathPoint& point) {
  const std::size_t first = polar.linear;
  const std::size_t second = polar.rotary;
  const auto in_plane = [&](const AxisVector& values, double offset) {
    return polar.side * Vec2{values.values[first] - offset, values.values[second]};
  };
  const Vec2 at = in_plane(point.position, polar.center);
  const Vec2 velocity = in_plane(point.velocity, 0.0);
  const Vec2 acceleration = in_plane(point.acceleration, 0.0);
  const double radius = length(at);
  const bool in_center = radius < kThroughOrigin;
  const Vec2 outwards = in_center ? polar.at_center : at / radius;
  const double speed = dot(outwards, velocity);
  const double turning = in_center ? 0.0 : cross(outwards, velocity) / radius;  // rad/s
  const double turning2 = in_center ? 0.0 : (cross(outwards, acceleration) - 2.0 * speed * turning) / radius;
  point.position.values[first] = polar.center + polar.side * radius;
  point.velocity.values[first] = polar.side * speed;
  point.acceleration.values[first] = polar.side * (dot(outwards, acceleration) + radius * turning * turning);
  point.position.values[second] = polar.angle + turn_deg(polar.direction, outwards);
  point.velocity.values[second] = degrees(turning);
  point.acceleration.values[second] = degrees(turning2);
}

}  // namespace kerf
