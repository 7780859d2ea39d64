#pragma once
// Moves as the tool radius compensation sees them: in their plane.

#include "execute/action.hpp"
#include "toolpath/corner.hpp"
#include "toolpath/path_queue.hpp"

namespace kerf {

inline constexpr double kNoLength = 1e-6;  ///< mm

/// mm to the left of travel; negative: to the right.
inline double left_offset(const RadiusCompensation& compensation) {
  return compensation.side == Side::right ? -compensation.amount : compensation.amount;
}

inline const char* side_name(double left_mm) {
  return left_mm < 0.0 ? "right" : "left";
}

/// The positions lie apart in the plane.
inline bool is_apart(const Plane& plane, const AxisVector& a, const AxisVector& b) {
  const Vec2 way = in_plane(b, plane) - in_plane(a, plane);
  return dot(way, way) > kNoLength * kNoLength;
}

/// The move goes somewhere in the plane.
inline bool has_motion(const Plane& plane, const Move& move) {
  return is_arc(move.mode) || is_apart(plane, move.start, move.end);
}

/// A straight move between two positions would go nowhere, in no axis.
inline bool goes_nowhere(const Plane& plane, const AxisVector& start, const AxisVector& end) {
  if (is_apart(plane, start, end)) return false;
  return start == with_point(end, plane, in_plane(start, plane));
}

/// From start to end, length 1; {0, 0} of a move without motion in the plane.
inline Vec2 plane_direction(const Plane& plane, const Move& move) {
  if (!has_motion(plane, move)) return {};
  return unit(in_plane(move.end, plane) - in_plane(move.start, plane));
}

inline PlanarSegment segment_of(const Move& move, const Plane& plane) {
  const Vec2 start = in_plane(move.start, plane);
  const Vec2 end = in_plane(move.end, plane);
  if (!is_arc(move.mode)) return straight(start, end);
  return curved(start, end, {move.arc.center[0], move.arc.center[1]}, move.arc.radius, move.arc.sweep);
}

}  // namespace kerf
