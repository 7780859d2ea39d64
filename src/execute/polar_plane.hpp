#pragma once
// Moves in the plane of a linear and a rotary axis (PolarPlane).

#include "execute/action.hpp"
#include "geometry/planar_segment.hpp"

namespace kerf {

/// The line or arc that the move runs on the work, in mm from the centre of rotation, turned by half a turn
/// when the linear axis works on the minus side: so the distance from the centre is |r| and the angle of a
/// point that of the rotary axis (PolarPlane). For either form.
PlanarSegment polar_contour(const Move& move);

/// The same move with the coordinates of the plane for those of the axes.
Move in_polar_plane(const Move& move);

}  // namespace kerf
