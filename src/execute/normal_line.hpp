#pragma once
// Normal line control: a rotary axis that keeps the tool at right angles to the path (MELSEC 6.6).

#include "execute/action.hpp"
#include "execute/toolpath_policy.hpp"

namespace kerf {

/// What the axis does for a move, in degrees, counterclockwise positive.
struct NormalTurn {
  double before = 0.0;     ///< at rest in front of it
  double during = 0.0;     ///< evenly along it: on arcs
  bool wrong_way = false;  ///< the axis would have to turn against the direction that is commanded
};

/// The turns for a move with Move::normal_line from the angle where the axis stands, degrees from the first
/// axis of the plane. `first`: the control begins with it, so the axis takes the shorter way whatever the
/// type.
/// - Angles at joints that are smaller than the least angle, and moves shorter than the least way (arcs:
/// whose
///   diameter is), turn nothing.
/// - Type I turns the shorter way; type II only clockwise on the left side and only counterclockwise on the
/// right
///   side, and up to the least angle more than half a turn either way.
/// - Type II on the inside of an arc that is smaller than the tool's radius is the wrong way, too.
NormalTurn normal_turn(const Move& move, double angle_deg, bool first, const NormalLinePolicy& policy);

/// Whether the move has a direction in its plane.
bool has_direction(const Move& move);

}  // namespace kerf
