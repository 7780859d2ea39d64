#pragma once
// Machines, moves and sampled trajectories for the tests of the motion stage.

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

#include "motion/trajectory.hpp"

namespace kerf::motion_test {

/// Numbers from a fixed seed.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * unit_(engine_); }
  double magnitude(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  bool chance(double probability) { return unit_(engine_) < probability; }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

/// Every axis: rapid 12000 mm/min (200 mm/s), highest feed 6000 mm/min (100 mm/s), the given acceleration.
inline Machine machine_with(AxisSet axes, double acceleration = 500.0) {
  Machine machine;
  machine.axes = axes;
  for (const Axis axis : axes) {
    AxisSettings& settings = machine.axis[index(axis)];
    settings.rapid = 12000.0;
    settings.max_feed = 6000.0;
    settings.acceleration = acceleration;
  }
  return machine;
}

/// Accelerates at once and turns corners without slowing down: a move takes its distance divided by its feed.
inline Machine ideal_machine(AxisSet axes) {
  return machine_with(axes, 1e12);
}

inline AxisVector at(std::initializer_list<std::pair<Axis, double>> values) {
  AxisVector position;
  for (const auto& [axis, value] : values) position[axis] = value;
  return position;
}

/// Moves one after the other, numbered as blocks from 1.
class Path {
 public:
  explicit Path(AxisVector start = {}) : here_(start) {}

  Path& rapid(const AxisVector& end) { return add(move_to(MoveMode::rapid, end, 0.0)); }
  Path& line(const AxisVector& end, double feed) { return add(move_to(MoveMode::linear, end, feed)); }
  Path& rotary_line(const AxisVector& end, double feed, RotaryFeed rotary) {
    Move move = move_to(MoveMode::linear, end, feed);
    move.rotary_feed = rotary;
    return add(move);
  }
  /// Around a centre in the X-Y plane by a sweep in degrees; `others` is added to the axes outside the plane.
  Path& arc(double center_x, double center_y, double sweep, double feed, const AxisVector& others = {});
  Path& action(const ActionVariant& what) {
    Action action;
    action.what = what;
    return push(action);
  }

  const AxisVector& here() const { return here_; }
  const std::vector<Action>& actions() const { return actions_; }

 private:
  Move move_to(MoveMode mode, const AxisVector& end, double feed) const {
    Move move;
    move.mode = mode;
    move.start = here_;
    move.end = end;
    move.feed = feed;
    return move;
  }
  Path& add(const Move& move) {
    here_ = move.end;
    Action action;
    action.what = move;
    return push(action);
  }
  Path& push(Action action) {
    action.origin.block = static_cast<std::uint32_t>(actions_.size() + 1);
    action.origin.span.line = action.origin.block;
    actions_.push_back(action);
    return *this;
  }

  AxisVector here_;
  std::vector<Action> actions_;
};

inline Path& Path::arc(double center_x, double center_y, double sweep, double feed,
                       const AxisVector& others) {
  const double x = here_[Axis::X] - center_x;
  const double y = here_[Axis::Y] - center_y;
  const double angle = sweep * (3.14159265358979323846 / 180.0);
  AxisVector end = here_ + others;
  end[Axis::X] = center_x + x * std::cos(angle) - y * std::sin(angle);
  end[Axis::Y] = center_y + x * std::sin(angle) + y * std::cos(angle);
  Move move = move_to(sweep < 0.0 ? MoveMode::clockwise : MoveMode::counterclockwise, end, feed);
  move.arc = {{center_x, center_y}, std::hypot(x, y), sweep};
  return add(move);
}

/// Every cycle and every finished action of a trajectory.
struct Samples {
  std::vector<Cycle> cycles;
  std::vector<BlockTiming> blocks;
  double time_s = 0.0;
  MotionExtremes extremes;
};

/// Plays actions to the end; before every step calls `each_cycle(trajectory, cycles so far)`. Stops at a
/// hold.
template <class EachCycle>
Samples play(const Machine& machine, const std::vector<Action>& actions, const FeedPolicy& policy,
             EachCycle&& each_cycle) {
  Trajectory trajectory(machine, policy);
  Samples samples;
  std::size_t next = 0;
  bool finished = false;
  while (!finished) {
    while (next < actions.size() && trajectory.wants_action()) trajectory.push(actions[next++]);
    if (next == actions.size()) {
      trajectory.finish();
      ++next;
    }
    each_cycle(trajectory, samples.cycles.size());
    Cycle cycle;
    const StepResult result =
        trajectory.step(cycle, [&](const BlockTiming& timing) { samples.blocks.push_back(timing); });
    if (result == StepResult::cycle) samples.cycles.push_back(cycle);
    finished = result == StepResult::finished || result == StepResult::held;
  }
  samples.time_s = trajectory.time_s();
  samples.extremes = trajectory.extremes();
  return samples;
}

inline Samples play(const Machine& machine, const std::vector<Action>& actions,
                    const FeedPolicy& policy = {}) {
  return play(machine, actions, policy, [](Trajectory&, std::size_t) {});
}

}  // namespace kerf::motion_test
