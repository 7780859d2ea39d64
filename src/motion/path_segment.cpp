#include "motion/path_segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "execute/polar_plane.hpp"
#include "geometry/spiral.hpp"
#include "geometry/vec2.hpp"
#include "motion/polar_path.hpp"

namespace kerf {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

double square(double x) {
  return x * x;
}

/// The speed at which the first axis reaches its limit: 1 / max |slope| / limit.
double limit_along(const AxisVector& slope, const AxisVector& inverse_limit) {
  double need = 0.0;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    need = std::max(need, std::abs(slope.values[i]) * inverse_limit.values[i]);
  }
  return need > 0.0 ? 1.0 / need : kLargest;
}

/// Length along which the feed of a move is measured; 0: the move asks for the axes' highest rates.
double feed_length(const Move& move, const AxisVector& step, double xyz_or_arc_length, double all_length) {
  const RotaryFeed& rotary = move.rotary_feed;
  const double base = xyz_or_arc_length > kShortestLength ? xyz_or_arc_length : 0.0;
  const double turn = rotary.active ? std::abs(step[rotary.axis]) : 0.0;
  if (turn <= kShortestLength) return base > 0.0 ? base : all_length;
  if (rotary.at_maximum || !(rotary.radius > 0.0)) return base;
  return std::max(base, radians(turn) * rotary.radius);
}

void set_feed(PathSegment& segment, const Move& move, double measured_length) {
  segment.feed_mm_min = move.feed;
  segment.at_maximum = segment.rapid || measured_length <= 0.0;
  segment.feed_per_speed = 60.0 * (measured_length > 0.0 ? measured_length / segment.length : 1.0);
}

/// From the start to the end of a move, without the axes that follow others.
AxisVector step_of(const Move& move, const AxisLimits& limits) {
  AxisVector step = move.end - move.start;
  for (const Axis axis : limits.followers) step[axis] = 0.0;
  return step;
}

/// Highest speed of s at which no axis is faster than `axis_mm_min`.
double speed_of_axes(const PathSegment& segment, double axis_mm_min) {
  double steepest = 0.0;
  for (const double slope : segment.slope.values) steepest = std::max(steepest, std::abs(slope));
  return axis_mm_min / 60.0 / steepest;
}

void set_line(PathSegment& segment, const Move& move, const AxisLimits& limits) {
  const AxisVector step = step_of(move, limits);
  double sum = 0.0;
  for (const double x : step.values) sum += x * x;
  segment.is_arc = false;
  segment.length = segment.rapid && move.each_axis ? std::abs(step[move.last_axis]) : std::sqrt(sum);
  segment.length_mm = std::sqrt(square(step[Axis::X]) + square(step[Axis::Y]) + square(step[Axis::Z]));
  if (!(segment.length >= kShortestLength) || std::isinf(segment.length)) {
    segment.length = 0.0;
    return;
  }
  const double inverse = 1.0 / segment.length;
  for (std::size_t i = 0; i < kAxisCount; ++i) segment.slope.values[i] = step.values[i] * inverse;
  const bool all_axes = limits.feed_of_all_axes && !move.rotary_feed.active;
  const double together = all_axes ? std::sqrt(sum) : segment.length_mm;
  set_feed(segment, move, feed_length(move, step, together, std::sqrt(sum)));
  segment.speed_limit =
      limit_along(segment.slope, segment.rapid ? limits.inverse_rapid : limits.inverse_feed);
  if (segment.rapid && move.feed > 0.0)
    segment.speed_limit = std::min(segment.speed_limit, speed_of_axes(segment, move.feed));
  segment.acceleration = limit_along(
      segment.slope, segment.rapid ? limits.inverse_rapid_acceleration : limits.inverse_acceleration);
}

/// Speed and acceleration of a circle that may be out of round, r = r0 + k angle. With w the angle's rate,
/// the velocity is w sqrt(r2 + k2) and the acceleration has the parts w2 sqrt(r2 + 4 k2) and dw/dt sqrt(r2 +
/// k2), at right angles on a circle; on a spiral the cosine of the angle between them is at most k / r and
/// never above 1/3.
void set_arc_limits(PathSegment& segment, const AxisLimits& limits, double feed_now, double r0, double r1,
                    double k) {
  const std::size_t first = segment.arc.first;
  const std::size_t second = segment.arc.second;
  const double widest = std::max(r0, r1);
  const double slope = std::abs(segment.arc.angle_slope);
  const double along = slope * std::hypot(widest, k);  // plane speed for a speed of 1
  const double across =
      square(slope) * std::hypot(widest, 2 * k);  // centripetal acceleration for a speed of 1
  const double tilt = std::min(std::abs(k) / std::max(std::min(r0, r1), kShortestLength), 1.0 / 3.0);
  const double plane_acceleration =
      std::min(limits.acceleration.values[first], limits.acceleration.values[second]) / std::sqrt(1.0 + tilt);
  const double plane_feed = std::min(limits.feed.values[first], limits.feed.values[second]);

  double speed = std::min(plane_feed / along, limit_along(segment.slope, limits.inverse_feed));
  speed = std::min(speed, std::sqrt(kCentripetalShare * plane_acceleration / across));
  if (!segment.at_maximum) {
    speed = std::min(speed, 2.0 * std::max({feed_now, segment.feed_mm_min, 0.0}) / segment.feed_per_speed);
  }
  segment.speed_limit = speed;
  const double centripetal = across * square(speed);
  segment.acceleration = std::min(std::sqrt(square(plane_acceleration) - square(centripetal)) / along,
                                  limit_along(segment.slope, limits.inverse_acceleration));
}

/// The same along a spiral, at the speed of its way: the acceleration has the parts v2 c across, with the
/// curvature c = (r2 + 2 k2) / (r2 + k2)^(3/2) that is greatest at the least radius, and dv/dt along.
void set_spiral_limits(PathSegment& segment, const AxisLimits& limits, double feed_now, double least_radius) {
  const ArcPath& arc = segment.arc;
  const double k = arc.growth;
  const double square_sum = square(least_radius) + square(k);
  const double curvature = (square_sum + square(k)) / (square_sum * std::sqrt(square_sum));
  const double plane_acceleration =
      std::min(limits.acceleration.values[arc.first], limits.acceleration.values[arc.second]);
  const double plane_feed = std::min(limits.feed.values[arc.first], limits.feed.values[arc.second]);
  const double across = curvature * square(arc.share);
  double speed = std::min(plane_feed / arc.share, limit_along(segment.slope, limits.inverse_feed));
  speed = std::min(speed, std::sqrt(kCentripetalShare * plane_acceleration / across));
  if (!segment.at_maximum) {
    speed = std::min(speed, 2.0 * std::max({feed_now, segment.feed_mm_min, 0.0}) / segment.feed_per_speed);
  }
  segment.speed_limit = speed;
  const double centripetal = across * square(speed);
  segment.acceleration = std::min(std::sqrt(square(plane_acceleration) - square(centripetal)) / arc.share,
                                  limit_along(segment.slope, limits.inverse_acceleration));
}

/// False when the arc is too small to be one.
bool set_arc(PathSegment& segment, const Move& move, const AxisLimits& limits, double feed_now) {
  const Axis first = move.plane.first;
  const Axis second = move.plane.second;
  const double x0 = move.start[first] - move.arc.center[0];
  const double y0 = move.start[second] - move.arc.center[1];
  const double x1 = move.end[first] - move.arc.center[0];
  const double y1 = move.end[second] - move.arc.center[1];
  const double r0 = std::hypot(x0, y0);
  const double r1 = std::hypot(x1, y1);
  const double sweep = radians(move.arc.sweep);
  const double whole = std::abs(sweep);
  const double arc_length = way_of_arc(r0, r1, whole);
  if (!(arc_length >= kShortestLength) || std::isinf(arc_length) || !(std::min(r0, r1) > 0.0)) return false;

  AxisVector step = step_of(move, limits);
  step[first] = 0.0;
  step[second] = 0.0;
  double sum = square(arc_length);
  for (const double x : step.values) sum += x * x;
  segment.is_arc = true;
  segment.length = std::sqrt(sum);
  double xyz = square(arc_length);
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) xyz += square(step[axis]);
  segment.length_mm = std::sqrt(xyz);

  const double inverse = 1.0 / segment.length;
  for (std::size_t i = 0; i < kAxisCount; ++i) segment.slope.values[i] = step.values[i] * inverse;
  ArcPath& arc = segment.arc;
  arc.first = static_cast<std::uint8_t>(index(first));
  arc.second = static_cast<std::uint8_t>(index(second));
  arc.center = move.arc.center;
  arc.angle = std::atan2(y0, x0);
  arc.angle_slope = sweep * inverse;
  arc.radius = r0;
  arc.radius_slope = (r1 - r0) * inverse;
  const double end_angle = arc.angle + sweep;
  arc.drift = {(x1 - r1 * std::cos(end_angle)) * inverse, (y1 - r1 * std::sin(end_angle)) * inverse};
  arc.is_spiral = is_spiral(r0, r1);
  arc.growth = (r1 - r0) / whole;
  arc.share = arc_length * inverse;
  const double measured = move.feed_in_space ? segment.length_mm : arc_length;
  set_feed(segment, move, feed_length(move, step, measured, segment.length));
  if (arc.is_spiral) {
    set_spiral_limits(segment, limits, feed_now, std::min(r0, r1));
    return true;
  }
  set_arc_limits(segment, limits, feed_now, r0, r1, (r1 - r0) / sweep);
  return true;
}

/// d position / ds on an arc whose radius vector is (x, y).
AxisVector arc_tangent(const PathSegment& segment, double x, double y) {
  const ArcPath& arc = segment.arc;
  const double radius = std::hypot(x, y);
  AxisVector tangent = segment.slope;
  if (arc.is_spiral) {
    const double along = arc.share / std::hypot(radius, arc.growth);
    const double turn = arc.angle_slope < 0.0 ? -along : along;
    const double radial = along * arc.growth / radius;
    tangent.values[arc.first] = radial * x - turn * y + arc.drift[0];
    tangent.values[arc.second] = radial * y + turn * x + arc.drift[1];
    return tangent;
  }
  const double radial = arc.radius_slope / radius;
  tangent.values[arc.first] = radial * x - arc.angle_slope * y + arc.drift[0];
  tangent.values[arc.second] = radial * y + arc.angle_slope * x + arc.drift[1];
  return tangent;
}

void extend(AxisVector& low, AxisVector& high, std::size_t axis, double value) {
  low.values[axis] = std::min(low.values[axis], value);
  high.values[axis] = std::max(high.values[axis], value);
}

/// With the unit vectors e outwards and t along the turn, and w = sqrt(r2 + k2): the way turns by 1 / w a
/// unit, runs along (k e + r t) / w, and that changes by (2 k t - r e) / w2 - (k e + r t) r k / w4.
void evaluate_spiral(const PathSegment& segment, double s, double speed, double acceleration,
                     PathPoint& point) {
  const ArcPath& arc = segment.arc;
  const double k = arc.growth;
  const double way = arc.share * segment.length;
  const double turned = angle_after({arc.radius, k}, std::clamp(arc.share * s, 0.0, way),
                                    std::abs(arc.angle_slope) * segment.length);
  const double side = arc.angle_slope < 0.0 ? -1.0 : 1.0;
  const double angle = arc.angle + side * turned;
  const Vec2 e{std::cos(angle), std::sin(angle)};
  const Vec2 t = side * left_of(e);
  const double radius = arc.radius + k * turned;
  const double w2 = radius * radius + k * k;
  const double w = std::sqrt(w2);
  const Vec2 along = (k * e + radius * t) / w;
  const Vec2 bend = (2.0 * k * t - radius * e) / w2 - along * (radius * k / (w2 * w));
  const Vec2 drift{arc.drift[0], arc.drift[1]};
  const Vec2 position = Vec2{arc.center[0], arc.center[1]} + radius * e + s * drift;
  const Vec2 velocity = speed * (arc.share * along + drift);
  const Vec2 rate = acceleration * (arc.share * along + drift) + (square(speed) * square(arc.share)) * bend;
  point.position.values[arc.first] = position.x;
  point.position.values[arc.second] = position.y;
  point.velocity.values[arc.first] = velocity.x;
  point.velocity.values[arc.second] = velocity.y;
  point.acceleration.values[arc.first] = rate.x;
  point.acceleration.values[arc.second] = rate.y;
}

void evaluate_in_its_plane(const PathSegment& segment, double s, double speed, double acceleration,
                           PathPoint& point) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    point.position.values[i] = segment.start.values[i] + segment.slope.values[i] * s;
    point.velocity.values[i] = segment.slope.values[i] * speed;
    point.acceleration.values[i] = segment.slope.values[i] * acceleration;
  }
  if (!segment.is_arc) return;
  const ArcPath& arc = segment.arc;
  if (arc.is_spiral) return evaluate_spiral(segment, s, speed, acceleration, point);
  const double angle = arc.angle + arc.angle_slope * s;
  const double x = std::cos(angle);
  const double y = std::sin(angle);
  const double radius = arc.radius + arc.radius_slope * s;
  const double turn = arc.angle_slope * radius;
  const double dx = arc.radius_slope * x - turn * y + arc.drift[0];
  const double dy = arc.radius_slope * y + turn * x + arc.drift[1];
  const double bend = -arc.angle_slope * turn;
  const double twist = 2.0 * arc.radius_slope * arc.angle_slope;
  const double speed2 = speed * speed;
  point.position.values[arc.first] = arc.center[0] + radius * x + arc.drift[0] * s;
  point.position.values[arc.second] = arc.center[1] + radius * y + arc.drift[1] * s;
  point.velocity.values[arc.first] = speed * dx;
  point.velocity.values[arc.second] = speed * dy;
  point.acceleration.values[arc.first] = acceleration * dx + speed2 * (bend * x - twist * y);
  point.acceleration.values[arc.second] = acceleration * dy + speed2 * (bend * y + twist * x);
}

/// In the coordinates that the move has.
void set_in_its_plane(PathSegment& segment, const Move& move, const AxisLimits& limits, double feed_now) {
  segment.start = move.start;
  segment.end = move.end;
  segment.rapid = move.mode == MoveMode::rapid;
  if (is_arc(move.mode) && set_arc(segment, move, limits, feed_now)) return;
  set_line(segment, move, limits);
}

void set_polar(PathSegment& segment, const Move& move, const AxisLimits& limits, double feed_now) {
  const Move flat = in_polar_plane(move);
  // Without a way in the plane both axes stand, in the centre of rotation too, where they have no angle.
  const auto stands = [&](Axis axis) { return flat.start[axis] == flat.end[axis]; };
  if (!is_arc(flat.mode) && stands(move.polar.linear) && stands(move.polar.rotary))
    return set_in_its_plane(segment, move, limits, feed_now);
  set_in_its_plane(segment, flat, without_polar_axes(limits, move.polar), feed_now);
  if (segment.length <= 0.0) return;
  const double second = flat.end[move.polar.rotary] - flat.start[move.polar.rotary];
  if (!segment.is_arc) segment.length_mm = std::hypot(segment.length_mm, second);
  set_feed(segment, flat, limits.feed_of_all_axes ? segment.length : segment.length_mm);
  set_polar_limits(segment, move, limits, feed_now);
}

}  // namespace

void set_path(PathSegment& segment, const Move& move, const AxisLimits& limits, double feed_now) {
  segment.polar.active = false;
  if (move.polar.form == PolarForm::axes) return set_polar(segment, move, limits, feed_now);
  set_in_its_plane(segment, move, limits, feed_now);
}

AxisVector start_tangent(const PathSegment& segment) {
  if (!segment.is_arc) return segment.slope;
  const ArcPath& arc = segment.arc;
  return arc_tangent(segment, segment.start.values[arc.first] - arc.center[0],
                     segment.start.values[arc.second] - arc.center[1]);
}

AxisVector end_tangent(const PathSegment& segment) {
  if (!segment.is_arc) return segment.slope;
  const ArcPath& arc = segment.arc;
  return arc_tangent(segment, segment.end.values[arc.first] - arc.center[0],
                     segment.end.values[arc.second] - arc.center[1]);
}

AxisVector even_slope(const PathSegment& segment) {
  AxisVector slope = segment.slope;
  if (segment.polar.active) slope.values[segment.polar.linear] = slope.values[segment.polar.rotary] = 0.0;
  return slope;
}

std::array<std::size_t, 2> curved_axes(const PathSegment& segment) {
  if (segment.polar.active) return {segment.polar.linear, segment.polar.rotary};
  return {segment.arc.first, segment.arc.second};
}

const AxisLimits& joint_limits(const PathSegment& segment, const AxisLimits& limits, AxisLimits& own) {
  if (!segment.polar.active) return limits;
  own = limits_in_polar_plane(segment.polar, limits);
  return own;
}

bool is_curved(const PathSegment& segment) {
  return segment.is_arc || segment.polar.active;
}

void evaluate_end(const PathSegment& segment, double speed, PathPoint& point) {
  point.position = segment.end;
  point.velocity = end_tangent(segment) * speed;
  point.acceleration = {};
  if (!segment.polar.active) return;
  turn_into_axes(segment.polar, point);
  // The end itself, not what rounding makes of it.
  point.position.values[segment.polar.linear] = segment.polar.linear_end;
  point.position.values[segment.polar.rotary] = segment.polar.rotary_end;
}

void evaluate(const PathSegment& segment, double s, double speed, double acceleration, PathPoint& point) {
  evaluate_in_its_plane(segment, s, speed, acceleration, point);
  if (segment.polar.active) turn_into_axes(segment.polar, point);
}

void extend_range(const PathSegment& segment, AxisVector& low, AxisVector& high) {
  if (segment.polar.active) return extend_polar_range(segment, low, high);
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    low.values[i] = std::min({low.values[i], segment.start.values[i], segment.end.values[i]});
    high.values[i] = std::max({high.values[i], segment.start.values[i], segment.end.values[i]});
  }
  if (!segment.is_arc) return;
  // Where the radius vector points along an axis: at every quarter turn inside the sweep. The fifth repeats
  // the first one turn later, except on a spiral, whose widest turn is at one of its ends.
  const ArcPath& arc = segment.arc;
  const double quarter = 0.5 * std::numbers::pi;
  const double sweep = arc.angle_slope * segment.length;
  const double from = std::min(arc.angle, arc.angle + sweep) / quarter;
  const double to = std::max(arc.angle, arc.angle + sweep) / quarter;
  const auto visit = [&](double quarters) {
    if (quarters < from || quarters > to) return;
    const double s = (quarters * quarter - arc.angle) / arc.angle_slope;
    const double radius = arc.radius + arc.radius_slope * s;
    extend(low, high, arc.first, arc.center[0] + radius * std::cos(quarters * quarter));
    extend(low, high, arc.second, arc.center[1] + radius * std::sin(quarters * quarter));
  };
  for (int i = 0; i < 4; ++i) {
    visit(std::ceil(from) + i);
    visit(std::floor(to) - i);
  }
}

}  // namespace kerf
