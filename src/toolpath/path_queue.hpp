#pragma once
// What a pass gives out: moves that chain from the tool's real position, and the actions that wait for them.

#include <cstddef>

#include "base/fixed_queue.hpp"
#include "execute/action.hpp"
#include "geometry/vec2.hpp"

namespace kerf {

/// Two axes of a position as a point of the plane.
inline Vec2 in_plane(const AxisVector& position, const Plane& plane) {
  return {position[plane.first], position[plane.second]};
}

/// The position with the two axes of the plane replaced by a point.
inline AxisVector with_point(AxisVector position, const Plane& plane, Vec2 point) {
  position[plane.first] = point.x;
  position[plane.second] = point.y;
  return position;
}

/// A first-in first-out queue of moves that start where the last one ended, and of other actions. Actions may
/// be told to wait: moves added later still come before them, until they are released. Never allocates.
class PathQueue {
 public:
  static constexpr std::size_t kWaiting = 64;

  /// The next action, valid until the next one is added; nullptr when nothing is ready.
  const Action* pop() {
    if (!path_.empty()) return &path_.pop();
    while (released_ > 0) {
      --released_;
      const Action& action = waiting_.pop();
      if (!std::holds_alternative<CornerArc>(action.what)) return &action;  // one that turned nothing
    }
    return nullptr;
  }
  void clear();

  /// Machine coordinates of the tool after the last move added.
  const AxisVector& position() const { return position_; }
  void set_position(const AxisVector& position) { position_ = position; }

  /// Adds an action before those that wait and behind those released. Up to 12 fit in before the queue is
  /// drained.
  void add(const Action& action);

  /// The same for a move like another one to an end; its start becomes the position. Valid until the next one
  /// is added.
  [[gnu::hot]] Move& add_move(const Origin& origin, const Move& like, const AxisVector& end);
  void add_move(const Origin& origin, const Move& move) { add_move(origin, move, move.end); }

  /// Adds a straight move with the mode (linear for an arc), feed and commanded end of another.
  void add_joint(const Origin& origin, const Move& like, const AxisVector& end);

  /// The same for an arc around a centre, mm, by a sweep in degrees.
  void add_arc_joint(const Origin& origin, const Move& like, const AxisVector& end, const Arc& arc);

  /// Adds a move as the program has it, from wherever the tool is: an arc is preceded by a straight move to
  /// its start.
  void add_rejoined(const Origin& origin, const Move& move);

  /// Adds an action that waits. The caller checks is_waiting_full() first.
  void wait(const Action& action) { waiting_.push(action); }
  bool is_waiting_full() const { return waiting_.size() >= kWaiting; }

  /// How many actions wait.
  std::size_t waiting() const { return waiting_.size() - released_; }

  /// The first action that still waits; nullptr when none does.
  Action* first_waiting() { return released_ < waiting_.size() ? &waiting_[released_] : nullptr; }

  /// Forgets the actions that still wait.
  void drop_waiting();

  /// Lets go of the first waiting action. A move takes the position along in the other axes and leads to the
  /// point `to` of the plane. A corner arc that is let go is never given out.
  void release_first(const Plane& plane, Vec2 to);

 private:
  Action& next_place();

  static constexpr std::size_t kAdded = 12;

  AxisVector position_;
  FixedQueue<Action, kAdded> path_;
  FixedQueue<Action, kWaiting + kAdded> waiting_;
  std::size_t released_ = 0;  ///< so many of waiting_ are ready
};

}  // namespace kerf
