// Whole runs: totals, records, traces, progress.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "motion/run.hpp"
#include "motion_test_support.hpp"

namespace kerf {
namespace {

using motion_test::at;
using motion_test::machine_with;
using motion_test::Path;

RunRecord run_path(const Path& path, const Machine& machine, const RunOptions& options = {},
                   const FeedPolicy& policy = {}) {
  std::size_t next = 0;
  return run(
      [&]() -> const Action* { return next < path.actions().size() ? &path.actions()[next++] : nullptr; },
      machine, policy, options);
}

/// Rapid 100 mm in X (200 mm/s: 0.5 s + 0.4 s), dwell, 50 mm in Y at 50 mm/s (1 s + 0.1 s), tool, spindle.
Path small_job() {
  return Path()
      .rapid(at({{Axis::X, 100.0}}))
      .action(Dwell{0.5})
      .line(at({{Axis::X, 100.0}, {Axis::Y, -50.0}}), 3000.0)
      .action(ToolChange{3, 2.0})
      .action(Spindle{SpindleDirection::clockwise, 5000.0, 0.25})
      .action(End{});
}

TEST(Run, AddsUpTimesLengthsAndCounts) {
  const RunSummary summary = run_path(small_job(), machine_with({Axis::X, Axis::Y})).summary;
  EXPECT_NEAR(summary.rapid_s, 0.9, 1e-9);
  EXPECT_NEAR(summary.dwell_s, 0.5, 1e-12);
  EXPECT_NEAR(summary.cutting_s, 1.1, 1e-9);
  EXPECT_NEAR(summary.tool_change_s, 2.0, 1e-12);
  EXPECT_NEAR(summary.spindle_wait_s, 0.25, 1e-12);
  EXPECT_NEAR(summary.time_s, 4.75, 1e-9);
  EXPECT_EQ(summary.cycles, 4750U);
  EXPECT_NEAR(summary.rapid_mm, 100.0, 1e-9);
  EXPECT_NEAR(summary.cutting_mm, 50.0, 1e-9);
  EXPECT_EQ(summary.blocks, 6U);
  EXPECT_EQ(summary.moves, 2U);
  EXPECT_EQ(summary.axes, (AxisSet{Axis::X, Axis::Y}));
  EXPECT_FALSE(summary.stalled);
}

TEST(Run, ReportsRangesAndPeaksPerAxis) {
  Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z});
  machine.axis[index(Axis::Z)].start = 7.0;
  const RunSummary summary = run_path(Path(at({{Axis::Z, 7.0}}))
                                          .rapid(at({{Axis::X, 30.0}, {Axis::Z, 7.0}}))
                                          .arc(20.0, 0.0, 180.0, 600.0),
                                      machine)
                                 .summary;
  // The arc of radius 10 from (30, 0) over (20, 10) to (10, 0).
  const auto bounds = [&](Axis axis) { return summary.bounds[index(axis)]; };
  EXPECT_NEAR(bounds(Axis::X).low, 0.0, 1e-9);
  EXPECT_NEAR(bounds(Axis::X).high, 30.0, 1e-9);
  EXPECT_NEAR(bounds(Axis::Y).low, 0.0, 1e-9);
  EXPECT_NEAR(bounds(Axis::Y).high, 10.0, 1e-9);
  EXPECT_NEAR(bounds(Axis::Z).low, 7.0, 1e-12);
  EXPECT_NEAR(bounds(Axis::Z).high, 7.0, 1e-12);
  // X: 30 mm from rest to rest at 500 mm/s2, the triangle of sqrt(500 30) mm/s. Y: the feed at the start of
  // the arc is still 0; half way it runs along X; at the quarter X has the full feed, Y at most that.
  EXPECT_NEAR(summary.peak[index(Axis::X)].velocity, 60.0 * std::sqrt(15000.0), 1e-6);
  EXPECT_NEAR(summary.peak[index(Axis::X)].acceleration, 500.0, 1e-6);
  EXPECT_GT(summary.peak[index(Axis::Y)].velocity, 590.0);
  EXPECT_LE(summary.peak[index(Axis::Y)].velocity, 600.0 * (1 + 1e-9));
  EXPECT_EQ(summary.peak[index(Axis::Z)].velocity, 0.0);
}

TEST(Run, WithoutARecordNothingIsKept) {
  const RunRecord record = run_path(small_job(), machine_with({Axis::X, Axis::Y}));
  EXPECT_TRUE(record.actions.empty());
  EXPECT_TRUE(record.speed.empty());
  EXPECT_FALSE(record.truncated);
}

TEST(Run, RecordsEveryActionWithItsTime) {
  RunOptions options;
  options.record = true;
  const RunRecord record = run_path(small_job(), machine_with({Axis::X, Axis::Y}), options);
  ASSERT_EQ(record.actions.size(), 6U);
  EXPECT_EQ(record.actions[2].action.origin.block, 3U);
  EXPECT_NEAR(record.actions[2].start_s, 1.4, 1e-9);
  EXPECT_NEAR(record.actions[2].duration_s, 1.1, 1e-9);
  EXPECT_NEAR(record.actions[2].length_mm, 50.0, 1e-9);
  EXPECT_NEAR(record.actions[2].peak_feed_mm_min, 3000.0, 1e-6);
  EXPECT_NEAR(record.actions[0].peak_feed_mm_min, 12000.0, 1e-6);
  EXPECT_NEAR(record.actions[3].start_s, 2.5, 1e-9);
  ASSERT_FALSE(record.speed.empty());
  double peak = 0.0;
  for (const SpeedSample& sample : record.speed) peak = std::max(peak, sample.feed_mm_min);
  EXPECT_NEAR(peak, 12000.0, 1e-6);
}

TEST(Run, KeepsTheRecordWithinItsSize) {
  Path path;
  Machine machine = machine_with({Axis::X});
  machine.cycle_s = 0.01;
  const std::size_t count = RunRecord::kMaxTimedActions + 10;
  Action action;
  Move move;
  move.mode = MoveMode::linear;
  move.feed = 6000.0;
  std::size_t next = 0;
  RunOptions options;
  options.record = true;
  const RunRecord record = run(
      [&]() -> const Action* {
        if (next == count) return nullptr;
        move.start = move.end;
        move.end[Axis::X] += next % 2 == 0 ? 0.01 : -0.01;
        action.what = move;
        action.origin.block = static_cast<std::uint32_t>(++next);
        return &action;
      },
      machine, {}, options);
  EXPECT_EQ(record.actions.size(), RunRecord::kMaxTimedActions);
  EXPECT_TRUE(record.truncated);
  EXPECT_LE(record.speed.size(), RunRecord::kMaxSpeedSamples);
  EXPECT_EQ(record.summary.moves, count);
}

TEST(Run, TracesEveryCycleWithTheSimulatedDrives) {
  RunOptions options;
  std::vector<Cycle> cycles;
  std::vector<double> lag;
  options.on_cycle = [&](const Cycle& cycle, const AxisVector& actual) {
    cycles.push_back(cycle);
    lag.push_back(cycle.position[Axis::X] - actual[Axis::X]);
  };
  Machine machine = machine_with({Axis::X});
  machine.motion.servo_gain = 50.0;
  const Path path = Path().line(at({{Axis::X, 100.0}}), 3000.0).action(Dwell{1.0});
  const RunRecord record = run_path(path, machine, options);
  ASSERT_EQ(cycles.size(), 3100U);
  EXPECT_EQ(record.summary.cycles, 3100U);
  EXPECT_NEAR(lag[1500], 50.0 / 50.0, 1e-6);  // 50 mm/s over a gain of 50 1/s
  EXPECT_NEAR(lag.back(), 0.0, 1e-9);
  EXPECT_EQ(cycles[10].origin.span.line, 1U);
  EXPECT_EQ(cycles.back().origin.span.line, 2U);
}

TEST(Run, CountsTheSameCyclesWhetherWaitsAreSkippedOrNot) {
  const Machine machine = machine_with({Axis::X, Axis::Y});
  RunOptions traced;
  std::uint64_t seen = 0;
  traced.on_cycle = [&](const Cycle&, const AxisVector&) { ++seen; };
  const RunSummary stepped = run_path(small_job(), machine, traced).summary;
  const RunSummary skipped = run_path(small_job(), machine).summary;
  EXPECT_EQ(seen, stepped.cycles);
  EXPECT_EQ(skipped.cycles, stepped.cycles);
  EXPECT_EQ(skipped.time_s, stepped.time_s);
}

TEST(Run, ProgressMayEndIt) {
  RunOptions options;
  options.progress_cycles = 100;
  options.on_cycle = [](const Cycle&, const AxisVector&) {};  // every cycle is stepped through
  int calls = 0;
  options.on_progress = [&](const RunProgress& progress) {
    EXPECT_GE(progress.cycles, static_cast<std::uint64_t>(calls) * 100U);
    return ++calls < 5;
  };
  const Path path = Path().line(at({{Axis::X, 100.0}}), 3000.0);
  const RunRecord record = run_path(path, machine_with({Axis::X}), options);
  EXPECT_EQ(calls, 5);
  EXPECT_LT(record.summary.cycles, 1000U);
}

TEST(Run, AFeedOfZeroEndsTheRun) {
  const Path path = Path().line(at({{Axis::X, 10.0}}), 600.0).line(at({{Axis::X, 20.0}}), 0.0);
  const RunRecord record = run_path(path, machine_with({Axis::X}));
  EXPECT_TRUE(record.summary.stalled);
  EXPECT_NEAR(record.summary.cutting_mm, 10.0, 1e-9);
}

TEST(Run, KeepsWarningsAndStaysBounded) {
  AlarmKind kind;
  kind.severity = Severity::warning;
  Alarm alarm;
  alarm.kind = &kind;
  Path few;
  few.action(alarm).action(alarm);
  EXPECT_EQ(run_path(few, machine_with({Axis::X})).summary.alarms.size(), 2U);
  Path many;
  for (std::size_t i = 0; i < RunRecord::kMaxAlarms + 5; ++i) many.action(alarm);
  AlarmKind fatal;
  alarm.kind = &fatal;
  many.action(alarm);
  const RunRecord record = run_path(many, machine_with({Axis::X}));
  EXPECT_EQ(record.summary.alarms.size(), RunRecord::kMaxAlarms);
  EXPECT_EQ(record.summary.alarms.front().kind, &kind);
  EXPECT_EQ(record.summary.alarms.back().kind, &fatal);  // what ended the program is never left out
  EXPECT_TRUE(record.truncated);
}

TEST(Run, AnEmptyProgramTakesNoTime) {
  const RunRecord record = run_path(Path(), machine_with({Axis::X}));
  EXPECT_EQ(record.summary.time_s, 0.0);
  EXPECT_EQ(record.summary.cycles, 0U);
}

}  // namespace
}  // namespace kerf
