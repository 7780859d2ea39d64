#pragma once
// What lies between the programmed position and the axes: mirroring, scaling and rotation of the coordinate
// system (manual G50, G51, G50.1, G51.1, G68, G69). A programmed position is a machine coordinate without
// tool length offset as it would be without them; mirroring acts first, then scaling, then rotation.

#include "execute/state.hpp"

namespace kerf::omron {

/// Some of mirroring, scaling and rotation are in force.
bool is_transformed(const Placement& placement);

/// Where a programmed position really lies.
AxisVector transformed(const Placement& placement, AxisVector programmed);

/// The programmed position of a real one.
AxisVector untransformed(const Placement& placement, AxisVector real);

/// The three, in the order in which they act.
enum class Change : std::uint8_t { mirroring, scaling, rotation };

/// A real position as it is in front of one of them.
AxisVector in_front_of(Change change, const Placement& placement, AxisVector real);

/// What an arc of a plane becomes.
struct ArcChange {
  bool is_round = true;  ///< false: an ellipse, which no arc is
  bool turns_over = false;
  double magnification = 1.0;  ///< of the radius
};

ArcChange arc_change(const Placement& placement, const Plane& plane);

/// Ends all three.
void release_transformations(Registers& registers);

}  // namespace kerf::omron
