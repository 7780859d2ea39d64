#pragma once
// The acceleration law of an ideal path control: look-ahead over many blocks, constant acceleration, exact
// path.

#include <vector>

#include "execute/feed_policy.hpp"
#include "motion/cycle.hpp"
#include "motion/function_ref.hpp"
#include "motion/look_ahead.hpp"
#include "motion/path_segment.hpp"
#include "motion/profile.hpp"

namespace kerf {

/// Told of every action when it is done.
using BlockObserver = FunctionRef<void(const BlockTiming&)>;

/// Rules of time and rest, all exact to rounding and not rounded to cycles:
/// - lines and arcs at feed run into each other (junction.hpp); rapid moves start and end at rest;
/// - a dwell, tool, stop or end action waits for rest, then takes its own time; so does a spindle or
/// auxiliary
///   one of synchronous timing, and a spindle that needs time;
/// - moves of no length and warnings take no time and do not stop the motion.
///
/// Allocates in the constructor only. push(), finish() and the overrides plan: at most two passes over the
/// look-ahead a call, and amortised constant work an action. step() does bounded work: at most one profile
/// for each segment that ends in the cycle.
class LookAheadTrapezoid {
 public:
  LookAheadTrapezoid(const Machine& machine, const FeedPolicy& policy);

  /// There is room for an action.
  bool wants_action() const { return !look_ahead_.full(); }
  /// The caller checks wants_action() first.
  void push(const Action& action);
  /// No more actions for now: everything pushed runs to its end and to rest. More may be pushed later.
  void finish();

  StepResult step(Cycle& cycle, BlockObserver on_block);

  /// Percent. Takes effect at the point of the last cycle: the path speed rises or falls to the new one
  /// within the accelerations. An arc already pushed follows to at most twice its feed (see set_path).
  void set_feed_override(double percent);
  void set_rapid_override(double percent);

  /// While nothing changes, lets cycles pass at once, and returns their number: all that lie wholly inside an
  /// action that only takes time or inside the constant speed of a line, and a small share of those on an
  /// arc, whose extremes are looked at in the others. So any run takes a bounded number of steps for each
  /// action.
  std::uint64_t skip_steady();

  double time_s() const { return done_s_; }  ///< exact planned time of all finished actions
  std::uint64_t cycles() const { return cycles_; }
  const MotionExtremes& extremes() const { return extremes_; }

 private:
  enum class EntryKind : std::uint8_t { move, wait, passing };

  /// One action; stands in the slot of its PlanNode.
  struct Entry {
    PathSegment path;
    Origin origin;
    double seconds = 0.0;  ///< of a wait
    bool goes_on = false;  ///< BlockTiming::goes_on
    EntryKind kind = EntryKind::passing;
    BlockKind block = BlockKind::other;
  };

  void push_move(const Move& move, Entry& entry, PlanNode& node);
  double cap_squared(const PathSegment& path) const;
  void change_caps();
  void start_front();
  void complete_front(BlockObserver on_block);
  void note_corner(const PathSegment& path, double speed);
  void note_phases(const PathSegment& path);
  void note_curve_point(const PathSegment& path, const PathPoint& point);
  void fill(Cycle& cycle);

  double junction_deviation_;
  std::array<AxisLimits, kOtherRateSets + 1> limits_;  ///< by RateSet
  FeedPolicy policy_;
  LookAhead look_ahead_;
  std::vector<Entry> entries_;

  // The end of what was pushed.
  bool finishing_ = false;
  bool from_rest_ = true;    ///< the next move starts from rest
  bool passes_on_ = false;   ///< the next move is another leg of the same positioning
  AxisVector last_tangent_;  ///< of the last move with a length
  double last_length_ = 0.0;

  // The point of the present cycle.
  bool active_ = false;      ///< the front entry is in progress
  bool cycle_open_ = false;  ///< the time of a cycle has begun that is not given yet
  SpeedProfile profile_;     ///< from way_before_ to the end of the front entry
  double time_ = 0.0;        ///< in profile_
  double way_before_ = 0.0;  ///< of the front entry before profile_
  double time_before_ = 0.0;
  double peak_before_ = 0.0;  ///< mm/s
  AxisVector end_velocity_;   ///< of the last finished move, at its end
  AxisVector rest_position_;  ///< end of the last finished move
  Origin last_origin_;

  double cycle_s_;
  double cycles_per_s_;
  double done_s_ = 0.0;
  std::uint64_t cycles_ = 0;
  AxisVector last_acceleration_;
  bool skipped_ = false;  ///< last_acceleration_ is not that of the cycle before
  MotionExtremes extremes_;
};

}  // namespace kerf
