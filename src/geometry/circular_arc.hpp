#pragma once
// An arc by its own parameters, and what can be asked of it.

#include "geometry/vec2.hpp"

namespace kerf {

struct CircularArc {
  Vec2 center;
  double radius = 0.0;           ///< mm, >= 0
  double start_angle_deg = 0.0;  ///< direction from the centre to the start
  double sweep_deg = 0.0;        ///< positive counterclockwise; may exceed 360
};

/// The smallest upright rectangle around something.
struct PlanarBox {
  Vec2 low;
  Vec2 high;
};

/// Angle in degrees by which `to` lies ahead of `from` on the way round, in (-180, 180]; negative: behind.
double ahead_deg(Vec2 from, Vec2 to, bool clockwise);

/// The arc around a centre that begins at a point.
CircularArc arc_through(Vec2 start, Vec2 center, double sweep_deg);

Vec2 start_of(const CircularArc& arc);
Vec2 end_of(const CircularArc& arc);

/// The point after `swept_deg` of the sweep, with the sign of the sweep.
Vec2 point_on(const CircularArc& arc, double swept_deg);

/// Direction of travel after `swept_deg` of the sweep, length 1.
Vec2 tangent_on(const CircularArc& arc, double swept_deg);

/// mm
double length_of(const CircularArc& arc);

/// Bounds of all points of the arc, not only of its ends.
PlanarBox bounds_of(const CircularArc& arc);
/// The same for a spiral, whose radius goes evenly to `end_radius`, mm. Exact up to one turn.
PlanarBox bounds_of(const CircularArc& arc, double end_radius);

}  // namespace kerf
