#include "motion/look_ahead_trapezoid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "motion/junction.hpp"

namespace kerf {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// Share of a cycle by which a phase may end late and still belong to the cycle: keeps the rounding of times
/// from making a cycle of its own.
constexpr double kTimeSlack = 1e-9;

/// Steps in which the rest of an arc is looked at, at least.
constexpr double kArcLooks = 4096.0;

/// More cycles than any run has.
constexpr double kMostCycles = 1e15;

void keep_largest(AxisVector& largest, const AxisVector& value, double factor) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    largest.values[i] = std::max(largest.values[i], std::abs(value.values[i]) * factor);
  }
}

AxisVector start_position(const Machine& machine) {
  AxisVector position;
  for (const Axis axis : machine.axes) position[axis] = machine[axis].start;
  return position;
}

std::array<AxisLimits, kOtherRateSets + 1> limits_of(const Machine& machine) {
  std::array<AxisLimits, kOtherRateSets + 1> limits;
  for (std::size_t set = 0; set < limits.size(); ++set)
    limits[set] = make_axis_limits(machine, static_cast<RateSet>(set));
  return limits;
}

/// What an action without a path does to the motion.
struct Pause {
  BlockKind block = BlockKind::other;
  double seconds = 0.0;
  bool stops = true;
};

Pause pause_of(const ActionVariant& what) {
  if (const auto* dwell = std::get_if<Dwell>(&what)) return {BlockKind::dwell, dwell->seconds, true};
  if (const auto* spindle = std::get_if<Spindle>(&what)) {
    const bool waits = spindle->seconds > 0.0 || spindle->timing == OutputTiming::synchronous;
    return {BlockKind::spindle, spindle->seconds, waits};
  }
  if (const auto* tool = std::get_if<ToolChange>(&what)) return {BlockKind::tool_change, tool->seconds, true};
  if (const auto* alarm = std::get_if<Alarm>(&what)) {
    return {BlockKind::other, 0.0, stops_program(*alarm)};
  }
  if (const auto* auxiliary = std::get_if<Auxiliary>(&what)) {
    return {BlockKind::other, 0.0, auxiliary->timing == OutputTiming::synchronous};
  }
  if (std::holds_alternative<CornerArc>(what)) return {BlockKind::other, 0.0, false};
  return {};
}

}  // namespace

LookAheadTrapezoid::LookAheadTrapezoid(const Machine& machine, const FeedPolicy& policy)
    : junction_deviation_(machine.motion.junction_deviation),
      limits_(limits_of(machine)),
      policy_(policy),
      look_ahead_(static_cast<std::size_t>(std::max(machine.motion.look_ahead, 0))),
      entries_(look_ahead_.capacity()),
      rest_position_(start_position(machine)),
      cycle_s_(machine.cycle_s),
      cycles_per_s_(1.0 / machine.cycle_s) {
  extremes_.low = rest_position_;
  extremes_.high = rest_position_;
}

void LookAheadTrapezoid::push(const Action& action) {
  assert(wants_action());
  finishing_ = false;
  Entry& entry = entries_[look_ahead_.back_slot()];
  entry.origin = action.origin;
  PlanNode node;
  if (const auto* move = std::get_if<Move>(&action.what)) {
    push_move(*move, entry, node);
  } else {
    const Pause pause = pause_of(action.what);
    entry.block = pause.block;
    entry.seconds = pause.seconds > 0.0 ? pause.seconds : 0.0;
    entry.kind = pause.stops ? EntryKind::wait : EntryKind::passing;
    node.cap = pause.stops ? 0.0 : kUnlimited;
    node.junction = node.cap;
    from_rest_ = from_rest_ || pause.stops;
  }
  look_ahead_.push(node);
}

void LookAheadTrapezoid::push_move(const Move& move, Entry& entry, PlanNode& node) {
  PathSegment& path = entry.path;
  const AxisLimits& limits = limits_[move.rates];
  set_path(path, move, limits, policy_.effective(move.feed));
  entry.block = path.rapid ? BlockKind::rapid : BlockKind::cutting;
  if (path.length <= 0.0) {
    entry.kind = EntryKind::passing;
    node.cap = kUnlimited;
    node.junction = kUnlimited;
    return;
  }
  entry.kind = EntryKind::move;
  node.gain = 2.0 * path.acceleration * path.length;
  node.cap = cap_squared(path);
  if (passes_on_) {
    node.junction = kUnlimited;
  } else if (!path.rapid && !from_rest_ && !move.from_rest) {
    AxisLimits own;
    node.junction =
        junction_speed_squared(last_tangent_, start_tangent(path), 0.5 * (last_length_ + path.length),
                               junction_deviation_, joint_limits(path, limits, own));
  }
  passes_on_ = move.passes_on;
  entry.goes_on = move.passes_on && move.polar.form != PolarForm::none;
  from_rest_ = (path.rapid && !passes_on_) || move.exact_stop;
  last_tangent_ = end_tangent(path);
  last_length_ = path.length;
}

double LookAheadTrapezoid::cap_squared(const PathSegment& path) const {
  double speed = path.speed_limit;
  if (path.rapid) {
    speed *= std::clamp(policy_.rapid_override / 100.0, 0.0, 1.0);
  } else if (!path.at_maximum) {
    speed = std::min(speed, policy_.effective(path.feed_mm_min) / path.feed_per_speed);
  }
  return speed * speed;
}

void LookAheadTrapezoid::finish() {
  look_ahead_.flush();
  from_rest_ = true;
  finishing_ = true;
}

void LookAheadTrapezoid::set_feed_override(double percent) {
  policy_.feed_override = percent;
  change_caps();
}

void LookAheadTrapezoid::set_rapid_override(double percent) {
  policy_.rapid_override = percent;
  change_caps();
}

void LookAheadTrapezoid::change_caps() {
  std::size_t slot = look_ahead_.front();
  for (std::size_t i = 0; i < look_ahead_.size(); ++i, slot = look_ahead_.next(slot)) {
    const Entry& entry = entries_[slot];
    if (entry.kind == EntryKind::move) look_ahead_[slot].cap = cap_squared(entry.path);
  }
  if (look_ahead_.empty()) return;
  PlanNode& front = look_ahead_[look_ahead_.front()];
  const Entry& entry = entries_[look_ahead_.front()];
  if (!active_ || entry.kind != EntryKind::move) {
    look_ahead_.replan(front.entry);
    return;
  }
  // What is left of the segment in progress becomes a segment of its own.
  note_phases(entry.path);
  peak_before_ = std::max(peak_before_, profile_.peak_until(time_));
  const ProfilePoint now = profile_.at(time_);
  way_before_ += now.s;
  time_before_ += time_;
  time_ = 0.0;
  const double left = std::max(entry.path.length - way_before_, 0.0);
  front.gain = 2.0 * entry.path.acceleration * left;
  look_ahead_.replan(now.speed * now.speed);
  profile_ = make_profile(left, now.speed, std::sqrt(look_ahead_.exit_of_front()), std::sqrt(front.cap),
                          entry.path.acceleration);
}

void LookAheadTrapezoid::start_front() {
  const Entry& entry = entries_[look_ahead_.front()];
  const PlanNode& node = look_ahead_[look_ahead_.front()];
  active_ = true;
  way_before_ = 0.0;
  time_before_ = 0.0;
  peak_before_ = 0.0;
  last_origin_ = entry.origin;
  if (entry.kind == EntryKind::move) {
    profile_ = make_profile(entry.path.length, std::sqrt(node.entry), std::sqrt(look_ahead_.exit_of_front()),
                            std::sqrt(node.cap), entry.path.acceleration);
    note_corner(entry.path, std::sqrt(node.entry));
    return;
  }
  if (entry.kind == EntryKind::wait) end_velocity_ = {};
  profile_ = SpeedProfile{};
  profile_.time3 = entry.seconds;
}

void LookAheadTrapezoid::complete_front(BlockObserver on_block) {
  const Entry& entry = entries_[look_ahead_.front()];
  BlockTiming timing;
  timing.kind = entry.block;
  timing.start_s = done_s_;
  timing.duration_s = time_before_ + profile_.time3;
  if (entry.kind == EntryKind::move) {
    note_phases(entry.path);
    extend_range(entry.path, extremes_.low, extremes_.high);
    PathPoint end;
    evaluate_end(entry.path, profile_.at(profile_.time3).speed, end);
    rest_position_ = end.position;
    end_velocity_ = end.velocity;
    timing.goes_on = entry.goes_on;
    timing.length_mm = entry.path.length_mm;
    timing.peak_feed_mm_min =
        std::max(peak_before_, profile_.peak_until(profile_.time3)) * entry.path.feed_per_speed;
  }
  done_s_ += timing.duration_s;
  active_ = false;
  look_ahead_.pop();
  on_block(timing);
}

/// What the axes step by where the segment before ends and this one begins.
void LookAheadTrapezoid::note_corner(const PathSegment& path, double speed) {
  PathPoint start;
  evaluate(path, 0.0, speed, 0.0, start);
  keep_largest(extremes_.corner_step, start.velocity - end_velocity_, 1.0);
}

/// Extremes of the profile in progress, up to the present time. What follows s linearly is known in closed
/// form; the plane axes of an arc and the axes of a polar plane are looked at where a phase begins or ends,
/// and in every cycle.
void LookAheadTrapezoid::note_phases(const PathSegment& path) {
  const double until = std::min(time_, profile_.time3);
  double ramp = profile_.time1 > 0.0 ? std::abs(profile_.ramp1) : 0.0;
  if (until > profile_.time2) ramp = std::max(ramp, profile_.ramp3);
  const AxisVector slope = even_slope(path);
  keep_largest(extremes_.velocity, slope, profile_.peak_until(until));
  keep_largest(extremes_.acceleration, slope, ramp);
  if (!is_curved(path)) return;
  PathPoint point;
  for (const double time : {0.0, profile_.time1, profile_.time2, until}) {
    if (time > until) continue;
    const ProfilePoint at = profile_.at(time);
    evaluate(path, way_before_ + at.s, at.speed, at.acceleration, point);
    note_curve_point(path, point);
  }
}

void LookAheadTrapezoid::note_curve_point(const PathSegment& path, const PathPoint& point) {
  for (const std::size_t axis : curved_axes(path)) {
    double& velocity = extremes_.velocity.values[axis];
    double& acceleration = extremes_.acceleration.values[axis];
    velocity = std::max(velocity, std::abs(point.velocity.values[axis]));
    acceleration = std::max(acceleration, std::abs(point.acceleration.values[axis]));
  }
}

std::uint64_t LookAheadTrapezoid::skip_steady() {
  if (!active_ || cycle_open_) return 0;
  const Entry& entry = entries_[look_ahead_.front()];
  const bool moves = entry.kind == EntryKind::move;
  if (entry.kind == EntryKind::passing || (moves && time_ < profile_.time1)) return 0;
  // One whole cycle is left, so that the next phase finds what it follows.
  double whole = std::floor(((moves ? profile_.time2 : profile_.time3) - time_) / cycle_s_ - 1.5);
  if (moves && is_curved(entry.path)) whole = std::floor(whole / kArcLooks);
  if (!(whole >= 1.0 && whole < kMostCycles)) return 0;
  skipped_ = true;
  time_ += whole * cycle_s_;
  const auto count = static_cast<std::uint64_t>(whole);
  cycles_ += count;
  return count;
}

StepResult LookAheadTrapezoid::step(Cycle& cycle, BlockObserver on_block) {
  if (!active_ && !cycle_open_) {
    if (look_ahead_.released() == 0) return finishing_ ? StepResult::finished : StepResult::needs_action;
    time_ = 0.0;
    start_front();
  }
  if (!cycle_open_) {
    cycle_open_ = true;
    time_ += cycle_s_;
    ++cycles_;
  }
  const double slack = kTimeSlack * cycle_s_;
  while (!active_ || time_ + slack >= profile_.time3) {
    if (active_) {
      const double end = profile_.time3;
      complete_front(on_block);
      time_ -= end;
    }
    if (look_ahead_.released() == 0) {
      if (!finishing_) return StepResult::needs_action;
      break;
    }
    start_front();
  }
  cycle_open_ = false;
  fill(cycle);
  const bool standing = active_ && std::isinf(profile_.time3) && time_ >= profile_.time1;
  return standing ? StepResult::held : StepResult::cycle;
}

void LookAheadTrapezoid::fill(Cycle& cycle) {
  cycle.time_s = static_cast<double>(cycles_) * cycle_s_;
  cycle.origin = last_origin_;
  const Entry* entry = active_ ? &entries_[look_ahead_.front()] : nullptr;
  if (entry != nullptr && entry->kind == EntryKind::move) {
    const ProfilePoint point = profile_.at(time_);
    evaluate(entry->path, way_before_ + point.s, point.speed, point.acceleration, cycle);
    cycle.path_speed_mm_min = point.speed * entry->path.feed_per_speed;
    if (is_curved(entry->path)) note_curve_point(entry->path, cycle);
  } else {
    static_cast<PathPoint&>(cycle) = {rest_position_, {}, {}};
    cycle.path_speed_mm_min = 0.0;
  }
  if (!skipped_) keep_largest(extremes_.jerk, cycle.acceleration - last_acceleration_, cycles_per_s_);
  skipped_ = false;
  last_acceleration_ = cycle.acceleration;
}

}  // namespace kerf
