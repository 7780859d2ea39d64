// Speed of the motion stage: planning, interpolation, and both together. Targets on one core: 2 million
// planned segments a second, 20 million cycles of eight axes a second, 1 million blocks of about five cycles
// a second.

#include <benchmark/benchmark.h>
#include <cmath>
#include <string>
#include <vector>

#include "motion/run.hpp"
#include "motion/trajectory.hpp"

namespace {

using namespace kerf;

Machine eight_axes() {
  Machine machine;
  machine.axes = {Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C, Axis::U, Axis::V};
  for (const Axis axis : machine.axes) {
    machine.axis[index(axis)].rapid = 20000.0;
    machine.axis[index(axis)].max_feed = 10000.0;
    machine.axis[index(axis)].acceleration = 2000.0;
  }
  return machine;
}

/// A wavy closed curve of chords, as a CAM system would write it.
std::vector<Action> polyline(std::size_t count, double chord_mm, double feed_mm_min) {
  std::vector<Action> actions(count);
  AxisVector position;
  for (std::size_t i = 0; i < count; ++i) {
    const double heading = 0.02 * static_cast<double>(i) + 0.3 * std::sin(0.1 * static_cast<double>(i));
    Move move;
    move.mode = MoveMode::linear;
    move.feed = feed_mm_min;
    move.start = position;
    position[Axis::X] += chord_mm * std::cos(heading);
    position[Axis::Y] += chord_mm * std::sin(heading);
    position[Axis::Z] += 0.1 * chord_mm * std::sin(3.0 * heading);
    move.end = position;
    actions[i].what = move;
    actions[i].origin.block = static_cast<std::uint32_t>(i + 1);
  }
  return actions;
}

/// Many segments a cycle, so that the time goes into planning.
void plan_short_segments(benchmark::State& state) {
  const std::vector<Action> actions = polyline(100'000, 0.001, 6000.0);
  Machine machine = eight_axes();
  machine.motion.look_ahead = static_cast<std::int32_t>(state.range(0));
  machine.cycle_s = 1.0;
  for (auto _ : state) {
    Trajectory trajectory(machine, FeedPolicy{});
    std::size_t next = 0;
    Cycle cycle;
    StepResult result = StepResult::cycle;
    while (result != StepResult::finished) {
      while (next < actions.size() && trajectory.wants_action()) trajectory.push(actions[next++]);
      if (next == actions.size()) trajectory.finish();
      result = trajectory.step(cycle);
    }
    benchmark::DoNotOptimize(cycle);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(actions.size()));
}
BENCHMARK(plan_short_segments)->Arg(64)->Arg(1024)->Arg(8192);

/// One line of all eight axes, stepped cycle by cycle.
void interpolate_line(benchmark::State& state) {
  Action action;
  Move move;
  move.mode = MoveMode::linear;
  move.feed = 600.0;
  for (const Axis axis : eight_axes().axes) move.end[axis] = 1000.0 + 10.0 * static_cast<double>(index(axis));
  action.what = move;
  std::int64_t cycles = 0;
  for (auto _ : state) {
    Trajectory trajectory(eight_axes(), FeedPolicy{});
    trajectory.push(action);
    trajectory.finish();
    Cycle cycle;
    while (trajectory.step(cycle) == StepResult::cycle) benchmark::DoNotOptimize(cycle);
    cycles += static_cast<std::int64_t>(trajectory.cycles());
  }
  state.SetItemsProcessed(cycles);
}
BENCHMARK(interpolate_line);

/// A helix of a hundred turns.
void interpolate_helix(benchmark::State& state) {
  Action action;
  Move move;
  move.mode = MoveMode::counterclockwise;
  move.feed = 600.0;
  move.start[Axis::X] = 10.0;
  move.end = move.start;
  move.end[Axis::Z] = 50.0;
  move.arc = {{0.0, 0.0}, 10.0, 36000.0};
  action.what = move;
  std::int64_t cycles = 0;
  for (auto _ : state) {
    Trajectory trajectory(eight_axes(), FeedPolicy{});
    trajectory.push(action);
    trajectory.finish();
    Cycle cycle;
    while (trajectory.step(cycle) == StepResult::cycle) benchmark::DoNotOptimize(cycle);
    cycles += static_cast<std::int64_t>(trajectory.cycles());
  }
  state.SetItemsProcessed(cycles);
}
BENCHMARK(interpolate_helix);

/// Blocks of about five cycles; range(0): whether everything is recorded.
void run_blocks(benchmark::State& state) {
  const std::vector<Action> actions = polyline(200'000, 0.25, 3000.0);
  RunOptions options;
  options.record = state.range(0) != 0;
  double cycles_per_block = 0.0;
  for (auto _ : state) {
    std::size_t next = 0;
    const RunRecord record =
        run([&]() -> const Action* { return next < actions.size() ? &actions[next++] : nullptr; },
            eight_axes(), FeedPolicy{}, options);
    cycles_per_block = static_cast<double>(record.summary.cycles) / static_cast<double>(actions.size());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(actions.size()));
  state.SetLabel(std::to_string(cycles_per_block) + " cycles a block");
}
BENCHMARK(run_blocks)->Arg(0)->Arg(1);

}  // namespace
