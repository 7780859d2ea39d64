#pragma once
// Arcs as programs write them: by a centre, or by a radius with a sign.

#include <cstdint>

#include "geometry/vec2.hpp"

namespace kerf {

/// An arc whose start and end points the caller knows.
struct PlanarArc {
  Vec2 center;
  double radius = 0.0;     ///< mm
  double sweep_deg = 0.0;  ///< positive counterclockwise
};

/// Why no arc can be made.
enum class ArcFault : std::uint8_t {
  none,
  radius_difference,  ///< start and end radius differ by more than the tolerance
  zero_radius,        ///< the start (of a spiral, the end) lies on the centre, or R is 0
  chord_too_long,     ///< R is shorter than half the chord by more than the tolerance
  end_equals_start,   ///< with R: the centre is anywhere
};

struct ArcResult {
  PlanarArc arc;  ///< meaningful only without a fault
  ArcFault fault = ArcFault::none;
  /// |end radius - start radius| of an arc by centre; by how much R is shorter than half the chord, else 0,
  /// of an arc by radius. mm
  double difference_mm = 0.0;
};

/// The arc from start to end around a centre. Start and end at the same point (within 1e-9 mm) make a full
/// circle.
///
/// When the end is not exactly on the circle through the start but the radii differ by no more than the
/// tolerance, the centre moves onto the perpendicular bisector of the chord by the shortest way, so that the
/// arc ends at the end point. An arc of up to 180 degrees then leaves the programmed circle by at most the
/// difference of the radii. The more an arc nears a full circle, the further its far side moves for the same
/// difference; where that exceeds four times the tolerance, the fault is radius_difference.
ArcResult arc_from_center(Vec2 start, Vec2 end, Vec2 center, bool clockwise, double tolerance_mm);

/// The same with the centre left where it is: the radius goes evenly from that of the start, which is the
/// radius of the arc, to that of the end. Start and end in one direction from the centre, to 1e-6 mm, make a
/// whole turn.
ArcResult spiral_from_center(Vec2 start, Vec2 end, Vec2 center, bool clockwise, double tolerance_mm);

/// The arc from start to end with a radius: up to 180 degrees when the radius is positive, more than 180
/// degrees when it is negative. A radius shorter than half the chord by no more than the tolerance makes a
/// half circle.
ArcResult arc_from_radius(Vec2 start, Vec2 end, double signed_radius, bool clockwise, double tolerance_mm);

}  // namespace kerf
