#pragma once
// How fast the path may pass from one segment to the next.

#include "base/axis.hpp"
#include "motion/axis_limits.hpp"

namespace kerf {

/// Turns below this (radians) count as tangent when the junction deviation is 0: positions in steps of 0.0001
/// mm cannot say more of a joint between segments of about a millimetre.
inline constexpr double kTangentTurn = 1e-4;

/// Square of the highest speed, (mm/s)2, at the joint of two segments whose directions of travel are `from`
/// and `to`; infinite when they agree. The path itself stays exact: the axes step in velocity at the corner.
///
/// Two limits, the lower counts. With t the turning angle and `a` the acceleration that the axes have in the
/// plane of the two directions:
/// - a circle tangent to both legs that misses the corner by the deviation d has the radius
///   d sin(h) / (1 - sin(h)), h = (pi - t) / 2 being half the angle between the legs; it is passed with the
///   centripetal acceleration a: v2 = a d sin(h) / (1 - sin(h)) (Jeon and Ha 2000; Skogsrud's cornering
///   rule). d = 0: stop.
/// - short segments stand for a curve that turns by t on the mean of their lengths l, so has the radius l /
/// t:
///   v2 = a l / t.
///
/// A step of curvature at a tangent joint (line to arc, arc to counter-arc) sets no limit of its own: each
/// side keeps within the axes' acceleration, and a law without a limit of jerk asks no more.
double junction_speed_squared(const AxisVector& from, const AxisVector& to, double mean_length,
                              double deviation, const AxisLimits& limits);

}  // namespace kerf
