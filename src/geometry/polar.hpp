#pragma once
// A contour as it is seen from the origin: by how much it turns around it, and how near it comes.

#include "geometry/planar_segment.hpp"

namespace kerf {

/// Contours that come nearer to the origin than this count as running through it. mm
inline constexpr double kThroughOrigin = 1e-6;

/// The angle in (-180, 180] by which one direction lies from another, from an angle in degrees.
double shortest_turn_deg(double angle_deg);

/// The angle that a point which runs along the segment turns through, seen from the origin; degrees, positive
/// counterclockwise, whole turns included. On an arc the radius may go evenly from that of the start to the
/// distance between end and centre (spiral). The segment does not run through the origin but may begin or
/// end there: then the angle is that of the rest of it.
///
/// With the centre c and the radius R of a circle, the direction of c + R e^(i f) is f + arg(1 + c/R e^(-i
/// f)) when the origin lies inside of the circle and arg(c) + arg(1 + R/c e^(i f)) otherwise; either second
/// part stays within half a turn, so that the difference between both ends holds the turns.
double turn_around_origin_deg(const PlanarSegment& segment);

/// Ranges over a segment that does not run through the origin.
struct PolarRange {
  double least_radius = 0.0;  ///< distance from the origin, mm
  double greatest_radius = 0.0;
  double least_turn_deg = 0.0;  ///< from the direction of the start, <= 0
  double greatest_turn_deg = 0.0;
};

PolarRange polar_range(const PlanarSegment& segment);

/// The part of the segment, in (0, 1), after which it runs through the origin; 0: it does not, or only at an
/// end.
double part_before_origin(const PlanarSegment& segment);

/// The segment between two parts of it, 0 <= from < to <= 1.
PlanarSegment part_of(const PlanarSegment& segment, double from, double to);

/// How fast direction and distance change along a segment, largest magnitudes.
struct PolarRates {
  double turn = 0.0;        ///< d angle / ds, rad/mm
  double turn2 = 0.0;       ///< d2 angle / ds2, rad/mm2
  double radius2 = 0.0;     ///< d2 distance / ds2, 1/mm
  double least_turn = 0.0;  ///< smallest magnitude of the first
};

/// On a line at the distance d from the origin: turn = d / r2. On a circle with m = r2 + R2 - c2: turn = m /
/// (2 R r2), radius2 = m (m - 2 r2) / (4 R2 r3) = ((m - r2)2 / r3 - r) / (4 R2); both follow from r2 = c2 +
/// R2 + 2 c . R u.
PolarRates polar_rates(const PlanarSegment& segment);

}  // namespace kerf
