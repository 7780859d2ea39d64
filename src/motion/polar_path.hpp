#pragma once
// Segments in a polar plane: planned in its coordinates, given out in those of its axes.

#include "motion/path_segment.hpp"

namespace kerf {

/// Sets what turns the coordinates of the plane into those of the axes, for a move of PolarForm::axes whose
/// other parts are set from in_polar_plane(move), and lowers speed and acceleration to what both axes allow.
///
/// With turn, turn2 and radius2 the derivatives of angle and distance by the way (polar_rates), the axes have
/// the speeds turn v and at most v, and the accelerations turn a + turn2 v2 and at most a + radius2 v2. The
/// parts in v2 take at most 0.8 of what the axes have (kCentripetalShare); the rest is left along the path.
void set_polar_limits(PathSegment& segment, const Move& move, const AxisLimits& limits, double feed_now);

/// Limits for the same segment without those of the two axes, which set_polar_limits() adds.
AxisLimits without_polar_axes(const AxisLimits& limits, const PolarPlane& polar);

/// Limits of the plane's coordinates at the nearest point of the segment to the centre.
AxisLimits limits_in_polar_plane(const PolarPath& polar, const AxisLimits& limits);

/// extend_range() of a segment in a polar plane.
void extend_polar_range(const PathSegment& segment, AxisVector& low, AxisVector& high);

/// Makes a point of the plane one of the axes. Segments turn less than half a turn around the centre.
void turn_into_axes(const PolarPath& polar, PathPoint& point);

}  // namespace kerf
