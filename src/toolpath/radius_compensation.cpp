#include "toolpath/radius_compensation.hpp"

#include <cassert>
#include <cmath>

namespace kerf {
namespace {

constexpr double kNoLength = 1e-6;  // mm

double left_offset(const RadiusCompensation& compensation) {
  return compensation.side == Side::right ? -compensation.amount : compensation.amount;
}

const char* side_name(double left_mm) {
  return left_mm < 0.0 ? "right" : "left";
}

double plane_distance(const Plane& plane, const AxisVector& a, const AxisVector& b) {
  return distance(in_plane(a, plane), in_plane(b, plane));
}

bool has_motion(const Plane& plane, const Move& move) {
  return is_arc(move.mode) || plane_distance(plane, move.start, move.end) > kNoLength;
}

bool is_nothing(const Plane& plane, const Move& move, const AxisVector& start) {
  if (is_arc(move.mode) || plane_distance(plane, start, move.end) > kNoLength) return false;
  return start == with_point(move.end, plane, in_plane(start, plane));
}

Vec2 plane_direction(const Plane& plane, const Move& move) {
  if (!has_motion(plane, move)) return {};
  return unit(in_plane(move.end, plane) - in_plane(move.start, plane));
}

PlanarSegment segment_of(const Move& move, const Plane& plane) {
  const Vec2 start = in_plane(move.start, plane);
  const Vec2 end = in_plane(move.end, plane);
  if (!is_arc(move.mode)) return straight(start, end);
  return curved(start, end, {move.arc.center[0], move.arc.center[1]}, move.arc.radius, move.arc.sweep);
}

Corner corner_at(Vec2 point) {
  Corner corner;
  corner.points.push_back(point);
  return corner;
}

}  // namespace

RadiusCompensationPass::RadiusCompensationPass(const RadiusCompensationPolicy& policy) : policy_(policy) {
  assert(policy.start_with_arc != nullptr && policy.end_with_arc != nullptr);
  assert(policy.inner_arc_radius != nullptr && policy.no_crossover != nullptr);
  assert(policy.side_change != nullptr && policy.corner_arc_outside != nullptr);
}

void RadiusCompensationPass::reset() {
  out_.clear();
  turn_off(false);
  after_alarm_ = false;
}

// ---- what comes in

bool RadiusCompensationPass::passes_through(const Action& action) {
  if (const Move* move = std::get_if<Move>(&action.what))
    return move->compensation.side == Side::none || !has_motion(move->plane, *move);
  return !std::holds_alternative<CornerArc>(action.what);
}

void RadiusCompensationPass::push(const Action& action) {
  if (std::holds_alternative<CornerArc>(action.what)) {
    push_corner_arc(action);
  } else if (state_ == State::off) {
    push_while_off(action);
  } else if (const Move* move = std::get_if<Move>(&action.what)) {
    push_move(action, *move);
  } else if (std::holds_alternative<End>(action.what)) {
    finish();
    out_.add(action);
  } else {
    push_motionless(action);
  }
}

void RadiusCompensationPass::push_while_off(const Action& action) {
  const Move* move = std::get_if<Move>(&action.what);
  if (move == nullptr) return out_.add(action);

  if (!displaced_) out_.set_position(move->start);
  const bool commanded = move->compensation.side != Side::none && has_motion(move->plane, *move);
  if (move->compensation.side == Side::none) after_alarm_ = false;
  if (commanded && !is_arc(move->mode)) {
    start(action, *move);
  } else if (commanded && !after_alarm_) {
    raise(
        policy_.start_with_arc, action.origin,
        FixedText<200>::format("The compensation starts with an arc of radius {:.3f} mm", move->arc.radius));
  } else {
    out_.add_rejoined(action.origin, *move);
    displaced_ = false;
  }
}

void RadiusCompensationPass::push_move(const Action& action, const Move& move) {
  const bool moves = has_motion(plane_, move);
  const double left_mm = left_offset(move.compensation);
  if (move.compensation.side == Side::none) {
    if (moves || (move.axis_words && move.plane == plane_)) return end(action, move);
  } else if (move.compensation.start != held_move().compensation.start && moves) {
    finish();
    return push_while_off(action);
  } else if (left_mm != left_mm_) {
    return raise(
        policy_.side_change, action.origin,
        FixedText<200>::format("The offset changes from {:.3f} mm {} to {:.3f} mm {}", std::abs(left_mm_),
                               side_name(left_mm_), std::abs(left_mm), side_name(left_mm)));
  } else if (moves && move.plane != plane_) {
    return raise(policy_.side_change, action.origin,
                 FixedText<200>::format("The plane of the compensation changes from {}{} to {}{}",
                                        letter(plane_.first), letter(plane_.second), letter(move.plane.first),
                                        letter(move.plane.second)));
  } else if (moves) {
    return advance(action, move);
  }
  push_motionless(action);
}

void RadiusCompensationPass::push_corner_arc(const Action& action) {
  if (state_ == State::off)
    return out_.add({action.origin, Alarm{policy_.corner_arc_outside, action.origin.span, {}, {}}});
  corner_arc_block_ = action.origin.block;
  const auto& arc = std::get<CornerArc>(action.what);
  const Vec2 direction = unit(Vec2{arc.direction[0], arc.direction[1]});
  if (direction != Vec2{} && !corner_turn(direction)) return;
  if (out_.is_waiting_full()) settle();
  if (out_.is_waiting_full()) drop_corner_arc();
  out_.wait(action);
  has_corner_arc_ = true;
  if (direction == Vec2{}) return;
  if (state_ != State::settled) leave_held_at_right_angles();
  release_waiting(direction);
}

// An action that does not move the tool in the plane waits until the path before it is known.
void RadiusCompensationPass::push_motionless(const Action& action) {
  if (look_ahead_fails(action.origin) || out_.is_waiting_full()) settle();
  if (out_.is_waiting_full()) drop_corner_arc();
  out_.wait(action);
  if (state_ == State::settled) release_waiting({});
}

// ---- the course of a compensation

void RadiusCompensationPass::start(const Action& action, const Move& move) {
  plane_ = move.plane;
  left_mm_ = left_offset(move.compensation);
  displaced_ = after_alarm_ = has_corner_arc_ = false;
  corner_arc_block_ = 0;
  held_ = action;
  held_segment_.programmed = straight(point(), in_plane(move.end, plane_));
  held_segment_.offset = offset_segment(held_segment_.programmed, left_mm_);
  held_segment_.offset.start = point();
  state_ = State::starting;
}

void RadiusCompensationPass::advance(const Action& action, const Move& move) {
  const PlanarSegment programmed = segment_of(move, plane_);
  if (is_arc_too_small(programmed, left_mm_))
    return raise(policy_.inner_arc_radius, action.origin,
                 FixedText<200>::format("The offset {:.4f} mm is larger than the radius {:.4f} mm of the arc",
                                        std::abs(left_mm_), move.arc.radius));
  const OffsetSegment next = offset_of(programmed, left_mm_);
  if (look_ahead_fails(action.origin)) settle();

  const Vec2 direction = start_tangent(programmed);
  if (has_corner_arc_ && corner_turn(direction)) settle();
  if (state_ != State::settled) {
    const Corner corner = corner_to(next);
    if (corner.fault != CornerFault::none) return raise_corner_fault(corner, action.origin);
    leave_held(corner);
    release_waiting(direction);
  } else {
    release_waiting(direction);
    if (distance(point(), next.offset.start) > kNoLength)
      out_.add_joint(action.origin, move, with_point(out_.position(), plane_, next.offset.start));
  }
  hold(action, next);
}

void RadiusCompensationPass::end(const Action& action, const Move& move) {
  if (is_arc(move.mode))
    return raise(
        policy_.end_with_arc, action.origin,
        FixedText<200>::format("The compensation ends with an arc of radius {:.3f} mm", move.arc.radius));
  if (look_ahead_fails(action.origin)) settle();
  const Vec2 direction = plane_direction(plane_, move);
  if (has_corner_arc_ && corner_turn(direction)) settle();
  if (state_ != State::settled) leave_held(corner_to_end(move));
  release_waiting(direction);
  drop_corner_arc();
  out_.add_move(action.origin, move);
  turn_off(false);
}

// The end of the actions, or of the program.
void RadiusCompensationPass::finish() {
  if (state_ == State::off) return;
  settle();
  drop_corner_arc();
  turn_off(true);
}

void RadiusCompensationPass::turn_off(bool displaced) {
  state_ = State::off;
  displaced_ = displaced;
  has_corner_arc_ = false;
}

// ---- the move held back

// The segment begins where the tool stands.
void RadiusCompensationPass::hold(const Action& action, const OffsetSegment& segment) {
  held_ = action;
  held_segment_ = segment;
  begin_at(held_segment_.offset, point());
  has_corner_arc_ = false;
  corner_arc_block_ = 0;
  state_ = State::running;
}

void RadiusCompensationPass::leave_held(const Corner& corner) {
  add_held(corner.points[0]);
  for (std::size_t i = 1; i < corner.points.size(); ++i)
    out_.add_joint(held_.origin, held_move(), with_point(out_.position(), plane_, corner.points[i]));
  facing_ = end_tangent(held_segment_.programmed);
  state_ = State::settled;
}

void RadiusCompensationPass::leave_held_at_right_angles() {
  leave_held(corner_at(held_segment_.offset.end));
}

// The look-ahead ends here: nothing is held back any longer.
void RadiusCompensationPass::settle() {
  if (state_ == State::settled) return;
  leave_held_at_right_angles();
  release_waiting({});
}

// The actions that wait, in order, up to a corner arc whose direction is not known yet.
void RadiusCompensationPass::release_waiting(Vec2 next_direction) {
  while (Action* action = out_.first_waiting()) {
    Vec2 to = point();
    if (const CornerArc* arc = std::get_if<CornerArc>(&action->what)) {
      Vec2 direction = unit(Vec2{arc->direction[0], arc->direction[1]});
      if (direction == Vec2{}) direction = next_direction;
      if (direction == Vec2{}) return;
      const std::optional<CornerTurn> turn = corner_turn(direction);
      if (turn && state_ == State::settled) {
        make_corner_arc(*action, *turn);
        to = turn->end;
        facing_ = direction;
      }
    }
    out_.release_first(plane_, to);
  }
  has_corner_arc_ = false;
}

// A corner arc still waits for a move that does not come: it is left out.
void RadiusCompensationPass::drop_corner_arc() {
  while (out_.first_waiting() != nullptr) out_.release_first(plane_, point());
  has_corner_arc_ = false;
}

void RadiusCompensationPass::add_held(Vec2 end) {
  Move move = held_move();
  move.end = with_point(move.end, plane_, end);
  PlanarSegment path = held_segment_.offset;
  if (path.is_arc) {
    const double left_deg = end_at(path, end);
    move.arc = {{path.center.x, path.center.y}, path.radius, path.sweep_deg};
    if (left_deg <= 0.0 || length_of(path) <= kNoLength) move.mode = MoveMode::linear;
  }
  if (!is_nothing(plane_, move, out_.position())) out_.add_move(held_.origin, move);
}

// The tool stands at right angles to the end of the held move, or where the last corner arc left it.
void RadiusCompensationPass::make_corner_arc(Action& action, const CornerTurn& turn) const {
  Move move = held_move();
  const Vec2 corner = held_segment_.programmed.end;
  move.mode = turn.sweep_deg < 0.0 ? MoveMode::clockwise : MoveMode::counterclockwise;
  move.rotary_feed = {};
  move.feed = std::get<CornerArc>(action.what).feed;
  move.arc = {{corner.x, corner.y}, std::abs(left_mm_), turn.sweep_deg};
  move.end = out_.position();
  action.what = move;
}

// ---- corners

Corner RadiusCompensationPass::corner_to(const OffsetSegment& next) const {
  if (state_ == State::starting)
    return start_corner(end_tangent(held_segment_.programmed), next, policy_.start_type, rules());
  return crossover_corner(held_segment_, next, rules());
}

Corner RadiusCompensationPass::corner_to_end(const Move& move) const {
  const Vec2 direction = plane_direction(plane_, move);
  if (direction == Vec2{}) return corner_at(held_segment_.offset.end);
  // Started and ended without a compensated move between: the tool comes to the point beside the start of the
  // last.
  if (state_ == State::starting)
    return corner_at(held_segment_.programmed.end + left_mm_ * left_of(direction));
  return end_corner(held_segment_, direction, policy_.start_type, rules());
}

// The turn of a corner arc to a direction; none when the corner is an inner one or there is nothing to turn.
std::optional<RadiusCompensationPass::CornerTurn> RadiusCompensationPass::corner_turn(Vec2 direction) const {
  if (direction == Vec2{}) return std::nullopt;
  const Vec2 facing = state_ == State::settled ? facing_ : end_tangent(held_segment_.programmed);
  const double angle = workpiece_angle_deg(facing, direction, left_mm_);
  const double turn_angle = 180.0 - angle;
  if (is_inner(angle) || std::abs(left_mm_) * radians(turn_angle) <= kNoLength) return std::nullopt;
  return CornerTurn{left_mm_ < 0.0 ? turn_angle : -turn_angle,
                    held_segment_.programmed.end + left_mm_ * left_of(direction)};
}

// Blocks strictly between the held move and the next action; a block may give several actions, so the
// action's own block does not count.
bool RadiusCompensationPass::look_ahead_fails(const Origin& next) const {
  if (state_ == State::settled || next.block <= held_.origin.block) return false;
  std::uint32_t between = next.block - held_.origin.block - 1;
  if (corner_arc_block_ < next.block && corner_arc_block_ > held_.origin.block) --between;
  return between >= policy_.blocks_without_motion;
}

// ---- alarms

void RadiusCompensationPass::raise(const AlarmKind* kind, const Origin& origin,
                                   const FixedText<200>& message) {
  if (state_ != State::off) settle();
  drop_corner_arc();
  out_.add({origin, Alarm{kind, origin.span, message, {}}});
  turn_off(true);
  after_alarm_ = true;
}

void RadiusCompensationPass::raise_corner_fault(const Corner& corner, const Origin& next) {
  const AxisVector at = held_move().commanded;
  const FixedText<64> place =
      FixedText<64>::format("at {}{:.3f} {}{:.3f} with an offset of {:.3f} mm", letter(plane_.first),
                            at[plane_.first], letter(plane_.second), at[plane_.second], std::abs(left_mm_));
  if (corner.fault == CornerFault::apart)
    return raise(policy_.no_crossover, next,
                 FixedText<200>::format("The offset paths miss each other by {:.3f} mm {}", corner.gap_mm,
                                        place.view()));
  if (corner.fault == CornerFault::second_used_up)
    return raise(policy_.no_crossover, next,
                 FixedText<200>::format("Nothing is left of the arc behind the corner {}", place.view()));
  // The move before the corner cannot be made at all.
  state_ = State::settled;
  raise(policy_.no_crossover, held_.origin,
        FixedText<200>::format("Nothing is left of the arc before the corner {}", place.view()));
}

}  // namespace kerf
