#pragma once
// The pass that makes moves in a polar plane moves of its axes (MELSEC 5.6, G12.1).

#include "base/fixed_queue.hpp"
#include "execute/action.hpp"
#include "execute/toolpath_policy.hpp"

namespace kerf {

/// Gives moves of PolarForm::plane the positions of their axes (PolarForm::axes). The rotary axis goes the
/// way along the figure, over whole turns. A move through the centre of rotation becomes one to the centre, a
/// turn of the rotary axis at rest, as fast as it can, and one away from it. Where the tool's path runs
/// around the centre otherwise than the program's, an endless rotary axis keeps the turns from then on.
/// Allocates nothing; without axes in the policy everything is handed through.
class PolarPass {
 public:
  explicit PolarPass(const PolarPolicy& policy) : policy_(policy) {}

  /// The next action, valid until the following call; nullptr at the end. `upstream.next()` gives the same.
  template <class Upstream>
  const Action* next(Upstream& upstream) {
    if (!out_.empty()) return &out_.pop();
    const Action* action = upstream.next();
    if (action != nullptr && stops_program(*action)) reset();  // the program may go on from anywhere
    const Move* move = action == nullptr || !policy_.rotary ? nullptr : std::get_if<Move>(&action->what);
    if (move == nullptr || (move->polar.form == PolarForm::none && is_idle())) return action;
    push(action->origin, *move);
    return &out_.pop();
  }

  /// Back to the state after construction.
  void reset();

 private:
  bool is_idle() const { return !on_ && turned_ == 0.0 && elsewhere_.empty(); }
  void push(const Origin& origin, const Move& move);
  void enter(const Move& move);
  void leave(const Origin& origin, Move move);
  void add_part(const Origin& origin, const Move& flat, double from, double to);
  void turn_at_center(const Origin& origin, const Move& like, double by);
  void add(const Origin& origin, const Move& move);

  PolarPolicy policy_;
  bool on_ = false;      ///< the last move was one of the plane
  double turned_ = 0.0;  ///< whole turns that the axis is ahead of the program, degrees
  double shift_ = 0.0;   ///< of the rotary axis where the mode began, from where the program had it, degrees
  Axis linear_ = Axis::X;  ///< of the last plane
  AxisVector position_;    ///< of the axes, behind the last move of the plane
  AxisSet elsewhere_;      ///< behind the mode: axes that have not moved since, and do not stand where the
                           ///< program has them
  FixedQueue<Action, 4> out_;
};

}  // namespace kerf
