#pragma once
// Corners of the tool radius compensation: where the tool centre leaves the parallel of one programmed
// segment and enters the parallel of the next.
//
// The corner angle a is measured between the two paths on the workpiece side: a >= 180 degrees is an inner
// corner, 90 <= a < 180 outer obtuse, a < 90 outer acute (DGSHAPE NC code reference 2-2, "Definitions of
// Inner Side and Outer Side"). Outer corners use the tangents of the parallels: obtuse ones turn at the
// intersection of the tangents, acute ones prolong both tangents by the offset amount and join them straight.

#include <cstdint>

#include "base/fixed_vector.hpp"
#include "execute/toolpath_policy.hpp"
#include "geometry/planar_segment.hpp"

namespace kerf {

struct CornerRules {
  double left_mm = 0.0;  ///< offset to the left of travel; negative: to the right
  double small_angle_deg =
      1.0;  ///< at such outer angles type B falls back to A, and inner angles join straight
  double joint_gap_mm = 0.01;  ///< parallels that miss each other by no more are joined straight
  bool rounds_acute = false;   ///< acute outer corners are gone around on an arc about the corner
};

/// A programmed segment and the path of the tool centre beside it.
struct OffsetSegment {
  PlanarSegment programmed;
  PlanarSegment offset;
  double left_mm = 0.0;  ///< of the offset
  Vec2 begins;           ///< directions of travel at the ends of the programmed segment, length 1
  Vec2 ends;
};

/// The parallel from the point at right angles to the start to the point at right angles to the end. An arc
/// whose offset radius is at most 0.0001 mm, more or less than nothing, shrinks to its centre (offset.radius
/// 0).
OffsetSegment offset_of(const PlanarSegment& programmed, double left_mm);
/// The same, but an arc smaller than the tool is run on the far side of its centre.
OffsetSegment offset_turned_over(const PlanarSegment& programmed, double left_mm);

/// True when the tool is too large for the inside of an arc, by more than 0.0001 mm.
bool is_arc_too_small(const PlanarSegment& programmed, double left_mm);

/// Move the end or the start of a segment along its curve, keeping the sweep of an arc right. They return how
/// much is left: 1 for a line; for an arc the remaining sweep in the direction of travel, degrees, negative
/// when nothing is left.
double end_at(PlanarSegment& segment, Vec2 point);
double begin_at(PlanarSegment& segment, Vec2 point);

/// Corner angle on the workpiece side in degrees, 0 <= a < 360; an exact reversal, to 0.001 degrees, is 0.
double workpiece_angle_deg(Vec2 tangent_in, Vec2 tangent_out, double left_mm);

bool is_inner(double workpiece_angle_deg);

enum class CornerFault : std::uint8_t {
  none,
  apart,           ///< the parallels do not meet
  first_used_up,   ///< the meeting point lies before the start of the first arc
  second_used_up,  ///< the meeting point lies behind the end of the second arc
};

/// The way of the tool centre around a corner: the first segment ends at the first point, the tool goes
/// straight from point to point or, around a round corner, on an arc, and the second segment begins at the
/// last.
struct Corner {
  FixedVector<Vec2, 4> points;  ///< never empty without a fault; neighbours are at least 1e-6 mm apart
  bool gentle = false;  ///< of two straight segments that turn by less than a right angle: the one point
                        ///< where their parallels meet. The tool keeps out of both on its way there and
                        ///< from there.
  bool fixed = false;   ///< commanded by the program: no interference removes it
  bool round = false;   ///< an arc about `about` leads from the first of two points to the second
  Vec2 about;           ///< of a round corner: the programmed corner
  CornerFault fault = CornerFault::none;
  double gap_mm = 0.0;  ///< with CornerFault::apart: the distance by which the parallels miss each other
};

/// Where the parallels of two straight lines through `at` meet. Not for reversals.
inline Vec2 turning_point(Vec2 at, Vec2 tangent_in, Vec2 tangent_out, double left_mm) {
  const Vec2 bisector = left_of(tangent_in) + left_of(tangent_out);
  return at + left_mm / (1.0 + dot(tangent_in, tangent_out)) * bisector;
}

/// Two straight lines that turn by less than a right angle. `turn_cosine`: of the angle between them.
inline bool is_gentle(double turn_cosine) {
  return turn_cosine > 1e-6;
}

/// The way of the tool between two neighbouring points of the corner, `behind` the place of the second.
PlanarSegment way_between(const Corner& corner, std::size_t behind, double left_mm);

inline constexpr double kSamePoint = 1e-6;  ///< mm; joints shorter than this are left out

inline Corner corner_at(Vec2 point) {
  Corner corner;
  corner.points.push_back(point);
  return corner;
}

/// Between two compensated segments. The offset of `first` may have been shortened at its start by the corner
/// before.
Corner crossover_corner(const OffsetSegment& first, const OffsetSegment& next, const CornerRules& rules);

/// Between two segments on different sides of the path: where the parallels meet, at most two amounts from
/// the corner; where they do not, from the point at right angles to the end of the first to the one at right
/// angles to the start of the next.
Corner side_change_corner(const OffsetSegment& first, const OffsetSegment& next);

/// From a segment to the parallel of an imagined straight block along `direction`, on whichever side of the
/// corner they meet; at right angles to the end of the segment where they do not.
Corner imagined_corner(const OffsetSegment& first, Vec2 direction);

/// From the straight starting block, which comes along `tangent_in`, to the first compensated segment.
/// `beside`: type B comes by the point at right angles to the end of that block.
Corner start_corner(Vec2 tangent_in, const OffsetSegment& next, StartType type, const CornerRules& rules,
                    bool beside = false);

/// From the last compensated segment to the straight ending block, which leaves along `tangent_out`.
/// `beside`: type B goes on to the point at right angles to the start of that block.
Corner end_corner(const OffsetSegment& first, Vec2 tangent_out, StartType type, const CornerRules& rules,
                  bool beside = false);

}  // namespace kerf
