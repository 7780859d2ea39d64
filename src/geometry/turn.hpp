#pragma once
// Turning the points of a plane about a centre.

#include "geometry/vec2.hpp"

namespace kerf {

/// Sine and cosine of an angle in degrees; quarter turns are exact.
struct Turn {
  double sine = 0.0;
  double cosine = 1.0;
};

Turn turn_by(double degrees);

/// Counterclockwise about the centre.
constexpr Vec2 turned(Vec2 point, Vec2 center, Turn turn) {
  const Vec2 arm = point - center;
  return center + Vec2{arm.x * turn.cosine - arm.y * turn.sine, arm.x * turn.sine + arm.y * turn.cosine};
}

/// Clockwise about the centre: takes back turned().
constexpr Vec2 turned_back(Vec2 point, Vec2 center, Turn turn) {
  return turned(point, center, {-turn.sine, turn.cosine});
}

}  // namespace kerf
