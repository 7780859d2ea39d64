#pragma once
// The pass that puts arcs into corners (MELSEC 6.6, automatic insertion of corner arcs).

#include <optional>

#include "execute/action.hpp"
#include "execute/toolpath_policy.hpp"
#include "toolpath/path_queue.hpp"

namespace kerf {

/// Between two straight cutting moves under normal line control, of successive blocks and at least as long as
/// the radius, an arc of the policy's radius replaces the corner. The arc belongs to the first block; what
/// the second block gives in front of its move comes behind the arc. Where the moves are too short for the
/// arc to touch them the corner stays, and where the program gives it a vector of tool radius compensation.
/// Allocates nothing; without a radius everything is handed through.
class CornerRounding {
 public:
  explicit CornerRounding(const NormalLinePolicy& policy);

  /// The next action, valid until the following call; nullptr at the end. `upstream.next()` gives the same,
  /// and nullptr again when it is asked after its end.
  template <class Upstream>
  const Action* next(Upstream& upstream) {
    if (radius_ <= 0.0) return upstream.next();
    for (;;) {
      if (!out_.empty()) return &out_.pop();
      const Action* action = upstream.next();
      if (action == nullptr) {
        if (!held_) return nullptr;
        release();
      } else {
        push(*action);
      }
    }
  }

  /// Back to the state after construction.
  void reset();

 private:
  bool may_round(const Action& action) const;
  void push(const Action& action);
  void release();
  void round(Action& next);

  double radius_ = 0.0;  ///< mm; 0: no corner is rounded
  std::optional<Action> held_;
  FixedQueue<Action, 8> waiting_;  ///< actions of the block behind it that come before that block's move
  FixedQueue<Action, 12> out_;
};

}  // namespace kerf
