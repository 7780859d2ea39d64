#include "toolpath/path_queue.hpp"

namespace kerf {

void PathQueue::clear() {
  path_.clear();
  waiting_.clear();
  released_ = 0;
}

void PathQueue::add(const Action& action) {
  if (released_ == 0) {
    path_.push(action);
  } else {
    waiting_.push(action);
    ++released_;
  }
}

void PathQueue::add_move(const Origin& origin, Move move) {
  move.start = position_;
  position_ = move.end;
  add({origin, move});
}

void PathQueue::add_joint(const Origin& origin, const Move& like, const AxisVector& end) {
  Move joint = like;
  if (is_arc(like.mode)) joint.mode = MoveMode::linear;
  joint.rotary_feed = {};
  joint.arc = {};
  joint.end = end;
  add_move(origin, joint);
}

void PathQueue::add_rejoined(const Origin& origin, const Move& move) {
  if (is_arc(move.mode) && position_ != move.start) add_joint(origin, move, move.start);
  add_move(origin, move);
}

void PathQueue::release(const Plane& plane) {
  for (std::size_t i = released_; i < waiting_.size(); ++i) {
    Move* move = std::get_if<Move>(&waiting_[i].what);
    if (move == nullptr) continue;
    move->start = position_;
    move->end = with_point(move->end, plane, in_plane(position_, plane));
    position_ = move->end;
  }
  released_ = waiting_.size();
}

}  // namespace kerf
