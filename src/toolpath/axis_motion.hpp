#pragma once
// The pass that turns moves of the tool into moves of the axes: rapid moves in which every axis goes by
// itself, and axes that follow another one.

#include "execute/action.hpp"
#include "machine/machine.hpp"
#include "toolpath/path_queue.hpp"

namespace kerf {

/// - A rapid move with `each_axis` becomes straight legs, up to one for each axis that moves. On the first,
///   all axes go at their own rapid speed (Move::feed, if given, is the highest of any axis); each leg ends
///   where an axis has arrived, and the last one where all have. All legs keep the commanded end of the
///   move. (MELSEC 4.1, G00 non-interpolation.)
/// - An axis that follows another (AxisSettings::master) is given the same way in every move, from where it
///   stands when the program starts; along arcs it is the trajectory that keeps both together. (MELSEC 6.8,
///   tandem function.)
///
/// Allocates nothing; an action that needs neither is handed through without a copy.
class AxisMotionPass {
 public:
  explicit AxisMotionPass(const Machine& machine);

  /// The next action, valid until the following call; nullptr at the end. `upstream.next()` gives the same.
  template <class Upstream>
  const Action* next(Upstream& upstream) {
    if (!legs_.empty()) return &legs_.pop();
    const Action* action = upstream.next();
    const Move* move = action == nullptr ? nullptr : std::get_if<Move>(&action->what);
    if (move == nullptr || !(move->each_axis || follows_)) return action;
    push(action->origin, *move);
    return legs_.empty() ? action : &legs_.pop();
  }

  /// Back to the state after construction.
  void reset() { legs_.clear(); }

 private:
  void push(const Origin& origin, const Move& move);
  void push_legs(const Origin& origin, const Move& move);
  void add(const Origin& origin, const Move& move);
  void place_followers(AxisVector& position) const;

  Machine machine_;
  AxisSet followers_;
  bool follows_;
  FixedQueue<Action, kAxisCount> legs_;
};

}  // namespace kerf
