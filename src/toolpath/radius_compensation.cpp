#include "toolpath/radius_compensation.hpp"

#include <cassert>
#include <cmath>

#include "toolpath/interference.hpp"

namespace kerf {
namespace {

constexpr double kNoLength = 1e-6;    // mm
constexpr double kWholeTurn = 360.0;  // degrees

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
  after_alarm_ = from_rest_ = unjoined_ = false;
}

// ---- what comes in

bool RadiusCompensationPass::passes_through(const Action& action) const {
  if (const Move* move = std::get_if<Move>(&action.what)) {
    if (move->compensation.side == Side::none) return !from_rest_;
    return !policy_.starts_at_rest && !has_motion(move->plane, *move);
  }
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
  const bool side = move->compensation.side != Side::none;
  const bool commanded = side && has_motion(move->plane, *move) && !move->compensation.suspended;
  if (!side) after_alarm_ = from_rest_ = false;
  if (side && !has_motion(move->plane, *move) && policy_.starts_at_rest && !displaced_) {
    from_rest_ = true;
    at_rest_ = move->compensation;
    out_.add_rejoined(action.origin, *move);
  } else if (commanded && !is_arc(move->mode) && from_rest_) {
    start_from_rest(action, *move);
  } else if (commanded && !is_arc(move->mode)) {
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
  } else if (move.compensation.suspended) {
    return suspend(action, move);
  } else if (!moves && move.compensation.rule != VectorRule::computed) {
    change_at_rest(move);
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
  held_ = action;
  held_segment_.programmed = straight(point(), in_plane(move.end, plane_));
  held_segment_.offset = offset_segment(held_segment_.programmed, left_mm_);
  held_segment_.offset.start = point();
  held_segment_.left_mm = left_mm_;
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
  hold(action, next, entry);
}

// A vector commanded without motion: the move before it ends there.
void RadiusCompensationPass::change_at_rest(const Move& move) {
  const Vec2 to = held_segment_.programmed.end + vector_of(move.compensation, left_offset(move.compensation));
  leave_before();
  if (state_ == State::settled) {
    if (distance(point(), to) > kNoLength)
      out_.add_joint(held_.origin, held_move(), with_point(out_.position(), plane_, to));
  } else {
    leave_held(corner_at(to), held_);
  }
  release_waiting({});
  unjoined_ = true;
}

// The move itself runs without compensation, from wherever the corner before it ends.
void RadiusCompensationPass::suspend(const Action& action, const Move& move) {
  if (look_ahead_fails(action.origin)) settle();
  if (state_ == State::off) return push_while_off(action);
  if (state_ != State::settled) {
    Corner corner = corner_at(held_segment_.offset.end);
    if (has_motion(plane_, move) && !is_arc(move.mode)) {
      const OffsetSegment next = beside(segment_of(move, plane_), held_segment_.left_mm);
      corner = corner_to(next);
      if (corner.fault != CornerFault::none) corner = corner_at(held_segment_.offset.end);
      if (interferes(corner, action, next)) return;
    }
    leave_before();
    leave_held(corner, action);
  }
  release_waiting({});
  drop_corner_arc();
  out_.add_move(action.origin, move);
  held_ = action;
  held_segment_.programmed = straight(in_plane(move.start, plane_), in_plane(move.end, plane_));
  facing_ = plane_direction(plane_, move);
  unjoined_ = true;
}

void RadiusCompensationPass::advance(const Action& action, const Move& move) {
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

  const Vec2 direction = start_tangent(programmed);
  if (has_corner_arc_ && corner_turn(direction)) settle();
  Vec2 entry = next.offset.start;
  if (state_ != State::settled) {
    Corner corner = other_side && held_move().compensation.rule == VectorRule::computed
                        ? side_change_corner(held_segment_, next)
                        : corner_to(next);
    if (corner.fault != CornerFault::none) return raise_corner_fault(corner, action.origin);
    if (interferes(corner, action, next)) return;
    leave_held_for(corner, action, direction);
    entry = corner.points.back();
  } else {
    release_waiting(direction);
    if (unjoined_) entry = point();
    if (distance(point(), entry) > kNoLength)
      out_.add_joint(action.origin, move, with_point(out_.position(), plane_, entry));
  }
  left_mm_ = left_mm;
  hold(action, beside(programmed, left_mm), entry);
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
    leave_before();
    leave_held(corner, action);
  }
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
  before_.reset();
  state_ = State::off;
  displaced_ = displaced;
  has_corner_arc_ = false;
}

// ---- the move held back

// The segment begins where the corner before it ends.
void RadiusCompensationPass::hold(const Action& action, const OffsetSegment& segment, Vec2 entry) {
  held_ = action;
  held_segment_ = segment;
  begin_at(held_segment_.offset, entry);
  has_corner_arc_ = unjoined_ = false;
  corner_arc_block_ = 0;
  state_ = State::running;
}

void RadiusCompensationPass::leave_held(const Corner& corner, const Action& next) {
  add_corner(held_, held_segment_, corner, next);
  facing_ = end_tangent(held_segment_.programmed);
  state_ = State::settled;
}

// The corner is known; with an interference check the one behind it may still change it.
void RadiusCompensationPass::leave_held_for(const Corner& corner, const Action& next, Vec2 next_direction) {
  leave_before();
  if (policy_.interference == InterferenceCheck::none || has_corner_arc_) {
    leave_held(corner, next);
    release_waiting(next_direction);
    return;
  }
  before_ = Before{held_, held_segment_, corner, next_direction, out_.waiting()};
}

void RadiusCompensationPass::leave_before() {
  if (!before_) return;
  add_corner(before_->action, before_->segment, before_->corner, held_);
  release_waiting(before_->direction, before_->waiting);
  before_.reset();
}

void RadiusCompensationPass::add_corner(const Action& action, const OffsetSegment& segment,
                                        const Corner& corner, const Action& next) {
  add_segment(action, segment, corner.points[0]);
  const Action& like = policy_.joints_belong_to_next ? next : action;
  for (std::size_t i = 1; i < corner.points.size(); ++i) {
    out_.add_joint(like.origin, std::get<Move>(like.what),
                   with_point(out_.position(), plane_, corner.points[i]));
  }
}

// Looks at the move held back between the corner before it and `corner`, which the next move makes. True: an
// alarm was raised.
bool RadiusCompensationPass::interferes(Corner& corner, const Action& action, const OffsetSegment& next) {
  if (!before_ || policy_.interference == InterferenceCheck::none) return false;
  const Origin& first = before_->action.origin;
  if (action.origin.block > first.block + policy_.interference_blocks) return false;
  const Interference found = remove_interference(before_->corner, held_segment_, corner);
  if (found == Interference::none) return false;
  if (found == Interference::partly) {
    held_segment_.offset = straight(before_->corner.points.back(), corner.points[0]);
    return false;
  }
  if (policy_.interference == InterferenceCheck::avoid) {
    const auto around = avoiding_point(before_->segment, before_->segment.offset.start, next);
    if (around) {
      before_->corner = corner = corner_at(*around);
      held_segment_.offset = straight(*around, *around);
      return false;
    }
  }
  const Action refused = before_->action;
  before_.reset();
  state_ = State::settled;
  raise(policy_.interference_alarm, refused.origin,
        FixedText<200>::format("The tool would cut into the path of the blocks behind at {}{:.3f} {}{:.3f}",
                               letter(plane_.first), held_segment_.programmed.start.x, letter(plane_.second),
                               held_segment_.programmed.start.y));
  return true;
}

void RadiusCompensationPass::leave_held_at_right_angles() {
  const bool own = held_move().compensation.rule != VectorRule::computed;
  leave_held(own ? corner_to({}) : corner_at(held_segment_.offset.end), held_);
}

// The look-ahead ends here: nothing is held back any longer.
void RadiusCompensationPass::settle() {
  if (state_ == State::settled || state_ == State::off) return;
  leave_before();
  if (state_ == State::starting && policy_.start_waits) {
    add_segment(held_, held_segment_, held_segment_.programmed.end);
    release_waiting({});
    turn_off(false);
    return;
  }
  leave_held_at_right_angles();
  release_waiting({});
  unjoined_ = policy_.resumes_unjoined;
}

// The actions that wait, in order, up to a corner arc whose direction is not known yet.
void RadiusCompensationPass::release_waiting(Vec2 next_direction, std::size_t count) {
  for (; count > 0; --count) {
    Action* action = out_.first_waiting();
    if (action == nullptr) break;
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

void RadiusCompensationPass::add_segment(const Action& action, const OffsetSegment& segment, Vec2 end) {
  Move move = std::get<Move>(action.what);
  move.end = with_point(move.end, plane_, end);
  PlanarSegment path = segment.offset;
  if (is_arc(move.mode) && !path.is_arc) move.mode = MoveMode::linear;  // interference left nothing of it
  if (path.is_arc) {
    double left_deg = end_at(path, end);
    if (policy_.drops_whole_turns && left_deg >= kWholeTurn) {
      left_deg -= kWholeTurn;
      path.sweep_deg = std::copysign(left_deg, path.sweep_deg);
    }
    move.arc = {{path.center.x, path.center.y}, distance(path.center, path.start), path.sweep_deg};
    if (left_deg <= 0.0 || length_of(path) <= kNoLength) move.mode = MoveMode::linear;
  }
  if (!is_nothing(plane_, move, out_.position())) out_.add_move(action.origin, move);
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
  const RadiusCompensation& own = held_move().compensation;
  if (own.rule != VectorRule::computed) {
    Corner corner = corner_at(held_segment_.programmed.end + vector_of(own, left_mm_));
    corner.fixed = true;
    return corner;
  }
  if (state_ == State::starting)
    return start_corner(end_tangent(held_segment_.programmed), next, policy_.start_type, rules(),
                        policy_.type_b_beside);
  return crossover_corner(held_segment_, next, rules());
}

Corner RadiusCompensationPass::corner_to_end(const Move& move) const {
  if (held_move().compensation.rule != VectorRule::computed) return corner_to({});
  const Vec2 imagined{move.compensation.direction[0], move.compensation.direction[1]};
  if (imagined != Vec2{} && state_ != State::starting) return imagined_corner(held_segment_, imagined);
  const Vec2 direction = plane_direction(plane_, move);
  if (direction == Vec2{}) return corner_at(held_segment_.offset.end);
  // Started and ended without a compensated move between: the tool comes to the point beside the start of the
  // last.
  if (state_ == State::starting)
    return corner_at(held_segment_.programmed.end + left_mm_ * left_of(direction));
  return end_corner(held_segment_, direction, policy_.start_type, rules(), policy_.type_b_beside);
}

// From the programmed end of a move to the tool.
Vec2 RadiusCompensationPass::vector_of(const RadiusCompensation& compensation, double left_mm) const {
  const Vec2 direction = unit(Vec2{compensation.direction[0], compensation.direction[1]});
  switch (compensation.rule) {
    case VectorRule::at_right_angles:
      return left_mm * left_of(direction);
    case VectorRule::along:
      return std::abs(left_mm) * direction;
    case VectorRule::kept:
      return held_segment_.offset.start - held_segment_.programmed.start;
    case VectorRule::computed:
      break;
  }
  return {};
}

// The turn of a corner arc to a direction; none when the corner is an inner one or there is nothing to turn.
std::optional<RadiusCompensationPass::CornerTurn> RadiusCompensationPass::corner_turn(Vec2 direction) const {
  if (direction == Vec2{}) return std::nullopt;
  const Vec2 facing = state_ == State::settled ? facing_ : end_tangent(held_segment_.programmed);
  const double angle = workpiece_angle_deg(facing, direction, left_mm_);
  const double turn_angle = 180.0 - angle;
  if ((is_inner(angle) && !policy_.corner_arc_inside) ||
      std::abs(left_mm_ * radians(turn_angle)) <= kNoLength)
    return std::nullopt;
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
  if (policy_.stops_before_fault && state_ == State::running) {
    leave_before();
    state_ = State::settled;
  }
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
