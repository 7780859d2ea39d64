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
  joint.inner_corner_deg = 0.0;
  joint.arc = {};
  joint.end = end;
  add_move(origin, joint);
}

void PathQueue::add_rejoined(const Origin& origin, const Move& move) {
  if (is_arc(move.mode) && position_ != move.start) add_joint(origin, move, move.start);
  add_move(origin, move);
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
