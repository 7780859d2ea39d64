#pragma once
// The geometry of one move along a path parameter, and the speed and acceleration it allows.
//
// The path parameter s is the length of the path in all axes together, millimetres and degrees alike, so that
// a speed in s that does not change from one segment to a tangent one leaves every axis's velocity unchanged.
// On lines ds2 = sum of the squared steps of all axes; on arcs the circle counts with its mean radius and the
// other axes follow linearly. On the legs of a rapid move whose axes go by themselves (Move::each_axis) s is
// the way of the axis that arrives last: it does not slow down where another one has arrived. That one steps
// in velocity there, which is told as a corner step.
//
// Feeds are measured otherwise (`feed_length`):
// - lines: along the X-Y-Z path; when none of these moves, along the path of the axes that do (degree/min for
// a
//   rotary axis alone); with MotionSettings::feed_of_all_axes along the path of all axes, degrees counted as
//   mm (MELSEC 6.3);
// - arcs and helices: along the circle in the plane (UNSPECIFIED row DGS-219, the rule of JIS
//   controllers), or with Move::feed_in_space along the X-Y-Z path (OMRON, G02 and G03);
// - with RotaryFeed (DGSHAPE 1-4, 2-5): the rotary axis turns at F / radius [rad/min], constant over the
// block; when
//   X, Y or Z move in the same block it takes the longer of the two times. With radius 0 or at_maximum the
//   rotary axis asks for its highest rate.

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/axis.hpp"
#include "execute/action.hpp"
#include "geometry/vec2.hpp"
#include "motion/axis_limits.hpp"

namespace kerf {

/// Where the axes are and how they move. Axes that the machine lacks are 0.
struct PathPoint {
  AxisVector position;      ///< machine coordinates, mm or degrees
  AxisVector velocity;      ///< mm/s or degree/s
  AxisVector acceleration;  ///< mm/s2 or degree/s2, tangential and centripetal
};

/// The circle of an arc, as functions of s. Where start and end radius differ by rounding or a little, radius
/// and angle go evenly with s; where they differ more, s is true to the way along the spiral. The end point
/// may lie off the programmed angle by rounding: `drift` spreads that over the arc so that both ends are
/// exact.
struct ArcPath {
  std::uint8_t first = 0;  ///< plane axes
  std::uint8_t second = 1;
  std::array<double, 2> center{};
  double angle = 0.0;         ///< of the start, radians
  double angle_slope = 0.0;   ///< d angle / ds; of a spiral the mean
  double radius = 0.0;        ///< at the start
  double radius_slope = 0.0;  ///< d radius / ds; of a spiral the mean
  std::array<double, 2> drift{};
  bool is_spiral = false;  ///< and not just out of round
  double growth = 0.0;     ///< of a spiral: of the radius, mm a radian
  double share = 1.0;      ///< way in the plane for a unit of s
};

/// From the coordinates of a polar plane, in which everything else of the segment is given, to those of its
/// axes (PolarPlane).
struct PolarPath {
  bool active = false;
  std::uint8_t linear = 0;
  std::uint8_t rotary = 0;
  double side = 1.0;        ///< -1: the linear axis works on the minus side
  double center = 0.0;      ///< machine coordinate of the linear axis over the centre of rotation
  double angle = 0.0;       ///< machine coordinate of the rotary axis at the start, degrees
  Vec2 direction;           ///< of the start, seen from the centre and from that side; length 1
  Vec2 at_center;           ///< likewise where the segment begins or ends in the centre
  double nearest = 0.0;     ///< least distance from the centre, mm
  double linear_end = 0.0;  ///< where the axes stand at the end
  double rotary_end = 0.0;
};

struct PathSegment {
  AxisVector start;
  AxisVector end;
  AxisVector slope;  ///< d position / ds; 0 for the plane axes of an arc
  ArcPath arc;
  PolarPath polar;
  bool is_arc = false;
  bool rapid = false;
  bool at_maximum = false;     ///< the axes' limits alone decide the speed
  double length = 0.0;         ///< of s; 0: the move does not move
  double length_mm = 0.0;      ///< way of the tool in X, Y and Z
  double feed_mm_min = 0.0;    ///< programmed
  double feed_per_speed = 60;  ///< mm/min of feed for 1 mm/s of s
  double speed_limit = 0.0;    ///< of s, mm/s: axis rates and centripetal acceleration, whatever the feed
  double acceleration = 0.0;   ///< of s, mm/s2, available everywhere on the segment up to speed_limit
};

/// Moves shorter than this do not move.
inline constexpr double kShortestLength = 1e-9;

/// Share of an arc's acceleration that the centripetal part may take; 0.6 of it are then left along the path
/// (0.8^2 + 0.6^2 = 1).
inline constexpr double kCentripetalShare = 0.8;

/// Fills in the segment of a move. `feed_now` is the effective feed in mm/min: on arcs the acceleration along
/// the path is what the centripetal acceleration at twice the larger of it and the programmed feed leaves,
/// and speed_limit keeps to that, so that a later rise of the override finds the planned acceleration still
/// available.
///
/// Limits on lines: every axis's rate and acceleration divided by its share of the direction. On arcs the
/// plane axes count with the smaller limit of the two, as the direction turns.
void set_path(PathSegment& segment, const Move& move, const AxisLimits& limits, double feed_now);

/// Direction of travel d position / ds at the start and the end, in a polar plane in its coordinates; of
/// length 1, on arcs that are a little out of round nearly so.
AxisVector start_tangent(const PathSegment& segment);
AxisVector end_tangent(const PathSegment& segment);

/// The limits that count at the joint in front of the segment.
const AxisLimits& joint_limits(const PathSegment& segment, const AxisLimits& limits, AxisLimits& own);

/// The point at s for the speed and acceleration of s.
void evaluate(const PathSegment& segment, double s, double speed, double acceleration, PathPoint& point);

/// The axes at the end of the segment, for a speed of s there.
void evaluate_end(const PathSegment& segment, double speed, PathPoint& point);

/// The way of two axes is not proportional to s: their extremes must be looked for.
bool is_curved(const PathSegment& segment);
/// These two; only of a curved segment.
std::array<std::size_t, 2> curved_axes(const PathSegment& segment);
/// d position / ds of the others.
AxisVector even_slope(const PathSegment& segment);

/// Widens [low, high] of every axis by the segment.
void extend_range(const PathSegment& segment, AxisVector& low, AxisVector& high);

}  // namespace kerf
