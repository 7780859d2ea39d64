#pragma once
// One stretch of a contour, a straight line or an arc, with a direction of travel.

#include "geometry/circular_arc.hpp"
#include "geometry/vec2.hpp"

namespace kerf {

struct PlanarSegment {
  Vec2 start;
  Vec2 end;
  bool is_arc = false;
  Vec2 center;             ///< of an arc
  double radius = 0.0;     ///< of an arc, mm, >= 0
  double sweep_deg = 0.0;  ///< of an arc, positive counterclockwise
};

PlanarSegment straight(Vec2 start, Vec2 end);

/// The caller's start and end are kept as they are; they lie on the circle.
PlanarSegment curved(Vec2 start, Vec2 end, Vec2 center, double radius, double sweep_deg);

/// Direction of travel at the start and at the end, length 1. A straight segment of no length has none: {0,
/// 0}.
Vec2 start_tangent(const PlanarSegment& segment);
Vec2 end_tangent(const PlanarSegment& segment);

/// mm
double length_of(const PlanarSegment& segment);

/// Radius of an arc moved to the left by `left_mm` everywhere; negative when no such arc exists. mm
double offset_radius(const PlanarSegment& arc, double left_mm);

/// The parallel at `left_mm` to the left of the direction of travel (to the right when negative). An arc
/// needs offset_radius() >= 0 (up to rounding); at 0 it becomes a point with the same sweep.
PlanarSegment offset_segment(const PlanarSegment& segment, double left_mm);
/// The same for a segment whose directions of travel at its ends are known.
PlanarSegment offset_segment(const PlanarSegment& segment, double left_mm, Vec2 begins, Vec2 ends);

}  // namespace kerf
