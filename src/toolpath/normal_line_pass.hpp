#pragma once
// The pass that turns the axis of normal line control (MELSEC 6.6).

#include <optional>

#include "execute/action.hpp"
#include "execute/toolpath_policy.hpp"
#include "machine/machine.hpp"
#include "toolpath/path_queue.hpp"

namespace kerf {

/// Gives the axis its way in moves with Move::normal_line: along arcs with them, and at joints by a move of
/// its own in front, of the mode of the block behind, from rest to rest. Its speed there is the policy's
/// (type I) or such that the tip of the tool has the feed (type II); for a rapid move the axis's own, or that
/// of the plane's axes at the tip. Type II on arcs gives the tip the feed. In moves without normal line
/// control the axis stays where it is unless it is commanded. Allocates nothing; without an axis in the
/// policy everything is handed through.
class NormalLinePass {
 public:
  NormalLinePass(const Machine& machine, const NormalLinePolicy& policy);

  /// The next action, valid until the following call; nullptr at the end. `upstream.next()` gives the same.
  template <class Upstream>
  const Action* next(Upstream& upstream) {
    if (!out_.empty()) return &out_.pop();
    const Action* action = upstream.next();
    const Move* move = action == nullptr || !policy_.axis ? nullptr : std::get_if<Move>(&action->what);
    if (move == nullptr || (!known_ && move->normal_line == Side::none)) return action;
    push(action->origin, *move);
    return &out_.pop();
  }

  /// Back to the state after construction.
  void reset();

 private:
  void push(const Origin& origin, Move move);
  void turn_at_rest(const Origin& origin, const Move& move, double by);
  double turning_speed(const Move& move) const;
  void add(const Origin& origin, const Move& move);

  NormalLinePolicy policy_;
  Machine machine_;
  bool known_ = false;  ///< the axis was under control: `angle_` is where it stands
  bool on_ = false;     ///< it is under control
  double angle_ = 0.0;  ///< machine coordinate of the axis
  FixedQueue<Action, 3> out_;
};

}  // namespace kerf
