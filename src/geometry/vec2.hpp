#pragma once
// Points and directions in a plane.

#include <cmath>
#include <numbers>

namespace kerf {

/// Degrees to radians and back.
constexpr double radians(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}
constexpr double degrees(double radians) {
  return radians * (180.0 / std::numbers::pi);
}

/// A point in mm, or a direction. Angles are counted counterclockwise from the x axis.
struct Vec2 {
  double x = 0.0;
  double y = 0.0;

  constexpr Vec2& operator+=(Vec2 other) {
    x += other.x;
    y += other.y;
    return *this;
  }
  constexpr Vec2& operator-=(Vec2 other) {
    x -= other.x;
    y -= other.y;
    return *this;
  }
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return a += b; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return a -= b; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(Vec2 a, double factor) { return {a.x * factor, a.y * factor}; }
  friend constexpr Vec2 operator*(double factor, Vec2 a) { return a * factor; }
  friend constexpr Vec2 operator/(Vec2 a, double divisor) { return {a.x / divisor, a.y / divisor}; }
  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

constexpr double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}

/// Third component of the vector product: positive when b points to the left of a.
constexpr double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// Not for squares that overflow, which lengths in mm never do.
inline double length(Vec2 a) {
  return std::sqrt(dot(a, a));
}

inline double distance(Vec2 a, Vec2 b) {
  return length(b - a);
}

constexpr Vec2 midpoint(Vec2 a, Vec2 b) {
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
}

/// The vector turned by 90 degrees to the left.
constexpr Vec2 left_of(Vec2 a) {
  return {-a.y, a.x};
}

/// The direction of length 1; the zero vector stays zero.
inline Vec2 unit(Vec2 a) {
  const double size = length(a);
  return size > 0.0 ? a / size : Vec2{};
}

inline Vec2 direction_at(double angle_deg) {
  return {std::cos(radians(angle_deg)), std::sin(radians(angle_deg))};
}

inline Vec2 rotated(Vec2 a, double angle_deg) {
  const Vec2 turn = direction_at(angle_deg);
  return {a.x * turn.x - a.y * turn.y, a.x * turn.y + a.y * turn.x};
}

/// Direction of a vector, degrees in (-180, 180].
inline double angle_of_deg(Vec2 a) {
  return degrees(std::atan2(a.y, a.x));
}

/// Signed angle that turns `from` into `to`, degrees in [-180, 180]; positive to the left.
inline double turn_deg(Vec2 from, Vec2 to) {
  return degrees(std::atan2(cross(from, to), dot(from, to)));
}

}  // namespace kerf
