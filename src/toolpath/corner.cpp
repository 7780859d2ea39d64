#include "toolpath/corner.hpp"

#include <cmath>

#include "geometry/segment_distance.hpp"

namespace kerf {
namespace {

constexpr double kLeastRadius = 1e-4;     // mm; the least increment of the machines
constexpr double kAngleRounding = 1e-9;   // degrees
constexpr double kSideChangeReach = 2.0;  // amounts
constexpr double kReversal = 1e-3;        // degrees from an exact reversal; inner corners would be far away

void add_point(Corner& corner, Vec2 point) {
  if (corner.points.empty() || distance(corner.points.back(), point) >= kSamePoint)
    corner.points.push_back(point);
}

Corner straight_between(Vec2 from, Vec2 to) {
  Corner corner;
  add_point(corner, from);
  add_point(corner, to);
  return corner;
}

Corner faulty(CornerFault fault, double gap_mm = 0.0) {
  Corner corner;
  corner.fault = fault;
  corner.gap_mm = gap_mm;
  return corner;
}

// The points around an outer corner on the tangents alone.
void add_outer_points(Corner& corner, double angle_deg, Vec2 at, Vec2 tangent_in, Vec2 tangent_out,
                      double left_mm) {
  if (angle_deg >= 90.0 - kAngleRounding) {
    add_point(corner, turning_point(at, tangent_in, tangent_out, left_mm));
    return;
  }
  const double reach = std::abs(left_mm);
  add_point(corner, at + left_mm * left_of(tangent_in) + reach * tangent_in);
  add_point(corner, at + left_mm * left_of(tangent_out) - reach * tangent_out);
}

// A line through the programmed direction: the shortened parallel may have been turned round or have no
// length left.
PlanarSegment endless(const OffsetSegment& segment, double left_mm) {
  return segment.offset.is_arc ? segment.offset : offset_segment(segment.programmed, left_mm);
}

CornerFault trimmed_fault(PlanarSegment first, Vec2 first_end, PlanarSegment next, Vec2 next_start) {
  // An arc may lose all of its length to rounding, but not more.
  const auto gone = [](double left_deg, double radius) { return radius * radians(left_deg) < -kSamePoint; };
  if (gone(end_at(first, first_end), first.radius)) return CornerFault::first_used_up;
  if (gone(begin_at(next, next_start), next.radius)) return CornerFault::second_used_up;
  return CornerFault::none;
}

// Inner corner with at least one arc: the meeting point of the parallels nearest to the corner.
Corner inner_corner(const OffsetSegment& first, const OffsetSegment& next, const CornerRules& rules) {
  const Vec2 first_end = first.offset.end;
  const Vec2 next_start = next.offset.start;
  // An almost tangent joint: the parallels may miss each other or meet far away, and their ends all but
  // touch. Beside a tool smaller than the gap they do so at sharp corners, too.
  const bool goes_on = dot(first.ends, next.begins) > 0.0;
  const bool almost_tangent = goes_on && distance(first_end, next_start) <= rules.joint_gap_mm;
  const Meeting meeting = meeting_of_curves(endless(first, rules.left_mm), endless(next, rules.left_mm));
  const std::optional<Vec2> nearest = nearest_point(meeting, first.programmed.end);
  if (almost_tangent && (!nearest || distance(*nearest, first_end) > rules.joint_gap_mm))
    return straight_between(first_end, next_start);
  if (!nearest && meeting.gap_mm > rules.joint_gap_mm) return faulty(CornerFault::apart, meeting.gap_mm);

  const Vec2 leave = nearest.value_or(meeting.nearest_on_first);
  const Vec2 enter = nearest.value_or(meeting.nearest_on_second);
  const CornerFault fault = trimmed_fault(first.offset, leave, next.offset, enter);
  if (fault == CornerFault::none) return straight_between(leave, enter);
  return almost_tangent ? straight_between(first_end, next_start) : faulty(fault);
}

OffsetSegment parallel_of(const PlanarSegment& programmed, double left_mm) {
  const Vec2 begins = start_tangent(programmed);
  const Vec2 ends = programmed.is_arc ? end_tangent(programmed) : begins;
  return {programmed, offset_segment(programmed, left_mm, begins, ends), left_mm, begins, ends};
}

}  // namespace

bool is_arc_too_small(const PlanarSegment& programmed, double left_mm) {
  return programmed.is_arc && offset_radius(programmed, left_mm) < -kLeastRadius;
}

OffsetSegment offset_of(const PlanarSegment& programmed, double left_mm) {
  OffsetSegment segment = parallel_of(programmed, left_mm);
  if (programmed.is_arc && segment.offset.radius <= kLeastRadius) {
    segment.offset.radius = 0.0;
    segment.offset.start = segment.offset.end = programmed.center;
  }
  return segment;
}

OffsetSegment offset_turned_over(const PlanarSegment& programmed, double left_mm) {
  const double radius = programmed.is_arc ? offset_radius(programmed, left_mm) : 1.0;
  if (radius > -kLeastRadius) return offset_of(programmed, left_mm);
  OffsetSegment segment = parallel_of(programmed, left_mm);
  segment.offset.radius = -radius;
  return segment;
}

double end_at(PlanarSegment& segment, Vec2 point) {
  const Vec2 before = segment.end;
  segment.end = point;
  if (!segment.is_arc) return 1.0;
  const double direction = segment.sweep_deg < 0.0 ? -1.0 : 1.0;
  const double left = std::abs(segment.sweep_deg) +
                      ahead_deg(before - segment.center, point - segment.center, direction < 0.0);
  segment.sweep_deg = left * direction;
  return left;
}

double begin_at(PlanarSegment& segment, Vec2 point) {
  const Vec2 before = segment.start;
  segment.start = point;
  if (!segment.is_arc) return 1.0;
  const double direction = segment.sweep_deg < 0.0 ? -1.0 : 1.0;
  const double left = std::abs(segment.sweep_deg) -
                      ahead_deg(before - segment.center, point - segment.center, direction < 0.0);
  segment.sweep_deg = left * direction;
  return left;
}

double workpiece_angle_deg(Vec2 tangent_in, Vec2 tangent_out, double left_mm) {
  const double turn = turn_deg(tangent_in, tangent_out);
  const double angle = left_mm < 0.0 ? 180.0 - turn : 180.0 + turn;
  return angle < kReversal || angle > 360.0 - kReversal ? 0.0 : angle;
}

bool is_inner(double workpiece_angle_deg) {
  return workpiece_angle_deg >= 180.0 - kAngleRounding;
}

Corner crossover_corner(const OffsetSegment& first, const OffsetSegment& next, const CornerRules& rules) {
  const Vec2 at = first.programmed.end;
  const Vec2 tangent_in = first.ends;
  const Vec2 tangent_out = next.begins;
  const Vec2 gap = next.offset.start - first.offset.end;
  const bool straight_on = is_gentle(dot(tangent_in, tangent_out)) && !first.offset.is_arc &&
                           !next.offset.is_arc && rules.small_angle_deg < 90.0;
  if (dot(gap, gap) < kSamePoint * kSamePoint) {
    Corner corner = corner_at(first.offset.end);
    corner.gentle = straight_on;
    return corner;
  }
  if (straight_on) {
    // The same point whether it is an inner or an outer corner.
    Corner corner = corner_at(turning_point(at, tangent_in, tangent_out, rules.left_mm));
    corner.gentle = true;
    return corner;
  }
  const double angle = workpiece_angle_deg(tangent_in, tangent_out, rules.left_mm);
  if (is_inner(angle)) {
    if (angle >= 360.0 - rules.small_angle_deg - kAngleRounding)
      return straight_between(first.offset.end, next.offset.start);
    if (first.offset.is_arc || next.offset.is_arc) return inner_corner(first, next, rules);
    const Vec2 turning = turning_point(at, tangent_in, tangent_out, rules.left_mm);
    return straight_between(turning, turning);
  }
  if (rules.rounds_acute && angle < 90.0 - kAngleRounding) {
    Corner corner = straight_between(first.offset.end, next.offset.start);
    corner.round = true;
    corner.about = at;
    return corner;
  }
  Corner corner;
  if (first.offset.is_arc) add_point(corner, first.offset.end);
  add_outer_points(corner, angle, at, tangent_in, tangent_out, rules.left_mm);
  if (next.offset.is_arc) add_point(corner, next.offset.start);
  return corner;
}

PlanarSegment way_between(const Corner& corner, std::size_t behind, double left_mm) {
  const Vec2 from = corner.points[behind - 1];
  const Vec2 to = corner.points[behind];
  if (!corner.round) return straight(from, to);
  // At an outer corner the tool turns away from its own side.
  const bool clockwise = left_mm > 0.0;
  double sweep = ahead_deg(from - corner.about, to - corner.about, clockwise);
  if (sweep <= 0.0) sweep += 360.0;
  return curved(from, to, corner.about, std::abs(left_mm), clockwise ? -sweep : sweep);
}

Corner side_change_corner(const OffsetSegment& first, const OffsetSegment& next) {
  const PlanarSegment along = endless(first, first.left_mm);
  const PlanarSegment on = endless(next, next.left_mm);
  const std::optional<Vec2> meeting = nearest_point(meeting_of_curves(along, on), first.programmed.end);
  const double reach = kSideChangeReach * std::max(std::abs(first.left_mm), std::abs(next.left_mm));
  if (!meeting || distance(*meeting, first.programmed.end) > reach + kSamePoint)
    return straight_between(first.offset.end, next.offset.start);
  return straight_between(*meeting, *meeting);
}

Corner imagined_corner(const OffsetSegment& first, Vec2 direction) {
  const Vec2 at = first.programmed.end;
  const PlanarSegment imagined = offset_segment(straight(at, at + unit(direction)), first.left_mm);
  const PlanarSegment along = endless(first, first.left_mm);
  const std::optional<Vec2> meeting = nearest_point(meeting_of_curves(along, imagined), at);
  const Vec2 point = meeting.value_or(first.offset.end);
  return straight_between(point, point);
}

Corner start_corner(Vec2 tangent_in, const OffsetSegment& next, StartType type, const CornerRules& rules,
                    bool beside) {
  const Vec2 tangent_out = next.begins;
  const double angle = workpiece_angle_deg(tangent_in, tangent_out, rules.left_mm);
  const bool around =
      type == StartType::B && !is_inner(angle) && angle > rules.small_angle_deg + kAngleRounding;
  Corner corner;
  if (around) {
    if (beside) add_point(corner, next.programmed.start + rules.left_mm * left_of(tangent_in));
    add_outer_points(corner, angle, next.programmed.start, tangent_in, tangent_out, rules.left_mm);
    if (!next.offset.is_arc) return corner;
  }
  add_point(corner, next.offset.start);
  return corner;
}

Corner end_corner(const OffsetSegment& first, Vec2 tangent_out, StartType type, const CornerRules& rules,
                  bool beside) {
  const Vec2 tangent_in = first.ends;
  const double angle = workpiece_angle_deg(tangent_in, tangent_out, rules.left_mm);
  const bool around =
      type == StartType::B && !is_inner(angle) && angle > rules.small_angle_deg + kAngleRounding;
  Corner corner;
  if (!around || first.offset.is_arc) add_point(corner, first.offset.end);
  if (around) add_outer_points(corner, angle, first.programmed.end, tangent_in, tangent_out, rules.left_mm);
  if (around && beside) add_point(corner, first.programmed.end + rules.left_mm * left_of(tangent_out));
  return corner;
}

}  // namespace kerf
