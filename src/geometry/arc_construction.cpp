#include "geometry/arc_construction.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kSamePoint = 1e-9;  // mm; also what rounding may add to a length

// How many tolerances the far side of a nearly closed arc may move when its centre is corrected.
constexpr double kFarSideReach = 4.0;

// Turn from one radius to another in the direction of the arc, degrees in (0, 360] or [-360, 0).
double sweep_between(Vec2 from, Vec2 to, bool clockwise) {
  const double turn = turn_deg(from, to);
  if (clockwise) return turn < 0.0 ? turn : turn - 360.0;
  return turn > 0.0 ? turn : turn + 360.0;
}

ArcResult fault(ArcFault kind, double difference_mm = 0.0) {
  return {{}, kind, difference_mm};
}

}  // namespace

ArcResult arc_from_center(Vec2 start, Vec2 end, Vec2 center, bool clockwise, double tolerance_mm) {
  const double start_radius = distance(center, start);
  if (start_radius <= kSamePoint) return fault(ArcFault::zero_radius);
  const double chord = distance(start, end);
  if (chord <= kSamePoint) return {{center, start_radius, clockwise ? -360.0 : 360.0}, ArcFault::none, 0.0};

  const double difference = std::abs(distance(center, end) - start_radius);
  const double tolerance = tolerance_mm + kSamePoint;
  if (difference > tolerance) return fault(ArcFault::radius_difference, difference);

  const Vec2 along = (end - start) / chord;
  const double shift = dot(midpoint(start, end) - center, along);
  const Vec2 corrected = center + shift * along;
  const double programmed_sweep = sweep_between(start - center, end - center, clockwise);
  const bool far_side = std::abs(programmed_sweep) > 180.0;
  if (far_side && 2.0 * std::abs(shift) > kFarSideReach * tolerance)
    return fault(ArcFault::radius_difference, difference);
  return {
      {corrected, distance(corrected, start), sweep_between(start - corrected, end - corrected, clockwise)},
      ArcFault::none,
      difference};
}

ArcResult spiral_from_center(Vec2 start, Vec2 end, Vec2 center, bool clockwise, double tolerance_mm) {
  constexpr double kNoWay = 1e-6;  // mm, far below the least increment
  const double start_radius = distance(center, start);
  const double end_radius = distance(center, end);
  if (std::min(start_radius, end_radius) <= kNoWay) return fault(ArcFault::zero_radius);
  const double difference = std::abs(end_radius - start_radius);
  if (difference > tolerance_mm + kSamePoint) return fault(ArcFault::radius_difference, difference);
  const double turn = turn_deg(start - center, end - center);
  const bool whole = radians(std::abs(turn)) * start_radius < kNoWay;
  const double sweep =
      whole ? (clockwise ? -360.0 : 360.0) : sweep_between(start - center, end - center, clockwise);
  return {{center, start_radius, sweep}, ArcFault::none, difference};
}

ArcResult arc_from_radius(Vec2 start, Vec2 end, double signed_radius, bool clockwise, double tolerance_mm) {
  const double radius = std::abs(signed_radius);
  if (radius <= kSamePoint) return fault(ArcFault::zero_radius);
  const double chord = distance(start, end);
  if (chord <= kSamePoint) return fault(ArcFault::end_equals_start);

  const double half = 0.5 * chord;
  const double direction = clockwise ? -1.0 : 1.0;
  const Vec2 middle = midpoint(start, end);
  if (radius <= half) {
    const double missing = half - radius;
    if (missing > tolerance_mm + kSamePoint) return fault(ArcFault::chord_too_long, missing);
    return {{middle, half, 180.0 * direction}, ArcFault::none, missing};
  }

  const double height = std::sqrt((radius - half) * (radius + half));
  const bool major = signed_radius < 0.0;
  // The centre of a counterclockwise arc of less than 180 degrees lies to the left of its chord.
  const double side = major ? -direction : direction;
  const Vec2 center = middle + (side * height / chord) * left_of(end - start);
  const double minor_sweep = 2.0 * degrees(std::atan2(half, height));
  return {{center, radius, direction * (major ? 360.0 - minor_sweep : minor_sweep)}, ArcFault::none, 0.0};
}

}  // namespace kerf
