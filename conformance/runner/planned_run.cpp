#include "conformance/runner/planned_run.hpp"

#include "motion/trajectory.hpp"

namespace kerf::conformance {
namespace {

constexpr double kRounding = 1e-9;  // s

AxisVector between(const Cycle& before, const Cycle& after, double time_s) {
  const double step = after.time_s - before.time_s;
  const double part = step > 0.0 ? (time_s - before.time_s) / step : 1.0;
  AxisVector position;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    position.values[i] =
        before.position.values[i] + part * (after.position.values[i] - before.position.values[i]);
  }
  return position;
}

/// Plays actions cycle by cycle.
class Player {
 public:
  Player(const std::vector<Action>& actions, const Controller& controller,
         const std::vector<OverrideChange>& changes, const std::vector<double>& times_s)
      : actions_(actions),
        changes_(changes),
        times_s_(times_s),
        trajectory_(controller.machine, controller.feed_policy) {
    run_.positions.resize(times_s.size());
    for (const Axis axis : controller.machine.axes) before_.position[axis] = controller.machine[axis].start;
    for (const Action& action : actions) {
      const auto* move = std::get_if<Move>(&action.what);
      if (move == nullptr) continue;
      before_.position = move->start;
      break;
    }
  }

  PlannedRun play() {
    const auto book = [this](const BlockTiming& timing) {
      const bool moves = timing.kind == BlockKind::rapid || timing.kind == BlockKind::cutting;
      if (moves) run_.motion_s += timing.duration_s;
    };
    change_overrides(0.0);
    for (;;) {
      feed();
      const StepResult result = trajectory_.step(cycle_, book);
      if (result == StepResult::finished || result == StepResult::held) break;
      if (result == StepResult::needs_action) continue;
      take_cycle();
    }
    run_.time_s = trajectory_.time_s();
    return std::move(run_);
  }

 private:
  void feed() {
    while (next_ < actions_.size() && trajectory_.wants_action()) trajectory_.push(actions_[next_++]);
    if (next_ == actions_.size()) trajectory_.finish();
  }

  void take_cycle() {
    for (std::size_t i = 0; i < times_s_.size(); ++i) {
      const bool reached = cycle_.time_s >= times_s_[i] - kRounding;
      if (reached && !run_.positions[i]) run_.positions[i] = between(before_, cycle_, times_s_[i]);
    }
    change_overrides(cycle_.time_s);
    before_ = cycle_;
    if (times_s_.empty() && changes_.empty()) trajectory_.skip_steady();
  }

  void change_overrides(double time_s) {
    for (; changed_ < changes_.size() && changes_[changed_].time_s <= time_s + kRounding; ++changed_) {
      const OverrideChange& change = changes_[changed_];
      if (change.feed_percent) trajectory_.set_feed_override(*change.feed_percent);
      if (change.rapid_percent) trajectory_.set_rapid_override(*change.rapid_percent);
    }
  }

  const std::vector<Action>& actions_;
  const std::vector<OverrideChange>& changes_;
  const std::vector<double>& times_s_;
  Trajectory trajectory_;
  Cycle before_;
  Cycle cycle_;
  std::size_t next_ = 0;
  std::size_t changed_ = 0;
  PlannedRun run_;
};

}  // namespace

PlannedRun plan(const std::vector<Action>& actions, const Controller& controller,
                const std::vector<OverrideChange>& changes, const std::vector<double>& times_s) {
  return Player(actions, controller, changes, times_s).play();
}

}  // namespace kerf::conformance
