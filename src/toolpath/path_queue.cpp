#include "toolpath/path_queue.hpp"

namespace kerf {

void PathQueue::clear() {
  path_.clear();
  waiting_.clear();
  released_ = 0;
}

Action& PathQueue::next_place() {
  if (released_ == 0) return path_.push();
  waiting_.push();
  for (std::size_t i = waiting_.size() - 1; i > released_; --i) waiting_[i] = waiting_[i - 1];
  return waiting_[released_++];
}

void PathQueue::add(const Action& action) {
  next_place() = action;
}

Move& PathQueue::add_move(const Origin& origin, const Move& like, const AxisVector& end) {
  Action& action = next_place();
  action.origin = origin;
  action.what = like;
  Move& move = std::get<Move>(action.what);
  move.start = position_;
  move.end = position_ = end;
  return move;
}

void PathQueue::add_joint(const Origin& origin, const Move& like, const AxisVector& end) {
  Move& joint = add_move(origin, like, end);
  if (is_arc(like.mode)) joint.mode = MoveMode::linear;
  joint.rotary_feed = {};
  joint.inner_corner_deg = 0.0;
  joint.arc = {};
}

void PathQueue::add_arc_joint(const Origin& origin, const Move& like, const AxisVector& end, const Arc& arc) {
  Move& joint = add_move(origin, like, end);
  joint.mode = arc.sweep < 0.0 ? MoveMode::clockwise : MoveMode::counterclockwise;
  joint.rotary_feed = {};
  joint.inner_corner_deg = 0.0;
  joint.arc = arc;
}

void PathQueue::add_rejoined(const Origin& origin, const Move& move) {
  if (is_arc(move.mode) && position_ != move.start) add_joint(origin, move, move.start);
  add_move(origin, move);
}

void PathQueue::drop_waiting() {
  while (waiting() > 0) waiting_.drop_back();
}

void PathQueue::release_first(const Plane& plane, Vec2 to) {
  if (Move* move = std::get_if<Move>(&waiting_[released_].what)) {
    move->start = position_;
    move->end = with_point(move->end, plane, to);
    position_ = move->end;
  }
  ++released_;
}

}  // namespace kerf
