#pragma once
// Actions on their way from a block to the interpreter's caller.

#include "base/fixed_queue.hpp"
#include "execute/action.hpp"

namespace kerf {

/// Holds what one block, or one step of a fixed cycle, gives.
class ActionQueue {
 public:
  static constexpr std::size_t kCapacity = 32;

  void begin(const Origin& origin) {
    // Part by part: a copy in large pieces would wait for the small ones that were written just before.
    origin_.span.offset = origin.span.offset;
    origin_.span.line = origin.span.line;
    origin_.span.column = origin.span.column;
    origin_.span.length = origin.span.length;
    origin_.block = origin.block;
    origin_.program = origin.program;
    origin_.sequence_number = origin.sequence_number;
    mark_ = actions_.size();
  }
  /// Takes back what was pushed since begin(): the block raised an alarm.
  void roll_back() {
    while (actions_.size() > mark_) actions_.drop_back();
  }
  template <class T>
  T& push() {
    Action& action = actions_.push();
    action.origin = origin_;
    return action.what.template emplace<T>();
  }
  /// A move for the caller to fill in from head to foot: zeroing one first costs more than executing a block.
  Move& push_unset_move() {
    Action& action = actions_.push();
    action.origin = origin_;
    if (auto* move = std::get_if<Move>(&action.what)) return *move;
    return action.what.emplace<Move>();
  }
  const Origin& origin() const { return origin_; }
  std::size_t pushed() const { return actions_.size() - mark_; }

  Action& last() { return actions_.back(); }
  bool empty() const { return actions_.empty(); }
  const Action& pop() { return actions_.pop(); }
  void clear() { actions_.clear(); }

 private:
  FixedQueue<Action, kCapacity> actions_;
  Origin origin_;
  std::size_t mark_ = 0;
};

}  // namespace kerf
