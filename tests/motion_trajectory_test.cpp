// Times of trajectories against closed forms, and the rules of rest.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "motion/trajectory.hpp"
#include "motion_test_support.hpp"

namespace kerf {
namespace {

using motion_test::at;
using motion_test::ideal_machine;
using motion_test::machine_with;
using motion_test::Path;
using motion_test::play;
using motion_test::Samples;

constexpr double kPi = std::numbers::pi;

double time_of(const Machine& machine, const Path& path, const FeedPolicy& policy = {}) {
  return play(machine, path.actions(), policy).time_s;
}

TEST(Trajectory, LineTakesTheTimeOfATrapezoid) {
  // 100 mm at 50 mm/s, 500 mm/s2: 2 s + 50/500 s.
  const Samples samples =
      play(machine_with({Axis::X}), Path().line(at({{Axis::X, 100.0}}), 3000.0).actions());
  EXPECT_NEAR(samples.time_s, 2.1, 1e-12);
  EXPECT_EQ(samples.cycles.size(), 2100U);
  EXPECT_EQ(samples.cycles.back().position[Axis::X], 100.0);
  EXPECT_NEAR(samples.cycles.back().time_s, 2.1, 1e-12);
  // 0.05 s: half the ramp, 0.5 x 500 x 0.0025 mm.
  EXPECT_NEAR(samples.cycles[49].position[Axis::X], 0.625, 1e-12);
  EXPECT_NEAR(samples.cycles[49].velocity[Axis::X], 25.0, 1e-9);
  EXPECT_NEAR(samples.cycles[49].path_speed_mm_min, 1500.0, 1e-6);
  EXPECT_NEAR(samples.extremes.velocity[Axis::X], 50.0, 1e-9);
  EXPECT_NEAR(samples.extremes.acceleration[Axis::X], 500.0, 1e-9);
  // From 0 to 500 mm/s2 within one cycle of 1 ms.
  EXPECT_NEAR(samples.extremes.jerk[Axis::X], 500000.0, 1e-3);
}

TEST(Trajectory, ShortLineTakesTheTimeOfATriangle) {
  EXPECT_NEAR(time_of(machine_with({Axis::X}), Path().line(at({{Axis::X, 0.2}}), 3000.0)), 0.04, 1e-12);
}

TEST(Trajectory, TheEndLiesOnTheCycleAfterTheExactTime) {
  // 0.2 mm: 0.04 s; with cycles of 3 ms the 14th, at 0.042 s, is the first one after the end.
  Machine machine = machine_with({Axis::X});
  machine.cycle_s = 0.003;
  const Samples samples = play(machine, Path().line(at({{Axis::X, 0.2}}), 3000.0).actions());
  EXPECT_EQ(samples.cycles.size(), 14U);
  EXPECT_EQ(samples.cycles.back().position[Axis::X], 0.2);
  EXPECT_EQ(samples.cycles.back().velocity[Axis::X], 0.0);
  EXPECT_NEAR(samples.time_s, 0.04, 1e-12);
}

TEST(Trajectory, TangentLinesRunThrough) {
  Path path;
  for (int i = 1; i <= 10; ++i) path.line(at({{Axis::X, 10.0 * i}}), 3000.0);
  EXPECT_NEAR(time_of(machine_with({Axis::X}), path), 2.1, 1e-9);
}

TEST(Trajectory, SpeedRisesAndFallsBetweenFeeds) {
  // 50 mm at 50 mm/s, then 50 mm at 20 mm/s. Ramps: 0.1 s 2.5 mm; 50 -> 20 in 0.06 s 2.1 mm before the joint;
  // 0.04 s 0.4 mm at the end. Flat: 45.4 mm and 49.6 mm.
  const Path path = Path().line(at({{Axis::X, 50.0}}), 3000.0).line(at({{Axis::X, 100.0}}), 1200.0);
  EXPECT_NEAR(time_of(machine_with({Axis::X}), path), 0.1 + 45.4 / 50.0 + 0.06 + 49.6 / 20.0 + 0.04, 1e-9);
}

TEST(Trajectory, RightAngleIsPassedAtTheJunctionSpeed) {
  // v2 = 500 x 0.01 x 2.414214 = 12.071068. Each leg of 10 mm: rest to 50 mm/s (2.5 mm), down to v.
  const double corner = std::sqrt(12.0710678118655);
  const double down_way = (2500.0 - 12.0710678118655) / 1000.0;
  const double leg = 0.1 + (50.0 - corner) / 500.0 + (10.0 - 2.5 - down_way) / 50.0;
  const Path path =
      Path().line(at({{Axis::X, 10.0}}), 3000.0).line(at({{Axis::X, 10.0}, {Axis::Y, 10.0}}), 3000.0);
  EXPECT_NEAR(time_of(machine_with({Axis::X, Axis::Y}), path), 2.0 * leg, 1e-9);
}

TEST(Trajectory, DeviationZeroStopsAtTheCorner) {
  Machine machine = machine_with({Axis::X, Axis::Y});
  machine.motion.junction_deviation = 0.0;
  const Path path =
      Path().line(at({{Axis::X, 10.0}}), 3000.0).line(at({{Axis::X, 10.0}, {Axis::Y, 10.0}}), 3000.0);
  EXPECT_NEAR(time_of(machine, path), 2.0 * (0.2 + 0.1), 1e-9);
}

TEST(Trajectory, ArcIsLimitedByItsCentripetalAcceleration) {
  // Radius 1 mm, 500 mm/s2: 0.8 x 500 at 20 mm/s, 300 mm/s2 along the path. Half a circle, from rest to rest.
  const Path path = Path(at({{Axis::X, 1.0}})).arc(0.0, 0.0, 180.0, 6000.0);
  const Samples samples = play(machine_with({Axis::X, Axis::Y}), path.actions());
  EXPECT_NEAR(samples.time_s, kPi / 20.0 + 20.0 / 300.0, 1e-9);
  EXPECT_NEAR(samples.blocks[0].peak_feed_mm_min, 1200.0, 1e-6);
  EXPECT_LE(samples.extremes.acceleration[Axis::X], 500.0 * (1 + 1e-9));
  EXPECT_GT(samples.extremes.acceleration[Axis::X], 300.0);
}

TEST(Trajectory, LineRunsIntoATangentArc) {
  // 10 mm along Y, then a quarter of radius 10 to the left, at 20 mm/s: centripetal 40 mm/s2, far within.
  const double a = std::sqrt(500.0 * 500.0 - 160.0 * 160.0);  // room left at twice the feed: 1600 / 10
  const Path path = Path(at({{Axis::X, 10.0}, {Axis::Y, -10.0}}))
                        .line(at({{Axis::X, 10.0}}), 1200.0)
                        .arc(0.0, 0.0, 90.0, 1200.0);
  const double way = 10.0 + 5.0 * kPi;
  EXPECT_NEAR(time_of(machine_with({Axis::X, Axis::Y}), path), way / 20.0 + 10.0 / 500.0 + 10.0 / a, 1e-9);
}

TEST(Trajectory, RapidKeepsEveryAxisBelowItsOwnRate) {
  Machine machine = ideal_machine({Axis::X, Axis::Y});
  machine.axis[index(Axis::X)].rapid = 6000.0;
  machine.axis[index(Axis::Y)].rapid = 1200.0;
  // 100 mm in X need 1 s at 100 mm/s; 30 mm in Y need 1.5 s at 20 mm/s: a straight line in 1.5 s.
  const Path path = Path().rapid(at({{Axis::X, 100.0}, {Axis::Y, 30.0}}));
  const Samples samples = play(machine, path.actions());
  EXPECT_NEAR(samples.time_s, 1.5, 1e-6);
  EXPECT_NEAR(samples.cycles[599].position[Axis::X], 40.0, 1e-6);
  EXPECT_NEAR(samples.cycles[599].position[Axis::Y], 12.0, 1e-6);
  FeedPolicy half;
  half.rapid_override = 50.0;
  EXPECT_NEAR(time_of(machine, path, half), 3.0, 1e-6);
}

TEST(Trajectory, RapidsStartAndEndAtRest) {
  // Three tangent moves of 100 mm: feed at 100 mm/s, rapid at 200 mm/s, feed; each from rest to rest.
  const Path path = Path()
                        .line(at({{Axis::X, 100.0}}), 6000.0)
                        .rapid(at({{Axis::X, 200.0}}))
                        .rapid(at({{Axis::X, 300.0}}))
                        .line(at({{Axis::X, 400.0}}), 6000.0);
  EXPECT_NEAR(time_of(machine_with({Axis::X}), path), 2.0 * (1.0 + 0.2) + 2.0 * (0.5 + 0.4), 1e-9);
}

TEST(Trajectory, WaitingActionsStopTheMotionAndTakeTheirTime) {
  const Path path = Path()
                        .line(at({{Axis::X, 50.0}}), 3000.0)
                        .action(Dwell{0.75})
                        .line(at({{Axis::X, 100.0}}), 3000.0)
                        .action(ToolChange{2, 3.5})
                        .action(Spindle{SpindleDirection::clockwise, 8000.0, 1.25})
                        .action(Auxiliary{8});
  const Samples samples = play(machine_with({Axis::X}), path.actions());
  EXPECT_NEAR(samples.time_s, 2.0 * 1.1 + 0.75 + 3.5 + 1.25, 1e-9);
  ASSERT_EQ(samples.blocks.size(), 6U);
  EXPECT_EQ(samples.blocks[1].kind, BlockKind::dwell);
  EXPECT_NEAR(samples.blocks[1].start_s, 1.1, 1e-9);
  EXPECT_NEAR(samples.blocks[1].duration_s, 0.75, 1e-12);
  EXPECT_NEAR(samples.blocks[2].start_s, 1.85, 1e-9);
  EXPECT_EQ(samples.blocks[3].kind, BlockKind::tool_change);
  EXPECT_EQ(samples.blocks[4].kind, BlockKind::spindle);
  EXPECT_EQ(samples.blocks[5].duration_s, 0.0);
  EXPECT_EQ(samples.cycles.back().origin.block, 6U);
}

TEST(Trajectory, EveryKindOfNonMoveStopsTheMotion) {
  for (const ActionVariant& what :
       {ActionVariant(Auxiliary{7}), ActionVariant(Stop{}), ActionVariant(Dwell{0.0}),
        ActionVariant(Spindle{}), ActionVariant(ToolChange{}), ActionVariant(End{})}) {
    const Path path =
        Path().line(at({{Axis::X, 50.0}}), 3000.0).action(what).line(at({{Axis::X, 100.0}}), 3000.0);
    EXPECT_NEAR(time_of(machine_with({Axis::X}), path), 2.2, 1e-9) << what.index();
  }
}

TEST(Trajectory, WarningsDoNotStopTheMotionAndAlarmsDo) {
  AlarmKind kind;
  kind.severity = Severity::warning;
  Alarm alarm;
  alarm.kind = &kind;
  const Path path =
      Path().line(at({{Axis::X, 50.0}}), 3000.0).action(alarm).line(at({{Axis::X, 100.0}}), 3000.0);
  EXPECT_NEAR(time_of(machine_with({Axis::X}), path), 2.1, 1e-9);
  kind.severity = Severity::alarm;
  EXPECT_NEAR(time_of(machine_with({Axis::X}), path), 2.2, 1e-9);
}

TEST(Trajectory, MovesOfNoLengthDoNotDisturbTheirNeighbours) {
  const Path path = Path()
                        .line(at({{Axis::X, 50.0}}), 3000.0)
                        .line(at({{Axis::X, 50.0}}), 3000.0)
                        .line(at({{Axis::X, 100.0}}), 3000.0);
  const Samples samples = play(machine_with({Axis::X}), path.actions());
  EXPECT_NEAR(samples.time_s, 2.1, 1e-9);
  ASSERT_EQ(samples.blocks.size(), 3U);
  EXPECT_EQ(samples.blocks[1].duration_s, 0.0);
}

TEST(Trajectory, NothingButMovesOfNoLengthEndsAtOnce) {
  Path path;
  for (int i = 0; i < 3000; ++i) path.line({}, 600.0).rapid({});
  const Samples samples = play(machine_with({Axis::X}), path.actions());
  EXPECT_EQ(samples.time_s, 0.0);
  EXPECT_EQ(samples.blocks.size(), 6000U);
}

TEST(Trajectory, FeedPolicyApplies) {
  FeedPolicy policy;
  policy.resolution = 6.0;
  policy.feed_override = 200.0;
  // F50 at 200 %: 100, rounded to 102 mm/min = 1.7 mm/s.
  EXPECT_NEAR(time_of(ideal_machine({Axis::X}), Path().line(at({{Axis::X, 17.0}}), 50.0), policy), 10.0,
              1e-5);
}

TEST(Trajectory, TheCutNeverExceedsAnAxisMaximum) {
  Machine machine = ideal_machine({Axis::X, Axis::Y});
  machine.axis[index(Axis::Y)].max_feed = 600.0;
  // F6000 along (3, 4): Y at most 10 mm/s, so 40 mm take 4 s.
  EXPECT_NEAR(time_of(machine, Path().line(at({{Axis::X, 30.0}, {Axis::Y, 40.0}}), 6000.0)), 4.0, 1e-6);
}

TEST(Trajectory, AFeedOfZeroIsHeldAndGoesOnWhenTheOverrideRises) {
  Trajectory trajectory(machine_with({Axis::X}), FeedPolicy{.feed_override = 0.0});
  trajectory.push(Path().line(at({{Axis::X, 100.0}}), 3000.0).actions()[0]);
  trajectory.finish();
  Cycle cycle;
  for (int i = 0; i < 10; ++i) ASSERT_EQ(trajectory.step(cycle), StepResult::held);
  EXPECT_EQ(cycle.position[Axis::X], 0.0);
  trajectory.set_feed_override(100.0);
  int cycles = 0;
  while (trajectory.step(cycle) == StepResult::cycle) ++cycles;
  EXPECT_EQ(cycles, 2100);
  EXPECT_EQ(cycle.position[Axis::X], 100.0);
}

TEST(Trajectory, MoreActionsMayFollowAFinish) {
  Trajectory trajectory(machine_with({Axis::X}), FeedPolicy{});
  Cycle cycle;
  EXPECT_EQ(trajectory.step(cycle), StepResult::needs_action);
  const Path path = Path().line(at({{Axis::X, 50.0}}), 3000.0).line(at({{Axis::X, 100.0}}), 3000.0);
  for (const Action& action : path.actions()) {
    trajectory.push(action);
    trajectory.finish();
    while (trajectory.step(cycle) == StepResult::cycle) {
    }
  }
  EXPECT_NEAR(trajectory.time_s(), 2.2, 1e-9);
  EXPECT_EQ(cycle.position[Axis::X], 100.0);
}

TEST(Trajectory, TheClockWaitsWhileActionsAreMissing) {
  // The cycle that needs the second line is not lost: without finish() the lines run through.
  Machine machine = machine_with({Axis::X});
  machine.motion.look_ahead = 4;
  Path path;
  for (int i = 1; i <= 40; ++i) path.line(at({{Axis::X, 2.5 * i}}), 3000.0);
  Trajectory trajectory(machine, FeedPolicy{});
  Cycle cycle;
  double last = 0.0;
  std::size_t next = 0;
  std::size_t starved = 0;
  for (;;) {
    const StepResult result = trajectory.step(cycle);
    if (result == StepResult::finished) break;
    if (result == StepResult::needs_action) {
      ++starved;
      if (next < path.actions().size()) {
        trajectory.push(path.actions()[next++]);
      } else {
        trajectory.finish();
      }
      continue;
    }
    ASSERT_LE(cycle.position[Axis::X] - last, 50.0 * 0.001 + 1e-12);
    last = cycle.position[Axis::X];
  }
  EXPECT_GT(starved, 30U);
  EXPECT_EQ(last, 100.0);
}

TEST(Trajectory, AStopReleasesEverythingBeforeIt) {
  // The second line starts from rest, so nothing that may follow can change what comes before it.
  const Path path =
      Path().line(at({{Axis::X, 50.0}}), 3000.0).action(Dwell{0.75}).line(at({{Axis::X, 100.0}}), 3000.0);
  Trajectory trajectory(machine_with({Axis::X}), FeedPolicy{});
  for (const Action& action : path.actions()) trajectory.push(action);
  Cycle cycle;
  std::size_t done = 0;
  int cycles = 0;
  while (trajectory.step(cycle, [&](const BlockTiming&) { ++done; }) == StepResult::cycle) ++cycles;
  EXPECT_EQ(done, 2U);
  EXPECT_EQ(cycles, 1849);  // the cycle at 1.85 s belongs to the second line too
  EXPECT_EQ(cycle.position[Axis::X], 50.0);
}

TEST(Trajectory, WaitingCyclesCanBeSkipped) {
  Trajectory trajectory(machine_with({Axis::X}), FeedPolicy{});
  trajectory.push(Path().action(Dwell{1000.0}).actions()[0]);
  trajectory.finish();
  Cycle cycle;
  ASSERT_EQ(trajectory.step(cycle), StepResult::cycle);
  EXPECT_GT(trajectory.skip_steady(), 999'990U);
  while (trajectory.step(cycle) == StepResult::cycle) {
  }
  EXPECT_EQ(trajectory.cycles(), 1'000'000U);
  EXPECT_NEAR(trajectory.time_s(), 1000.0, 1e-9);
}

TEST(Trajectory, CyclesOfConstantSpeedCanBeSkipped) {
  // 100 mm at 60 mm/min: a hundred seconds, all but the ends of it at constant speed.
  const auto played = [](bool skip) {
    Trajectory trajectory(machine_with({Axis::X, Axis::Y}), FeedPolicy{});
    const Path path =
        Path().line(at({{Axis::X, 100.0}}), 60.0).line(at({{Axis::X, 100.0}, {Axis::Y, 1.0}}), 600.0);
    for (const Action& action : path.actions()) trajectory.push(action);
    trajectory.finish();
    Cycle cycle;
    std::uint64_t steps = 0;
    while (trajectory.step(cycle) == StepResult::cycle) {
      ++steps;
      if (skip) trajectory.skip_steady();
    }
    return std::tuple(trajectory.cycles(), trajectory.time_s(), cycle.position[Axis::Y],
                      trajectory.extremes().jerk[Axis::X], trajectory.extremes().velocity[Axis::X], steps);
  };
  const auto whole = played(false);
  const auto skipped = played(true);
  EXPECT_EQ(std::get<0>(skipped), std::get<0>(whole));
  EXPECT_EQ(std::get<1>(skipped), std::get<1>(whole));
  EXPECT_EQ(std::get<2>(skipped), std::get<2>(whole));
  EXPECT_EQ(std::get<3>(skipped), std::get<3>(whole));
  EXPECT_EQ(std::get<4>(skipped), std::get<4>(whole));
  EXPECT_LT(std::get<5>(skipped), 1'000U);
}

}  // namespace
}  // namespace kerf
