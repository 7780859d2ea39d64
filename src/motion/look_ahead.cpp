#include "motion/look_ahead.hpp"

#include <algorithm>
#include <cassert>

namespace kerf {

// A batch more than the window: what is released waits there while the next window fills.
LookAhead::LookAhead(std::size_t look_ahead)
    : batch_(std::max(look_ahead, kSmallest) / 2),
      window_(std::max(look_ahead, kSmallest) + batch_),
      nodes_(window_ + batch_) {}

void LookAhead::push(const PlanNode& node) {
  assert(!full());
  if (node.junction <= 0.0) flush();
  const std::size_t slot = back_slot();
  nodes_[slot] = node;
  nodes_[slot].entry = 0.0;
  ++size_;
  if (size_ - released_ == window_) {
    plan(wrapped(first_ + released_), window_);
    released_ += batch_;
  }
}

void LookAhead::flush() {
  if (released_ == size_) return;
  plan(wrapped(first_ + released_), size_ - released_);
  released_ = size_;
}

void LookAhead::pop() {
  assert(released_ > 0);
  first_ = next(first_);
  --size_;
  --released_;
}

void LookAhead::replan(double entry) {
  if (size_ == 0) return;
  nodes_[first_].entry = entry;
  plan(first_, size_);
}

void LookAhead::plan(std::size_t first, std::size_t count) {
  // Backwards: from what speed can every later limit still be kept. The entry of the first is given.
  std::size_t slot = wrapped(first + count - 1);
  double exit = 0.0;
  while (slot != first) {
    const std::size_t before = previous(slot);
    PlanNode& node = nodes_[slot];
    exit = std::min(std::min(exit + node.gain, node.junction), std::min(node.cap, nodes_[before].cap));
    node.entry = exit;
    slot = before;
  }
  // Forwards: what acceleration reaches; and, after a cap was lowered, what deceleration cannot avoid.
  double entry = nodes_[first].entry;
  for (std::size_t i = 1; i < count; ++i) {
    const double gain = nodes_[slot].gain;
    slot = next(slot);
    PlanNode& node = nodes_[slot];
    entry = std::min({std::max(node.entry, entry - gain), entry + gain, node.junction});
    node.entry = entry;
  }
}

}  // namespace kerf
