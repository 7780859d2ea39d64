// G00 to G03 and the Z move of the tool-length offset.

#include <algorithm>
#include <cmath>

#include "dialect/dgshape/block_run.hpp"
#include "execute/moves.hpp"
#include "geometry/arc_construction.hpp"

namespace kerf::dgshape {
namespace {

constexpr WordMask kAxisWords = mask_of("XYZA");
constexpr WordMask kArcWords = mask_of("XYZAIJKR");

Plane plane_of(CodeNumber number) {
  if (number == code(18)) return kPlaneZX;
  if (number == code(19)) return kPlaneYZ;
  return kPlaneXY;
}

/// Address of the centre word of an axis.
char centre_address(Axis axis) {
  return axis == Axis::X ? 'I' : axis == Axis::Y ? 'J' : 'K';
}

}  // namespace

bool BlockRun::motion() {
  if (words_.has(Group::scaling) && words_[Group::scaling] == code(51)) return length_move();
  const CodeNumber mode = registers.modal[Group::motion];
  const bool is_arc_mode = mode > code(1);
  if ((words_.present() & (is_arc_mode ? kArcWords : kAxisWords)) == 0) return length_move();
  if (is_arc_mode) return arc();
  return straight(mode == code(0) ? MoveMode::rapid : MoveMode::linear);
}

bool BlockRun::length_move() {
  if (registers.length_offset == registers.length_applied) return true;
  // Without an axis word a tool-length block is a move of distance zero plus the offset (manual G43).
  const bool rapid = registers.modal[Group::motion] == code(0);
  // Only the offset moves the axis: nothing is cut, so the spindle may stand still.
  if (!rapid && !feed_available()) return false;
  if (!push_move(rapid ? MoveMode::rapid : MoveMode::linear, registers.position)) return false;
  last_move().axis_words = false;
  return true;
}

bool BlockRun::feed_available() {
  return registers.feed_given || settings_.minimum_feed_without_f || refuse("no-feed", block_.span);
}

bool BlockRun::cutting_allowed() {
  if (!feed_available()) return false;
  if (registers.spindle_on) return true;
  if (settings_.spindle_interlock) return refuse("spindle-stopped", block_.span);
  if (!registers.spindle_warned) warn("spindle-off", block_.span);
  registers.spindle_warned = true;
  return true;
}

bool BlockRun::push_rapid(const AxisVector& target) {
  AxisSet moving;
  for (Axis axis : {Axis::X, Axis::Y, Axis::Z, Axis::A}) {
    if (target[axis] != registers.position[axis]) moving.insert(axis);
  }
  if (moving.size() <= settings_.rapid_axes) return push_move(MoveMode::rapid, target);
  if (!settings_.split_rapid) {
    return refuse("rapid-axes", block_.span,
                  FixedText<200>::format("{} axes move at once; the machine can move {}.", moving.size(),
                                         settings_.rapid_axes));
  }
  AxisVector step = registers.position;
  std::int64_t taken = 0;
  for (Axis axis : moving) {
    step[axis] = target[axis];
    const bool full = ++taken % settings_.rapid_axes == 0 || taken == moving.size();
    if (full && !push_move(MoveMode::rapid, step)) return false;
  }
  return true;
}

bool BlockRun::straight(MoveMode mode) {
  AxisVector target = registers.position;
  if (!target_of_words("XYZA", target)) return false;
  const bool still = target == registers.position && registers.length_offset == registers.length_applied;
  // A block without distance matters only to the radius compensation, which may end on it.
  if (still && !offset_on() && !registers.offset_return_pending) return true;
  if (mode == MoveMode::rapid) return push_rapid(target);
  if (!cutting_allowed()) return false;
  const double tip_y = registers.position[Axis::Y] - origin_[Axis::Y];
  const double tip_z = registers.position[Axis::Z] - origin_[Axis::Z];
  const bool turns = target[Axis::A] != registers.position[Axis::A];
  if (!push_move(MoveMode::linear, target)) return false;
  if (turns) {
    Move& move = last_move();
    const bool at_top = move.start[Axis::Z] >= rules_.machine()[Axis::Z].upper_limit;
    move.rotary_feed = {true, at_top, Axis::A, std::hypot(tip_y, tip_z)};
  }
  return true;
}

bool BlockRun::arc_words(const Plane& plane) {
  if (words_.has('A')) return refuse("arc-axis", span('A'));
  const char wrong = centre_address(plane.third);
  if (words_.has(wrong)) {
    return refuse("centre-word", span(wrong),
                  FixedText<200>::format("{} is no centre word of the plane G{}.", wrong,
                                         registers.modal[Group::plane] / 10));
  }
  const bool centre = words_.has(centre_address(plane.first)) || words_.has(centre_address(plane.second));
  if (centre && words_.has('R')) {
    return refuse("arc-words", span('R'), "The block gives both the centre and the radius of the arc.");
  }
  if (!centre && !words_.has('R')) {
    return refuse("arc-words", block_.span, "The block gives neither the centre nor the radius of the arc.");
  }
  return true;
}

bool BlockRun::arc_geometry(const Plane& plane, const AxisVector& target, bool clockwise, Arc& out) {
  const Vec2 start{registers.position[plane.first], registers.position[plane.second]};
  const Vec2 end{target[plane.first], target[plane.second]};
  ArcResult result;
  if (words_.has('R')) {
    double radius = 0.0;
    if (!read_distance('R', radius)) return false;
    result = arc_from_radius(start, end, scaled_length(radius), clockwise, settings_.arc_tolerance);
  } else {
    Vec2 centre = start;
    for (Axis axis : {plane.first, plane.second}) {
      const char address = centre_address(axis);
      if (!words_.has(address)) continue;
      double distance = 0.0;
      if (!read_distance(address, distance)) return false;
      (axis == plane.first ? centre.x : centre.y) += scaled_length(distance);
    }
    result = arc_from_center(start, end, centre, clockwise, settings_.arc_tolerance);
  }
  switch (result.fault) {
    case ArcFault::none:
      break;
    case ArcFault::radius_difference:
      return refuse("arc-radius", block_.span,
                    FixedText<200>::format(
                        "The radius at the start and at the end of the arc differ by {:.4f} mm; {} mm "
                        "is allowed.",
                        result.difference_mm, settings_.arc_tolerance));
    case ArcFault::zero_radius:
      return refuse("arc-radius", block_.span, "The radius of the arc is zero.");
    case ArcFault::chord_too_long:
      return refuse("arc-radius", block_.span,
                    FixedText<200>::format("The radius is {:.4f} mm too small to reach the end point.",
                                           result.difference_mm));
    case ArcFault::end_equals_start:
      return refuse("arc-radius", span('R'), "With R the end point must differ from the start point.",
                    "Write a full circle with I, J, K.");
  }
  out = {{result.arc.center.x, result.arc.center.y}, result.arc.radius, result.arc.sweep_deg};
  return true;
}

bool BlockRun::arc() {
  const Plane plane = plane_of(registers.modal[Group::plane]);
  if (!arc_words(plane)) return false;
  if (registers.length_offset != registers.length_applied) {
    return refuse("conflicting-codes", span(Group::length_compensation),
                  "The tool-length offset cannot change on an arc.");
  }
  AxisVector target = registers.position;
  if (!target_of_words("XYZ", target)) return false;
  const bool clockwise = registers.modal[Group::motion] == code(2);
  Arc geometry;
  if (!arc_geometry(plane, target, clockwise, geometry) || !cutting_allowed()) return false;
  // The Z of the centre in G18 and G19 moves with the tool-length offset like every other Z.
  if (plane.first == Axis::Z) geometry.center[0] += registers.length_applied;
  if (plane.second == Axis::Z) geometry.center[1] += registers.length_applied;
  const MoveMode mode = clockwise ? MoveMode::clockwise : MoveMode::counterclockwise;
  if (!push_move(mode, target, plane, geometry)) return false;
  last_move().axis_words = true;
  return true;
}

}  // namespace kerf::dgshape
