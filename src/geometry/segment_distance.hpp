#pragma once
// Where stretches of a contour meet, and how near they come to each other.

#include "geometry/intersection.hpp"
#include "geometry/planar_segment.hpp"

namespace kerf {

/// Where the curves meet of which two segments are stretches: endless lines and whole circles.
Meeting meeting_of_curves(const PlanarSegment& first, const PlanarSegment& next);

/// The distance of a segment from a point. mm
double distance_to(const PlanarSegment& segment, Vec2 point);

/// The shortest distance between the points of two segments, 0 where they meet. mm
double distance_between(const PlanarSegment& a, const PlanarSegment& b);

}  // namespace kerf
