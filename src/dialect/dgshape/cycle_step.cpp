// Fixed cycles G81, G82, G83, G85, G86, G89 (manual 2-2).

#include <algorithm>
#include <cmath>

#include "dialect/dgshape/block_run.hpp"
#include "execute/moves.hpp"

namespace kerf::dgshape {
namespace {

constexpr WordMask kCycleTriggers = mask_of("XYZR");
constexpr double kClearance = 1.0;  // mm, the fixed d of G83
constexpr double kMostSteps = 1e5;  // a hole of 100 mm in steps of 0.001 mm
constexpr double kLongestDwell = 3600.0;

bool has_dwell(CodeNumber cycle) {
  return cycle == code(82) || cycle == code(89);
}

bool feeds_out(CodeNumber cycle) {
  return cycle == code(85) || cycle == code(89);
}

/// Strokes of all holes together.
double steps_of(const DrillingPlan& plan) {
  if (!plan.drills || plan.peck <= 0.0) return plan.repetitions;
  return plan.repetitions * std::ceil((plan.r_level - plan.bottom) / plan.peck);
}

}  // namespace

bool BlockRun::fixed_cycle() {
  // G51 in the block takes the axis words for its reference point.
  if (words_.has(Group::scaling) && words_[Group::scaling] == code(51)) return true;
  if (!cycle_allowed()) return false;
  std::int32_t repetitions = 1;
  if (!cycle_words() || !cycle_dwell_and_step() || !cycle_repetitions(repetitions)) return false;
  if ((words_.present() & kCycleTriggers) == 0) return true;
  const CodeNumber cycle = registers.modal[Group::fixed_cycle];
  const CycleWords& words = registers.cycle;

  AxisVector hole = registers.position;
  if (!target_of_words("XY", hole)) return false;
  DrillingPlan plan;
  plan.repetitions = repetitions;
  plan.first_hole = hole;
  if (incremental()) plan.step = hole - registers.position;
  plan.drills = words.bottom.given;
  // In G91 R counts from the initial level, where the tool need not stand after G99, and Z from R.
  plan.r_level = words.r.given ? cycle_level(words.r, words.initial_level) : words.initial_level;
  plan.bottom = cycle_level(words.bottom, plan.r_level);
  plan.return_level = registers.modal[Group::return_level] == code(98) ? words.initial_level : plan.r_level;
  plan.peck = cycle == code(83) ? scaled_length(words.peck) : 0.0;
  plan.clearance = kClearance;
  plan.dwell_s = has_dwell(cycle) ? words.dwell_s : 0.0;
  plan.feed_out = feeds_out(cycle);
  plan.spindle_stop = cycle == code(86) && settings_.cycle_spindle_stop;
  plan.spindle_rpm = effective_rpm(settings_, registers.spindle_rpm);
  plan.spindle_wait_s = settings_.spindle_delay_s;
  if (plan.drills && plan.bottom > plan.r_level) {
    return refuse(
        "cycle-levels", words_.has('Z') ? span('Z') : block_.span,
        FixedText<200>::format("The bottom lies {:.3f} mm above point R.", plan.bottom - plan.r_level));
  }
  const bool needs_step = cycle == code(83) && plan.drills && plan.peck == 0.0;
  if (needs_step && !settings_.single_stroke_without_q) {
    return refuse("missing-word", block_.span, "G83 needs the depth of a step, Q.");
  }
  if (steps_of(plan) > kMostSteps) {
    return refuse(
        "cycle-steps", words_.has('Q') ? span('Q') : block_.span,
        FixedText<200>::format("The block would make {:.0f} steps of {:.3f} mm.", steps_of(plan), plan.peck));
  }
  registers.unit_locked = true;
  if (!cycle_inside_travel(plan)) return false;
  if (registers.offset_return_pending && plan.repetitions > 0) {
    // The tool stands beside the path after a bare G40: X and Y come first, as always.
    if (!push_move(MoveMode::rapid, plan.first_hole)) return false;
    last_move().axis_words = true;
    registers.offset_return_pending = false;
  }
  drilling = plan;
  return true;
}

bool BlockRun::cycle_inside_travel(const DrillingPlan& plan) {
  if (settings_.clip_over_travel || plan.repetitions == 0) return true;
  // All holes lie between the first and the last, and all levels between the bottom and the highest of the
  // others.
  AxisVector first = plan.first_hole;
  AxisVector last = first;
  for (Axis axis : {Axis::X, Axis::Y}) last[axis] += plan.step[axis] * (plan.repetitions - 1);
  if (plan.drills) {
    first[Axis::Z] = std::max({plan.r_level, plan.return_level, registers.position[Axis::Z]});
    last[Axis::Z] = plan.bottom;
  }
  const Travel& travel = rules_.travel();
  for (const AxisVector& corner : {first, last}) {
    if (const auto excess = travel.excess_of(with_length(corner, registers.length_applied))) {
      return refuse_travel(*excess);
    }
  }
  return true;
}

bool BlockRun::cycle_allowed() {
  if (words_.has('A')) return refuse("cycle-axis", span('A'));
  const bool starts = words_.has(Group::fixed_cycle);
  if (!starts && (words_.present() & kCycleTriggers) == 0) return true;
  if (registers.modal[Group::plane] != code(17)) return refuse("cycle-plane", block_.span);
  if (!registers.spindle_on) return refuse("spindle-stopped", block_.span);
  if (!registers.feed_given && !settings_.minimum_feed_without_f) return refuse("no-feed", block_.span);
  return true;
}

double BlockRun::cycle_level(const CycleLevel& level, double from) const {
  return level.incremental ? from + scaled_length(level.value) : absolute_destination(Axis::Z, level.value);
}

bool BlockRun::cycle_words() {
  for (const char address : {'R', 'Z'}) {
    if (!words_.has(address)) continue;
    CycleLevel& level = address == 'R' ? registers.cycle.r : registers.cycle.bottom;
    if (!read_distance(address, level.value)) return false;
    level.given = true;
    level.incremental = incremental();
  }
  return true;
}

bool BlockRun::cycle_dwell_and_step() {
  const CodeNumber cycle = registers.modal[Group::fixed_cycle];
  double value = 0.0;
  if (words_.has('Q') && cycle == code(83)) {
    if (!read_distance('Q', value)) return false;
    registers.cycle.peck = std::abs(value);  // the sign has no meaning (DGS-475)
  }
  if (words_.has('P') && has_dwell(cycle)) {
    if (!read_integer('P', value)) return false;
    registers.cycle.dwell_s = std::clamp(value / 1000.0, 0.0, kLongestDwell);
  }
  return true;
}

bool BlockRun::cycle_repetitions(std::int32_t& repetitions) {
  if (!words_.has('K')) return true;
  double value = 0.0;
  if (!read_integer('K', value)) return false;
  if (value < 0.0 || value > 9999.0) return refuse("repeat-count", span('K'));
  repetitions = static_cast<std::int32_t>(value);
  return true;
}

}  // namespace kerf::dgshape
