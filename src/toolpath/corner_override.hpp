#pragma once
// The pass that slows the tool down before inner corners (MELSEC 5.6, G62).

#include "execute/action.hpp"
#include "execute/toolpath_policy.hpp"
#include "toolpath/path_queue.hpp"

namespace kerf {

/// A cutting move of PathMode::corner_override that ends at an inner corner (Move::inner_corner_deg) of at
/// most the policy's angle is cut in two, the second part as long as the policy says and slower; a shorter
/// move is slow as a whole, and so is an arc put into an inner corner, in front of which the angle does not
/// count. Allocates nothing; everything else is handed through without a copy.
class CornerOverridePass {
 public:
  explicit CornerOverridePass(const CornerOverridePolicy& policy) : policy_(policy), on_(policy.is_on()) {}

  /// The next action, valid until the following call; nullptr at the end. `upstream.next()` gives the same.
  template <class Upstream>
  const Action* next(Upstream& upstream) {
    if (!out_.empty()) return &out_.pop();
    const Action* action = upstream.next();
    const Move* move = action == nullptr || !on_ ? nullptr : std::get_if<Move>(&action->what);
    if (move == nullptr || !is_slowed(*move)) return action;
    push(action->origin, *move);
    return &out_.pop();
  }

  /// Back to the state after construction.
  void reset() { out_.clear(); }

 private:
  bool is_slowed(const Move& move) const;
  void push(const Origin& origin, const Move& move);
  void add(const Origin& origin, const Move& move);

  CornerOverridePolicy policy_;
  bool on_;
  FixedQueue<Action, 2> out_;
};

}  // namespace kerf
