#pragma once
// Speeds at the joints of a sequence of segments, planned over a window.

#include <cstddef>
#include <vector>

namespace kerf {

/// One segment as the planner sees it. Speeds squared in (mm/s)2.
struct PlanNode {
  double gain = 0.0;      ///< largest change of the squared speed over the segment: 2 acceleration length
  double cap = 0.0;       ///< squared speed that the segment should not exceed
  double junction = 0.0;  ///< squared speed that the entry must not exceed; 0: from rest
  double entry = 0.0;     ///< planned: squared speed at the entry
};

/// A ring of fixed size. Segments come in with push(), are planned, and become `released` when their entry
/// and exit speeds are final; the interpolator takes released ones from the front.
///
/// Planning is done in batches: when half as many again as the look-ahead are not released, a pass backwards
/// from rest at their end finds the highest speeds from which every later limit can still be kept, a pass
/// forwards what acceleration reaches, and the first third is released. So every segment is released with the
/// whole look-ahead known behind it, each is planned at most three times, whatever the look-ahead, and the
/// plan always ends at rest.
class LookAhead {
 public:
  /// A smaller look-ahead asked for is raised to this.
  static constexpr std::size_t kSmallest = 4;

  /// Segments behind a released one that its speeds take into account, at least.
  explicit LookAhead(std::size_t look_ahead);

  std::size_t capacity() const { return nodes_.size(); }
  bool full() const { return size_ == nodes_.size(); }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  std::size_t released() const { return released_; }

  /// The slot that the next push() fills.
  std::size_t back_slot() const { return wrapped(first_ + size_); }

  /// Appends a segment; the caller checks full() first. A node whose junction is 0 starts from
  /// rest: all before it is released.
  void push(const PlanNode& node);

  /// Plans to rest at the end and releases everything.
  void flush();

  /// Slot of the first segment.
  std::size_t front() const { return first_; }
  double exit_of_front() const { return size_ > 1 ? nodes_[next(first_)].entry : 0.0; }
  void pop();

  PlanNode& operator[](std::size_t slot) { return nodes_[slot]; }
  const PlanNode& operator[](std::size_t slot) const { return nodes_[slot]; }
  std::size_t next(std::size_t slot) const { return slot + 1 == nodes_.size() ? 0 : slot + 1; }

  /// Plans everything anew after changes of caps, from the squared speed `entry` at the front's entry, which
  /// the caps may lie below: then the speed falls as fast as the gains let it. Limits of junctions stay kept,
  /// because the speed they were reached with allowed it.
  void replan(double entry);

 private:
  std::size_t wrapped(std::size_t slot) const { return slot < nodes_.size() ? slot : slot - nodes_.size(); }
  void plan(std::size_t first, std::size_t count);
  std::size_t previous(std::size_t slot) const { return slot == 0 ? nodes_.size() - 1 : slot - 1; }

  std::size_t batch_;   ///< released at once
  std::size_t window_;  ///< planned at once
  std::vector<PlanNode> nodes_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  std::size_t released_ = 0;
};

}  // namespace kerf
