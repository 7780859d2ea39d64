#pragma once
// A spiral whose radius goes evenly with the angle (of Archimedes), by the length of its way.

namespace kerf {

/// Radii stay above 0 over the whole of it; the growth is not 0.
struct Spiral {
  double radius = 1.0;  ///< at the start, mm
  double growth = 1.0;  ///< of the radius, mm a radian; below 0 inwards
};

/// Whether an arc between two radii is a spiral and not just out of round: they differ by more than a
/// thousandth.
bool is_spiral(double start_radius, double end_radius);

/// The way of an arc of an angle, radians, whose radius goes evenly from one to the other.
double way_of_arc(double start_radius, double end_radius, double angle);

/// Radius after an angle, radians.
inline double radius_after(const Spiral& spiral, double angle) {
  return spiral.radius + spiral.growth * angle;
}

/// The way after an angle, mm: the integral of sqrt(r2 + k2) over the angle, with k the growth, is
/// (r sqrt(r2 + k2) + k2 asinh(r / |k|)) / 2k between both radii.
double way_after(const Spiral& spiral, double angle);

/// The angle after a way, radians; not above `whole`, the angle of the whole spiral. Newton's method, a few
/// steps: the slope of the way stays between the radius and the growth.
double angle_after(const Spiral& spiral, double way, double whole);

}  // namespace kerf
