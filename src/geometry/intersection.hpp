#pragma once
// Where straight lines and circles of a plane meet, or how far they miss each other.

#include <optional>

#include "base/fixed_vector.hpp"
#include "geometry/vec2.hpp"

namespace kerf {

/// An endless straight line.
struct PlanarLine {
  Vec2 point;
  Vec2 direction;  ///< length 1
};

/// The line from one point towards another, which must differ.
PlanarLine line_through(Vec2 from, Vec2 to);

/// The line moved sideways, positive to the left of its direction. mm
PlanarLine offset_line(const PlanarLine& line, double left_mm);

/// The point of the line nearest to a point.
Vec2 foot_on(const PlanarLine& line, Vec2 point);

struct PlanarCircle {
  Vec2 center;
  double radius = 0.0;  ///< mm, >= 0; 0 is a point
};

/// Where two curves meet.
struct Meeting {
  FixedVector<Vec2, 2> points;  ///< empty when the curves do not meet, or meet everywhere
  double gap_mm = 0.0;          ///< when there are no points: shortest distance between the curves
  Vec2 nearest_on_first;   ///< when there are no points: where the curves come closest; one such place when
  Vec2 nearest_on_second;  ///< there are many (parallel lines, circles around the same centre)
};

/// Curves that miss each other by less than 1e-9 mm touch. Parallel lines and circles around the same centre
/// never meet.
Meeting meeting_of(const PlanarLine& first, const PlanarLine& second);
Meeting meeting_of(const PlanarLine& first, const PlanarCircle& second);
Meeting meeting_of(const PlanarCircle& first, const PlanarLine& second);
Meeting meeting_of(const PlanarCircle& first, const PlanarCircle& second);

/// The meeting point nearest to a point; nothing when the curves do not meet.
std::optional<Vec2> nearest_point(const Meeting& meeting, Vec2 to);

}  // namespace kerf
