#pragma once
// Actions that somebody looks at on their way to the next stage.

#include <functional>
#include <utility>

#include "execute/action.hpp"

namespace kerf {

/// Hands the actions of an upstream through unchanged and shows each one to an observer first. Without an
/// observer it costs one comparison an action.
template <class Upstream>
class Watched {
 public:
  using Observer = std::function<void(const Action&)>;

  /// Upstream must outlive it.
  explicit Watched(Upstream& upstream) : upstream_(upstream) {}

  void watch(Observer observer) { observer_ = std::move(observer); }

  const Action* next() {
    const Action* action = upstream_.next();
    if (observer_ && action != nullptr) observer_(*action);
    return action;
  }
  void recover() { upstream_.recover(); }

 private:
  Upstream& upstream_;
  Observer observer_;
};

}  // namespace kerf
