// The moves held back, and the path that is made of them.

#include <cmath>

#include "toolpath/compensated_move.hpp"
#include "toolpath/interference.hpp"
#include "toolpath/radius_compensation.hpp"

namespace kerf {
namespace {

constexpr double kWholeTurn = 360.0;  // degrees

}  // namespace

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

}  // namespace kerf
