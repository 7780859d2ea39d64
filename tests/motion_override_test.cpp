// Changes of the overrides in the middle of moves.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "motion_test_support.hpp"

namespace kerf {
namespace {

using motion_test::at;
using motion_test::machine_with;
using motion_test::Path;
using motion_test::play;
using motion_test::Samples;

/// Sets the feed override before the cycle that follows `cycle` given ones.
auto change_at(std::size_t cycle, double percent) {
  return [=](Trajectory& trajectory, std::size_t given) {
    if (given == cycle) trajectory.set_feed_override(percent);
  };
}

TEST(MotionOverride, LoweredInMidMoveBrakesWithinTheAcceleration) {
  // 100 mm/s; at 0.5 s, 40 mm, the override falls to 50 %: 0.1 s and 7.5 mm down to 50 mm/s, the ramp to rest
  // takes 0.1 s and 2.5 mm, the 50 mm between 1 s.
  const Path path = Path().line(at({{Axis::X, 100.0}}), 6000.0);
  const Samples samples = play(machine_with({Axis::X}), path.actions(), {}, change_at(500, 50.0));
  EXPECT_NEAR(samples.time_s, 0.5 + 0.1 + 1.0 + 0.1, 1e-9);
  EXPECT_NEAR(samples.cycles[499].position[Axis::X], 40.0, 1e-9);
  EXPECT_NEAR(samples.cycles[549].velocity[Axis::X], 75.0, 1e-9);
  EXPECT_NEAR(samples.cycles[699].velocity[Axis::X], 50.0, 1e-9);
  EXPECT_EQ(samples.cycles.back().position[Axis::X], 100.0);
  ASSERT_EQ(samples.blocks.size(), 1U);
  EXPECT_NEAR(samples.blocks[0].duration_s, 1.7, 1e-9);
  EXPECT_NEAR(samples.blocks[0].peak_feed_mm_min, 6000.0, 1e-6);
}

TEST(MotionOverride, RaisedInMidMoveAccelerates) {
  // At 50 %: 0.1 s and 2.5 mm to 50 mm/s; at 0.5 s 22.5 mm are done. At 100 %: 0.1 s and 7.5 mm to 100 mm/s,
  // the last ramp 0.2 s and 10 mm, 60 mm between in 0.6 s.
  FeedPolicy half;
  half.feed_override = 50.0;
  const Path path = Path().line(at({{Axis::X, 100.0}}), 6000.0);
  const Samples samples = play(machine_with({Axis::X}), path.actions(), half, change_at(500, 100.0));
  EXPECT_NEAR(samples.time_s, 0.5 + 0.1 + 0.6 + 0.2, 1e-9);
  EXPECT_EQ(samples.cycles.back().position[Axis::X], 100.0);
}

TEST(MotionOverride, BrakingGoesOnOverShortSegments) {
  // The same as in one move, in segments of 0.5 mm: 7.5 mm of braking are fifteen of them.
  Path path;
  for (int i = 1; i <= 200; ++i) path.line(at({{Axis::X, 0.5 * i}}), 6000.0);
  const Machine machine = machine_with({Axis::X});
  const Samples samples = play(machine, path.actions(), {}, change_at(500, 50.0));
  EXPECT_NEAR(samples.time_s, 1.7, 1e-7);
  for (std::size_t i = 2; i < samples.cycles.size(); ++i) {
    const double difference = samples.cycles[i].position[Axis::X] -
                              2.0 * samples.cycles[i - 1].position[Axis::X] +
                              samples.cycles[i - 2].position[Axis::X];
    ASSERT_LE(std::abs(difference) / 1e-6, 500.0 + 1e-2);
  }
}

TEST(MotionOverride, ZeroHoldsAndALaterValueGoesOn) {
  Trajectory trajectory(machine_with({Axis::X}), FeedPolicy{});
  trajectory.push(Path().line(at({{Axis::X, 100.0}}), 6000.0).actions()[0]);
  trajectory.finish();
  Cycle cycle;
  for (int i = 0; i < 500; ++i) ASSERT_EQ(trajectory.step(cycle), StepResult::cycle);
  trajectory.set_feed_override(0.0);
  // 100 mm/s to rest: 0.2 s, 10 mm.
  for (int i = 0; i < 199; ++i) ASSERT_EQ(trajectory.step(cycle), StepResult::cycle);
  for (int i = 0; i < 300; ++i) trajectory.step(cycle);
  EXPECT_EQ(trajectory.step(cycle), StepResult::held);
  EXPECT_NEAR(cycle.position[Axis::X], 50.0, 1e-9);
  EXPECT_EQ(cycle.velocity[Axis::X], 0.0);
  trajectory.set_feed_override(100.0);
  int cycles = 0;
  while (trajectory.step(cycle) == StepResult::cycle) ++cycles;
  EXPECT_EQ(cycles, 700);  // 50 mm from rest to rest at 100 mm/s
  EXPECT_EQ(cycle.position[Axis::X], 100.0);
}

TEST(MotionOverride, RapidOverrideTakesEffectInMidMove) {
  // 200 mm/s with 500 mm/s2: 0.4 s and 40 mm. At 0.5 s, 60 mm, down to 100 mm/s: 0.2 s and 30 mm; the last
  // ramp 0.2 s and 10 mm; 100 mm between in 1 s.
  const Path path = Path().rapid(at({{Axis::X, 200.0}}));
  const Samples samples =
      play(machine_with({Axis::X}), path.actions(), {}, [](Trajectory& trajectory, std::size_t given) {
        if (given == 500) trajectory.set_rapid_override(50.0);
        if (given == 600) trajectory.set_feed_override(10.0);  // does not concern a rapid move
      });
  EXPECT_NEAR(samples.time_s, 0.5 + 0.2 + 1.0 + 0.2, 1e-9);
}

/// Lines and arcs with corners; overrides change every few cycles, up to 250 %.
TEST(MotionOverride, RandomChangesKeepAccelerationsAndStopsAtCorners) {
  const double acceleration = 500.0;
  Machine machine = machine_with({Axis::X, Axis::Y}, acceleration);
  machine.motion.junction_deviation = 0.0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Path path;
    for (int i = 0; i < 60; ++i) {
      AxisVector end = path.here();
      end[Axis::X] += 4.0 * unit(engine) - 1.0;
      end[Axis::Y] += 4.0 * unit(engine) - 2.0;
      if (unit(engine) < 0.6) {
        path.line(end, 2500.0);
      } else {
        path.arc(end[Axis::X], end[Axis::Y], 400.0 * unit(engine) - 200.0, 2500.0);
      }
    }
    const Samples samples = play(machine, path.actions(), {}, [&](Trajectory& trajectory, std::size_t) {
      if (unit(engine) < 0.05) trajectory.set_feed_override(5.0 + 245.0 * unit(engine));
    });
    ASSERT_EQ(samples.cycles.back().position, path.here());
    const double one_cycle = std::numbers::sqrt2 * acceleration * machine.cycle_s;
    for (std::size_t i = 2; i < samples.cycles.size(); ++i) {
      const Cycle& a = samples.cycles[i - 2];
      const Cycle& b = samples.cycles[i - 1];
      const Cycle& c = samples.cycles[i];
      if (b.origin.block != c.origin.block) {
        ASSERT_LE(b.path_speed_mm_min / 60.0, one_cycle) << c.time_s;
        ASSERT_LE(c.path_speed_mm_min / 60.0, one_cycle) << c.time_s;
      }
      for (const Axis axis : machine.axes) {
        ASSERT_LE(std::abs(c.position[axis] - b.position[axis]), 0.1 * (1.0 + 1e-9)) << c.time_s;
        const double difference = a.position[axis] - 2.0 * b.position[axis] + c.position[axis];
        // At a corner one axis may stop while it brakes and the other start: still each within its own limit.
        ASSERT_LE(std::abs(difference) / 1e-6, acceleration * (1.0 + 1e-6) + 1e-2) << c.time_s;
      }
    }
  }
}

}  // namespace
}  // namespace kerf
