// What comes into the pass, and the course of a compensation.

#include "toolpath/radius_compensation.hpp"

#include <cassert>
#include <cmath>

#include "toolpath/compensated_move.hpp"

namespace kerf {

RadiusCompensationPass::RadiusCompensationPass(const RadiusCompensationPolicy& policy)
    : policy_(policy), overcuts_(policy) {
  assert(policy.start_with_arc != nullptr && policy.end_with_arc != nullptr);
  assert(policy.inner_arc_radius != nullptr && policy.no_crossover != nullptr);
  assert(policy.side_change != nullptr && policy.corner_arc_outside != nullptr);
}

void RadiusCompensationPass::reset() {
  out_.clear();
  overcuts_.reset();
  turn_off(false);
  after_alarm_ = from_rest_ = unjoined_ = false;
}

// A start or an end that is commanded at rest; nobody behind needs the move.
bool RadiusCompensationPass::tells_only(const Move& move) const {
  return policy_.starts_at_rest && !is_arc(move.mode) && move.start == move.end;
}

bool RadiusCompensationPass::passes_through(const Action& action) const {
  if (const Move* move = std::get_if<Move>(&action.what)) {
    if (tells_only(*move)) return false;
    if (move->compensation.side == Side::none) return !from_rest_;
    return !policy_.starts_at_rest && !has_motion(move->plane, *move);
  }
  return !std::holds_alternative<CornerArc>(action.what);
}

void RadiusCompensationPass::push(const Action& action) {
  if (refuses_held(action)) {
    leave_before_and_stop();
    refuse(held().action.origin);
  } else if (std::holds_alternative<CornerArc>(action.what)) {
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

// The alarm that OvercutCheck puts behind a block.
bool RadiusCompensationPass::refuses_held(const Action& action) const {
  const Alarm* alarm = std::get_if<Alarm>(&action.what);
  return alarm != nullptr && overcuts_.is_on() && state_ == State::running &&
         alarm->kind == policy_.interference_alarm;
}

void RadiusCompensationPass::push_while_off(const Action& action) {
  const Move* move = std::get_if<Move>(&action.what);
  if (move == nullptr) return out_.add(action);

  if (!displaced_) out_.set_position(move->start);
  const bool side = move->compensation.side != Side::none;
  const bool commanded = side && has_motion(move->plane, *move) && !move->compensation.suspended;
  if (!side) after_alarm_ = from_rest_ = false;
  if (side && !has_motion(move->plane, *move) && policy_.starts_at_rest && !displaced_) {
    from_rest_ = true;
    at_rest_ = move->compensation;
    if (!tells_only(*move)) out_.add_rejoined(action.origin, *move);
  } else if (commanded && !is_arc(move->mode) && from_rest_) {
    start_from_rest(action, *move);
  } else if (commanded && !is_arc(move->mode)) {
    start(action, *move);
  } else if (commanded && !after_alarm_) {
    raise(
        policy_.start_with_arc, action.origin,
        FixedText<200>::format("The compensation starts with an arc of radius {:.3f} mm", move->arc.radius));
  } else if (displaced_ || !tells_only(*move)) {
    out_.add_rejoined(action.origin, *move);
    displaced_ = false;
  }
}

void RadiusCompensationPass::push_move(const Action& action, const Move& move) {
  const bool moves = has_motion(plane_, move);
  const double left_mm = left_offset(move.compensation);
  if (move.compensation.side == Side::none) {
    if (moves || (move.axis_words && move.plane == plane_)) return end(action, move);
  } else if (move.compensation.suspended) {
    return suspend(action, move);
  } else if (!moves && move.compensation.rule != VectorRule::computed) {
    change_at_rest(action.origin, move);
  } else if (move.compensation.start != held_move().compensation.start && moves) {
    finish();
    return push_while_off(action);
  } else if (left_mm != left_mm_ && !policy_.changes_in_force) {
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
  // The starting block leads to the corner beside the next one: there is nothing to turn about.
  const bool in_start = policy_.start_waits || action.origin.block == held().action.origin.block;
  if (state_ == State::starting && in_start) return;
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
  const bool stop = policy_.stop_ends_look_ahead && std::holds_alternative<Stop>(action.what);
  if (stop || look_ahead_fails(action.origin) || out_.is_waiting_full()) settle();
  // Where it would turn to stands behind what nothing is read across.
  if (stop && has_corner_arc_) drop_corner_arc();
  if (state_ == State::off) return push_while_off(action);
  if (out_.is_waiting_full()) drop_corner_arc();
  out_.wait(action);
  if (state_ == State::settled) release_waiting({});
}

// ---- the course of a compensation

void RadiusCompensationPass::start(const Action& action, const Move& move) {
  plane_ = move.plane;
  left_mm_ = left_offset(move.compensation);
  displaced_ = after_alarm_ = has_corner_arc_ = unjoined_ = false;
  corner_arc_block_ = 0;
  held().action = action;
  held().led.reset();
  held().segment = offset_of(straight(point(), in_plane(move.end, plane_)), left_mm_);
  held().segment.offset.start = point();
  state_ = State::starting;
}

// The side was commanded without motion: the tool first goes beside the start of this move.
void RadiusCompensationPass::start_from_rest(const Action& action, const Move& move) {
  plane_ = move.plane;
  left_mm_ = left_offset(move.compensation);
  displaced_ = after_alarm_ = has_corner_arc_ = from_rest_ = unjoined_ = false;
  const OffsetSegment next = beside(segment_of(move, plane_), left_mm_);
  Vec2 entry = next.offset.start;
  if (at_rest_.rule != VectorRule::computed) entry = next.programmed.start + vector_of(at_rest_, left_mm_);
  if (distance(point(), entry) > kNoLength)
    out_.add_joint(action.origin, move, with_point(out_.position(), plane_, entry));
  hold(action, next, entry, at_rest_.rule == VectorRule::computed);
}

// A vector commanded without motion: the move before it ends there.
void RadiusCompensationPass::change_at_rest(const Origin& origin, const Move& move) {
  const Vec2 to =
      held().segment.programmed.end + vector_of(move.compensation, left_offset(move.compensation));
  leave_before();
  if (state_ == State::settled) {
    if (distance(point(), to) > kNoLength)
      out_.add_joint(origin, held_move(), with_point(out_.position(), plane_, to));
  } else {
    leave_held_at(to);
  }
  release_waiting({});
  unjoined_ = true;
}

// The move itself runs without compensation, from wherever the corner before it ends.
void RadiusCompensationPass::suspend(const Action& action, const Move& move) {
  if (look_ahead_fails(action.origin)) settle();
  if (state_ == State::off) return push_while_off(action);
  if (state_ != State::settled) {
    Corner corner = corner_at(held().segment.offset.end);
    if (has_motion(plane_, move) && !is_arc(move.mode)) {
      const OffsetSegment next = beside(segment_of(move, plane_), held().segment.left_mm);
      corner = corner_to(next);
      if (corner.fault != CornerFault::none) corner = corner_at(held().segment.offset.end);
      if (interferes(corner, action, next)) return;
    }
    leave_before();
    leave_held(corner, action, {});
  }
  release_waiting({});
  drop_corner_arc();
  out_.add_move(action.origin, move);
  held().action = action;
  held().segment.programmed = straight(in_plane(move.start, plane_), in_plane(move.end, plane_));
  held().segment.begins = held().segment.ends = start_tangent(held().segment.programmed);
  facing_ = plane_direction(plane_, move);
  unjoined_ = true;
}

void RadiusCompensationPass::advance(const Action& action, const Move& move) {
  if (advance_gently(action, move)) return;
  const PlanarSegment programmed = segment_of(move, plane_);
  const double left_mm = left_offset(move.compensation);
  if (!policy_.small_arcs_turn_over && is_arc_too_small(programmed, left_mm))
    return raise(policy_.inner_arc_radius, action.origin,
                 FixedText<200>::format("The offset {:.4f} mm is larger than the radius {:.4f} mm of the arc",
                                        std::abs(left_mm_), move.arc.radius));
  const bool other_side = (left_mm < 0.0) != (left_mm_ < 0.0);
  // The corner in front of a block that changes the amount has the old one.
  const OffsetSegment next = beside(programmed, other_side ? left_mm : left_mm_);
  if (look_ahead_fails(action.origin)) settle();
  if (state_ == State::off) return push_while_off(action);

  const Vec2 direction = next.begins;
  if (has_corner_arc_ && corner_turn(direction)) settle();
  Vec2 entry = next.offset.start;
  bool computed = left_mm == left_mm_;
  bool gentle = false;
  if (state_ != State::settled) {
    Corner corner = other_side && held_move().compensation.rule == VectorRule::computed
                        ? side_change_corner(held().segment, next)
                        : corner_to(next);
    if (corner.fault != CornerFault::none) return raise_corner_fault(corner, action.origin);
    if (!other_side) note_inner_corner(move, next);
    if (interferes(corner, action, next)) return;
    leave_held_for(corner, action, direction);
    entry = corner.points.back();
    computed = computed && !corner.fixed;
    gentle = computed && corner.gentle;
  } else {
    release_waiting(direction);
    if (unjoined_) entry = point();
    computed = computed && !unjoined_;
    if (distance(point(), entry) > kNoLength)
      out_.add_joint(action.origin, move, with_point(out_.position(), plane_, entry));
  }
  left_mm_ = left_mm;
  hold(action, next.left_mm == left_mm ? next : beside(programmed, left_mm), entry, computed);
  held().gentle = gentle;
}

void RadiusCompensationPass::end(const Action& action, const Move& move) {
  if (is_arc(move.mode))
    return raise(
        policy_.end_with_arc, action.origin,
        FixedText<200>::format("The compensation ends with an arc of radius {:.3f} mm", move.arc.radius));
  if (look_ahead_fails(action.origin)) settle();
  if (state_ == State::off) return push_while_off(action);
  const Vec2 direction = plane_direction(plane_, move);
  if (has_corner_arc_ && corner_turn(direction)) settle();
  if (state_ != State::settled) {
    Corner corner = corner_to_end(move);
    const OffsetSegment next = beside(segment_of(move, plane_), left_mm_);
    if (direction != Vec2{} && interferes(corner, action, next)) return;
    if (sees_together(action.origin) && !held_keeps_clear(corner)) {
      leave_before_and_stop();
      return static_cast<void>(refuse(held().action.origin));
    }
    leave_before();
    leave_held(corner, action, direction);
  }
  release_waiting(direction);
  drop_corner_arc();
  out_.add_move(action.origin, move, move.end).compensation.amount = std::abs(left_mm_);
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
  before_.reset();
  state_ = State::off;
  displaced_ = displaced;
  has_corner_arc_ = false;
}

}  // namespace kerf
