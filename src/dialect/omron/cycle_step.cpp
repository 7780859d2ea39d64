// Tapping: G74 and G84 (manual chapter 2). The cycle works along Z in any plane.

#include <algorithm>

#include "dialect/omron/block_run.hpp"

namespace kerf::omron {
namespace {

constexpr AxisSet kMoved{Axis::X, Axis::Y, Axis::Z};

}  // namespace

/// In the block of G74 or G84 itself other modal codes may stand.
bool BlockRun::cycle_allowed() {
  const CodeNumber cycle = words_[Group::fixed_cycle];
  const bool starts = cycle == code(74) || cycle == code(84);
  const bool stays = in_cycle_ && cycle != code(80) && !words_.has(Group::motion);
  if (!starts && !stays) return true;
  const auto refuse_code = [this](Group group) { return refuse("cycle-active", span(words_.word(group))); };
  for (const Group group : {Group::one_shot, Group::scaling, Group::mirror, Group::rotation,
                            Group::work_system, Group::length_compensation}) {
    if (words_.has(group)) return refuse_code(group);
  }
  if (words_.m_code() >= 0) return refuse("cycle-active", span(words_.m_word()));
  if (words_.has(Group::radius_compensation)) return refuse_code(Group::radius_compensation);
  if (is_compensating()) return refuse("compensation-word", block_.span);
  if (words_.has_exact_stop()) return refuse("cycle-active", block_.span);
  if (starts && !in_cycle_) return true;
  for (const Group group :
       {Group::plane, Group::unit, Group::distance, Group::path_mode, Group::multi_block}) {
    if (words_.has(group)) return refuse_code(group);
  }
  return true;
}

bool BlockRun::fixed_cycle() {
  CycleWords& words = registers.cycle;
  if (!in_cycle_) {
    words = {};
    words.initial_level = registers.position[Axis::Z];
  }
  if (!cycle_words()) return false;
  constexpr int kMostRepetitions = 10000;
  std::int32_t repetitions = 1;
  const Word* repeats = take('K');
  if (repeats != nullptr && !integer(*repeats, 0, kMostRepetitions, repetitions)) return false;
  AxisVector hole = registers.position;
  if (!hole_position(hole)) return false;
  // A block without a position taps nothing.
  const bool positioned = words_.axes().contains(Axis::X) || words_.axes().contains(Axis::Y);
  if (!positioned || repetitions == 0) return true;
  if (!cycle_is_complete()) return false;

  AxisVector step;
  if (incremental()) step = hole - registers.position;
  if (!taking_over_) {
    tapping = tapping_plan(hole, step, repetitions);
    if (!cycle_inside_travel(*tapping)) return false;
    moved_ = true;
  }
  AxisVector last = hole + step * static_cast<double>(repetitions - 1);
  last[Axis::Z] = cycle_levels().back;
  arrive(last, kMoved);
  return true;
}

bool BlockRun::hole_position(AxisVector& hole) {
  for (const Axis axis : words_.axes()) {
    if (!kMoved.contains(axis))
      return refuse("cycle-active", span(words_.axis(axis)), "A fixed cycle moves X, Y and Z.");
  }
  const AxisVector origin = workpiece_origin(registers, tables_);
  for (const Axis axis : {Axis::X, Axis::Y}) {
    if (!words_.axes().contains(axis)) continue;
    double value = 0.0;
    if (!axis_value(axis, value)) return false;
    hole[axis] = (incremental() ? registers.position[axis] : origin[axis]) + value;
  }
  return true;
}

/// Everything that tapping needs has been written.
bool BlockRun::cycle_is_complete() {
  const CycleWords& words = registers.cycle;
  if (!words.r.given || !words.bottom.given) return refuse("cycle-words", block_.span);
  if (!registers.feed_given) return refuse("missing-feed", block_.span);
  if (settings_.has_spindle_axis && !(registers.spindle_rpm > 0.0) && !taking_over_)
    return refuse("cycle-spindle", block_.span);
  const PlaneRotation& rotation = registers.placement.rotation;
  return !rotation.active || rotation.plane == kPlaneXY || refuse("cycle-plane", block_.span);
}

BlockRun::CycleLevels BlockRun::cycle_levels() const {
  const CycleWords& words = registers.cycle;
  CycleLevels levels;
  levels.r = level_of(words.r, words.initial_level);
  levels.bottom = level_of(words.bottom, levels.r);
  levels.back = registers.modal[Group::return_level] == code(98) ? words.initial_level : levels.r;
  return levels;
}

TappingPlan BlockRun::tapping_plan(const AxisVector& hole, const AxisVector& step,
                                   std::int32_t repetitions) const {
  const CycleLevels levels = cycle_levels();
  const auto real = [&](AxisVector programmed, double z) {
    programmed[Axis::Z] = z;
    return real_position(programmed, kMoved);
  };
  TappingPlan plan;
  plan.start = registers.placement.machine;
  plan.first_hole = real(hole, levels.bottom);
  plan.step = real(hole + step, levels.bottom) - plan.first_hole;
  plan.origin = workpiece_origin(registers, tables_);
  plan.repetitions = repetitions;
  plan.r_level = real(hole, levels.r)[Axis::Z];
  plan.bottom = plan.first_hole[Axis::Z];
  plan.return_level = real(hole, levels.back)[Axis::Z];
  plan.dwell_s = registers.cycle.dwell_s;
  plan.feed = limited_feed(registers, settings_);
  plan.rates = registers.rates;
  const bool right = registers.modal[Group::fixed_cycle] == code(84);
  plan.cuts = right ? SpindleDirection::clockwise : SpindleDirection::counterclockwise;
  plan.rpm = registers.spindle_rpm;
  plan.orient_rpm = settings_.orientation_velocity;
  plan.orient_angle = settings_.orientation_angle;
  plan.has_spindle_axis = settings_.has_spindle_axis;
  return plan;
}

/// Z, R and P stay until the cycle ends.
bool BlockRun::cycle_words() {
  CycleWords& words = registers.cycle;
  if (!cycle_level('R', words.r) || !cycle_level('Z', words.bottom)) return false;
  constexpr double kLongest_ms = 1e8;
  const Word* dwell = take('P');
  double milliseconds = 0.0;
  if (dwell == nullptr) return true;
  if (!value(*dwell, 0.0, kLongest_ms, milliseconds)) return false;
  words.dwell_s = milliseconds / 1000.0;
  return true;
}

bool BlockRun::cycle_level(char address, CycleLevel& level) {
  const Word* word = take(address);
  if (word == nullptr) return true;
  level.given = true;
  level.incremental = incremental();
  return distance(*word, level.value);
}

double BlockRun::level_of(const CycleLevel& level, double from) const {
  if (level.incremental) return from + level.value;
  return workpiece_origin(registers, tables_)[Axis::Z] + level.value;
}

/// All holes lie between the first and the last, all levels between the bottom and the highest of the others.
bool BlockRun::cycle_inside_travel(const TappingPlan& plan) {
  AxisVector low = plan.first_hole;
  AxisVector high = low + plan.step * static_cast<double>(plan.repetitions - 1);
  low[Axis::Z] = std::min({plan.r_level, plan.bottom, plan.return_level});
  high[Axis::Z] = std::max({plan.r_level, plan.bottom, plan.return_level});
  for (const AxisVector& corner : {low, high}) {
    if (const auto excess = rules_.travel().excess_of(corner))
      return refuse("over-travel", block_.span, rules_.travel().message_for(*excess));
  }
  return true;
}

}  // namespace kerf::omron
