#pragma once
// From programmed positions to where the axes stand: coordinate rotation (manual 5.6, G68) and tool length
// offset (G43, G44).

#include "execute/state.hpp"

namespace kerf::melsec {

/// The axes that move when a block names `named`: a rotated plane moves as a whole.
AxisSet moving_axes(const Placement& placement, AxisSet named);

/// Where the axes stand behind a move of `moving` to a programmed position; the other axes stay.
AxisVector machine_position(const Placement& placement, const AxisVector& programmed, AxisSet moving);

/// A point of the rotated plane in machine coordinates, without tool length; any other plane's stays as it
/// is.
Vec2 turned_point(const Placement& placement, const Plane& plane, Vec2 programmed);

/// The programmed position of the rotated plane's axes that the axes really stand at (`turned`), or would
/// stand at without rotation.
void place_plane_at_machine(const Placement& placement, bool turned, AxisVector& programmed);

}  // namespace kerf::melsec
