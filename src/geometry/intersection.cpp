#include "geometry/intersection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf {
namespace {

constexpr double kTouch = 1e-9;        // mm
constexpr double kParallel = 1e-12;    // sine of the angle between lines
constexpr double kSameCenter = 1e-12;  // mm

Meeting miss(Vec2 on_first, Vec2 on_second) {
  Meeting meeting;
  meeting.gap_mm = distance(on_first, on_second);
  meeting.nearest_on_first = on_first;
  meeting.nearest_on_second = on_second;
  return meeting;
}

// Points at `half` on both sides of `middle`, one when they fall together.
Meeting pair_around(Vec2 middle, Vec2 direction, double half) {
  Meeting meeting;
  if (half <= 0.0) {
    meeting.points.push_back(middle);
  } else {
    meeting.points.push_back(middle - half * direction);
    meeting.points.push_back(middle + half * direction);
  }
  return meeting;
}

}  // namespace

PlanarLine line_through(Vec2 from, Vec2 to) {
  return {from, unit(to - from)};
}

PlanarLine offset_line(const PlanarLine& line, double left_mm) {
  return {line.point + left_mm * left_of(line.direction), line.direction};
}

Vec2 foot_on(const PlanarLine& line, Vec2 point) {
  return line.point + dot(point - line.point, line.direction) * line.direction;
}

Meeting meeting_of(const PlanarLine& first, const PlanarLine& second) {
  const double sine = cross(first.direction, second.direction);
  if (std::abs(sine) < kParallel) return miss(first.point, foot_on(second, first.point));
  Meeting meeting;
  meeting.points.push_back(first.point +
                           cross(second.point - first.point, second.direction) / sine * first.direction);
  return meeting;
}

Meeting meeting_of(const PlanarLine& first, const PlanarCircle& second) {
  const Vec2 foot = foot_on(first, second.center);
  const double away = distance(second.center, foot);
  if (away > second.radius + kTouch)
    return miss(foot, second.center + second.radius / away * (foot - second.center));
  const double squared = (second.radius - away) * (second.radius + away);
  return pair_around(foot, first.direction, std::sqrt(std::max(squared, 0.0)));
}

Meeting meeting_of(const PlanarCircle& first, const PlanarLine& second) {
  Meeting meeting = meeting_of(second, first);
  std::swap(meeting.nearest_on_first, meeting.nearest_on_second);
  return meeting;
}

Meeting meeting_of(const PlanarCircle& first, const PlanarCircle& second) {
  const double apart = distance(first.center, second.center);
  if (apart < kSameCenter)
    return miss(first.center + Vec2{first.radius, 0.0}, first.center + Vec2{second.radius, 0.0});
  const Vec2 axis = (second.center - first.center) / apart;
  if (apart > first.radius + second.radius + kTouch)
    return miss(first.center + first.radius * axis, second.center - second.radius * axis);
  if (apart < std::abs(first.radius - second.radius) - kTouch) {
    const double towards = first.radius > second.radius ? 1.0 : -1.0;
    return miss(first.center + towards * first.radius * axis, second.center + towards * second.radius * axis);
  }
  // Distance of the common chord from the first centre, from the law of cosines.
  const double along =
      0.5 * (apart + (first.radius - second.radius) * (first.radius + second.radius) / apart);
  const double squared = (first.radius - along) * (first.radius + along);
  return pair_around(first.center + along * axis, left_of(axis), std::sqrt(std::max(squared, 0.0)));
}

std::optional<Vec2> nearest_point(const Meeting& meeting, Vec2 to) {
  std::optional<Vec2> best;
  for (const Vec2 point : meeting.points)
    if (!best || distance(point, to) < distance(*best, to)) best = point;
  return best;
}

}  // namespace kerf
