#pragma once
// The pass that keeps moves inside the travel of the machine's axes.

#include "execute/action.hpp"
#include "execute/toolpath_policy.hpp"
#include "execute/travel.hpp"
#include "machine/machine.hpp"
#include "toolpath/path_queue.hpp"

namespace kerf {

/// Checks the end of every move, and the outermost points of arcs, in machine coordinates against the lower
/// and upper limits of the machine's axes. A move that would leave them by more than 0.000001 mm is dropped
/// and the alarm given out instead. With `clip`, a straight move ends at the border and a move that starts
/// there is dropped; arcs raise the alarm all the same. The next move goes on from where the tool is. A move
/// that starts outside, which there is only behind an alarm, is dropped without another one.
/// Allocates nothing; a move inside the limits is handed through without a copy.
class TravelLimitPass {
 public:
  TravelLimitPass(const Machine& machine, const TravelLimitPolicy& policy);

  /// The next action, valid until the following call; nullptr at the end. `upstream.next()` gives the same.
  template <class Upstream>
  const Action* next(Upstream& upstream) {
    for (;;) {
      if (const Action* ready = out_.pop()) return ready;
      const Action* action = upstream.next();
      if (action == nullptr) return nullptr;
      const Move* move = std::get_if<Move>(&action->what);
      if (move == nullptr || (!displaced_ && travel_.contains(*move))) return action;
      push(action->origin, *move);
    }
  }

  /// Back to the state after construction.
  void reset();

 private:
  void push(const Origin& origin, const Move& move);
  void push_clipped(const Origin& origin, Move move);

  TravelLimitPolicy policy_;
  Travel travel_;
  bool displaced_ = false;  ///< the tool stands where out_ ends, not where the program has it
  PathQueue out_;
};

}  // namespace kerf
