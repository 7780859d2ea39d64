// What waits in front of the compensation, and what of it belongs to the contour.

#include "toolpath/overcut_check.hpp"

#include <cassert>

#include "toolpath/compensated_move.hpp"

namespace kerf {

OvercutCheck::OvercutCheck(const RadiusCompensationPolicy& policy) : policy_(policy) {
  assert(!policy.sees_contour_ahead || policy.interference != InterferenceCheck::none);
  assert(!policy.sees_contour_ahead || !policy.small_arcs_turn_over);
}

void OvercutCheck::reset() {
  queue_.clear();
  state_ = {};
  restart();
}

void OvercutCheck::restart() {
  behind_.clear();
  entry_.reset();
  led_.reset();
  starts_ = refused_ = false;
  state_.off = true;
  for (std::size_t i = 0; i < queue_.size(); ++i)
    if (queue_[i].kind != Kind::skipped) queue_[i].kind = enter(queue_[i].action, queue_[i].block);
}

bool OvercutCheck::commands_side(const Action& action) {
  const Move* move = std::get_if<Move>(&action.what);
  return move != nullptr && move->compensation.side != Side::none;
}

bool OvercutCheck::wants_more() const {
  if (refused_) return false;
  if (queue_.empty()) return true;
  const Entry& first = queue_.front();
  if (first.kind != Kind::contour || queue_.full()) return false;
  const Entry& last = queue_[queue_.size() - 1];
  return last.kind != Kind::end &&
         last.action.origin.block < first.block.number + policy_.interference_blocks;
}

void OvercutCheck::add(const Action& action) {
  Entry& entry = queue_.push();
  entry.action = action;
  entry.kind = enter(action, entry.block);
}

OvercutCheck::Kind OvercutCheck::enter(const Action& action, SeenBlock& block) {
  if (const Move* move = std::get_if<Move>(&action.what))
    return enter_move(*move, action.origin.block, block);
  const bool stop = std::holds_alternative<Stop>(action.what) && policy_.stop_ends_look_ahead;
  if (std::holds_alternative<End>(action.what)) state_.off = true;
  const bool ends = std::holds_alternative<End>(action.what) || std::holds_alternative<Alarm>(action.what) ||
                    std::holds_alternative<CornerArc>(action.what);
  return ends || stop ? Kind::end : Kind::other;
}

OvercutCheck::Kind OvercutCheck::enter_move(const Move& move, std::uint32_t number, SeenBlock& block) {
  const RadiusCompensation& wanted = move.compensation;
  const bool moves = has_motion(state_.off ? move.plane : state_.plane, move);
  if (wanted.side == Side::none) {
    if (!moves && !move.axis_words) return Kind::other;
    state_.off = true;
    return Kind::end;
  }
  if (!moves && !wanted.suspended) return Kind::other;
  if (wanted.suspended || wanted.rule != VectorRule::computed) {
    state_.off = true;
    return Kind::end;
  }
  if (!state_.off && wanted.start == state_.compensation.start) return enter_contour(move, number, block);
  state_.off = is_arc(move.mode);
  if (state_.off) return Kind::end;
  state_.compensation = wanted;
  state_.plane = move.plane;
  state_.has_block = false;
  return Kind::start;
}

OvercutCheck::Kind OvercutCheck::enter_contour(const Move& move, std::uint32_t number, SeenBlock& block) {
  const double left_mm = left_offset(state_.compensation);
  const PlanarSegment programmed = segment_of(move, state_.plane);
  const bool goes_on = left_offset(move.compensation) == left_mm && move.plane == state_.plane;
  if (!goes_on || is_arc_too_small(programmed, left_mm)) {
    state_.off = true;
    return Kind::end;
  }
  const OffsetSegment segment = offset_of(programmed, left_mm);
  const double heading =
      state_.has_block ? heading_at_end(state_.last) + turn_between(state_.last.segment, segment) : 0.0;
  block = state_.last = seen_block(segment, number, heading);
  state_.has_block = true;
  return Kind::contour;
}

const Action* OvercutCheck::take() {
  led_.reset();
  if (refused_) {
    refused_ = false;
    return &alarm_;
  }
  Entry& entry = queue_.front();
  if (entry.kind == Kind::start) start(std::get<Move>(entry.action.what));
  if (entry.kind == Kind::contour) check(entry);
  if (entry.kind == Kind::contour || entry.kind == Kind::skipped) pass_by(entry.block);
  if (entry.kind == Kind::skipped && !strip_skipped(entry.action)) {
    queue_.pop();
    return nullptr;
  }
  return &queue_.pop().action;
}

void OvercutCheck::start(const Move& move) {
  start_direction_ = plane_direction(move.plane, move);
  entry_.reset();
  behind_.clear();
  starts_ = true;
}

void OvercutCheck::pass_by(const SeenBlock& block) {
  if (behind_.full()) behind_.pop();
  behind_.push(block);
}

// A block that is left out keeps what it moves outside of the plane. False: it moves nothing else.
bool OvercutCheck::strip_skipped(Action& action) const {
  Move& move = std::get<Move>(action.what);
  const Plane plane = move.plane;
  const Vec2 at = in_plane(passed_, plane);
  move.start = with_point(move.start, plane, at);
  move.end = with_point(move.end, plane, at);
  if (is_arc(move.mode)) move.mode = MoveMode::linear;
  move.arc = {};
  return move.start != move.end;
}

}  // namespace kerf
