#pragma once
// Moves in the plane of a linear and a rotary axis (PolarPlane).

#include "execute/action.hpp"
#include "geometry/planar_segment.hpp"

namespace kerf {

/// The line or arc that the move runs on the work, in mm from the centre of rotation, turned by half a turn
/// when the linear axis works on the minus side: so the distance from the centre is |r| and the angle of a
/// point that of the rotary axis (PolarPlane). For either form.
PlanarSegment polar_contour(const Move& move);

/// The position after a part of the way, 0 <= part <= 1; the ends themselves, not what rounding makes of
/// them.
AxisVector between(const AxisVector& from, const AxisVector& to, double part);

/// What the axes of a move of PolarForm::axes reach, machine coordinates: between its ends the linear axis
/// may come nearer to the centre of rotation than at either, and the rotary axis turn back on an arc.
struct PolarReach {
  double linear_low = 0.0;
  double linear_high = 0.0;
  double rotary_low = 0.0;
  double rotary_high = 0.0;
};

PolarReach polar_reach(const Move& move);

/// The same move with the coordinates of the plane for those of the axes.
Move in_polar_plane(const Move& move);

}  // namespace kerf
