#include "motion/run.hpp"

#include <algorithm>
#include <optional>

#include "motion/servo.hpp"
#include "motion/speed_chart.hpp"
#include "motion/trajectory.hpp"

namespace kerf {
namespace {

constexpr double kSecondsPerMinute = 60.0;

AxisVector start_position(const Machine& machine) {
  AxisVector position;
  for (const Axis axis : machine.axes) position[axis] = machine[axis].start;
  return position;
}

/// One run: feeds the trajectory, steps it, and books what comes out.
class Runner {
 public:
  Runner(ActionSource next, const Machine& machine, const FeedPolicy& policy, const RunOptions& options)
      : next_(next), machine_(machine), options_(options), trajectory_(machine, policy) {
    if (options.on_cycle) servo_.emplace(machine.motion, machine.cycle_s, start_position(machine));
    if (options.record) chart_.emplace(RunRecord::kMaxSpeedSamples, machine.cycle_s);
  }

  RunRecord play() {
    while (running_) {
      feed();
      const StepResult result = trajectory_.step(cycle_, [this](const BlockTiming& timing) { book(timing); });
      if (result == StepResult::finished) break;
      if (result == StepResult::needs_action) continue;
      if (result == StepResult::held) {
        record_.summary.stalled = true;
        break;
      }
      take_cycle();
    }
    close();
    return std::move(record_);
  }

 private:
  /// Fills the look-ahead as far as there is room.
  void feed() {
    while (!exhausted_ && trajectory_.wants_action()) {
      const Action* action = next_();
      if (action == nullptr) {
        exhausted_ = true;
        trajectory_.finish();
        return;
      }
      note(*action);
      trajectory_.push(*action);
    }
  }

  /// Books what is known of an action before it is performed.
  void note(const Action& action) {
    RunSummary& summary = record_.summary;
    summary.blocks = std::max<std::uint64_t>(summary.blocks, action.origin.block);
    if (std::holds_alternative<Move>(action.what)) ++summary.moves;
    if (const auto* alarm = std::get_if<Alarm>(&action.what)) note_alarm(*alarm);
    if (!options_.record) return;
    if (record_.actions.size() < RunRecord::kMaxTimedActions) {
      record_.actions.push_back({action, 0.0, 0.0, 0.0, 0.0});
    } else {
      record_.truncated = true;
    }
  }

  /// Warnings beyond the limit are left out; an alarm that ends the program never is.
  void note_alarm(const Alarm& alarm) {
    std::vector<Alarm>& alarms = record_.summary.alarms;
    if (alarms.size() < RunRecord::kMaxAlarms) {
      alarms.push_back(alarm);
      return;
    }
    record_.truncated = true;
    if (stops_program(alarm)) alarms.back() = alarm;
  }

  /// Books a finished action. They finish in the order they were pushed.
  void book(const BlockTiming& timing) {
    RunSummary& summary = record_.summary;
    switch (timing.kind) {
      case BlockKind::rapid:
        summary.rapid_s += timing.duration_s;
        summary.rapid_mm += timing.length_mm;
        break;
      case BlockKind::cutting:
        summary.cutting_s += timing.duration_s;
        summary.cutting_mm += timing.length_mm;
        break;
      case BlockKind::dwell:
        summary.dwell_s += timing.duration_s;
        break;
      case BlockKind::tool_change:
        summary.tool_change_s += timing.duration_s;
        break;
      case BlockKind::spindle:
        summary.spindle_wait_s += timing.duration_s;
        break;
      case BlockKind::other:
        break;
    }
    if (finished_ < record_.actions.size()) {
      TimedAction& timed = record_.actions[finished_];
      timed.start_s = timing.start_s;
      timed.duration_s = timing.duration_s;
      timed.length_mm = timing.length_mm;
      timed.peak_feed_mm_min = timing.peak_feed_mm_min;
    }
    ++finished_;
  }

  void take_cycle() {
    if (chart_) chart_->add({cycle_.time_s, cycle_.path_speed_mm_min, cycle_.origin.span.line});
    if (servo_) {
      options_.on_cycle(cycle_, servo_->step(cycle_.position));
    } else {
      trajectory_.skip_steady();
    }
    if (!options_.on_progress || trajectory_.cycles() < next_progress_) return;
    next_progress_ = trajectory_.cycles() + options_.progress_cycles;
    running_ = options_.on_progress({cycle_.time_s, record_.summary.blocks, trajectory_.cycles()});
  }

  void close() {
    RunSummary& summary = record_.summary;
    summary.time_s = trajectory_.time_s();
    summary.cycles = trajectory_.cycles();
    summary.axes = machine_.axes;
    const MotionExtremes& extremes = trajectory_.extremes();
    for (const Axis axis : machine_.axes) {
      summary.bounds[index(axis)] = {extremes.low[axis], extremes.high[axis]};
      summary.peak[index(axis)] = {extremes.velocity[axis] * kSecondsPerMinute, extremes.acceleration[axis],
                                   extremes.corner_step[axis], extremes.jerk[axis]};
    }
    if (chart_) record_.speed = chart_->take();
    if (finished_ < record_.actions.size()) {
      record_.actions.erase(record_.actions.begin() + static_cast<std::ptrdiff_t>(finished_),
                            record_.actions.end());
    }
  }

  ActionSource next_;
  const Machine& machine_;
  const RunOptions& options_;
  Trajectory trajectory_;
  std::optional<ServoModel> servo_;
  std::optional<SpeedChart> chart_;
  Cycle cycle_;
  RunRecord record_;
  std::size_t finished_ = 0;  ///< actions
  std::uint64_t next_progress_ = 0;
  bool exhausted_ = false;
  bool running_ = true;
};

}  // namespace

RunRecord run(ActionSource next, const Machine& machine, const FeedPolicy& policy,
              const RunOptions& options) {
  return Runner(next, machine, policy, options).play();
}

}  // namespace kerf
