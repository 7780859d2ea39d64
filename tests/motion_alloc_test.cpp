// Once constructed, a trajectory, the simulated drives and the speed chart allocate nothing; nor does a run
// per block.

#include <cmath>
#include <gtest/gtest.h>

#include "allocation_counter.hpp"
#include "motion/run.hpp"
#include "motion/servo.hpp"
#include "motion/speed_chart.hpp"
#include "motion_test_support.hpp"
#include "polar_program.hpp"

namespace kerf {
namespace {

using motion_test::at;
using motion_test::machine_with;
using motion_test::Path;

/// Every kind of action; ends where it began.
Path one_round() {
  return Path()
      .rapid(at({{Axis::X, 5.0}}))
      .action(Spindle{SpindleDirection::clockwise, 5000.0, 0.01})
      .line(at({{Axis::X, 5.0}, {Axis::Z, -1.0}}), 600.0)
      .arc(0.0, 0.0, 360.0, 1200.0, at({{Axis::Z, -1.0}}))
      .rotary_line(at({{Axis::X, 5.0}, {Axis::Z, -2.0}, {Axis::A, 20.0}}), 600.0,
                   {true, false, Axis::A, 10.0})
      .line(at({{Axis::X, 5.0}, {Axis::Z, -2.0}, {Axis::A, 20.0}}), 600.0)
      .action(Dwell{0.01})
      .action(ToolChange{2, 0.01})
      .action(Auxiliary{8})
      .action(Stop{})
      .rapid({});
}

TEST(MotionAlloc, TheCounterCounts) {
  const std::uint64_t before = allocation_count;
  ::operator delete(::operator new(8));
  EXPECT_EQ(allocation_count, before + 1);
}

TEST(MotionAlloc, TrajectoryAllocatesNothing) {
  Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z, Axis::A});
  machine.motion.look_ahead = 32;
  const Path path = one_round();
  Trajectory trajectory(machine, FeedPolicy{});
  ServoModel servo(machine.motion, machine.cycle_s, {});
  SpeedChart chart(64, machine.cycle_s);
  Cycle cycle;
  std::uint64_t blocks = 0;
  std::uint64_t cycles = 0;
  const std::uint64_t before = allocation_count;
  for (std::size_t next = 0; next < 100 * path.actions().size();) {
    while (trajectory.wants_action()) trajectory.push(path.actions()[next++ % path.actions().size()]);
    trajectory.step(cycle, [&](const BlockTiming&) { ++blocks; });
    servo.step(cycle.position);
    chart.add({cycle.time_s, cycle.path_speed_mm_min, 1});
    if (++cycles % 500 == 0) trajectory.set_feed_override(static_cast<double>(50 + cycles % 100));
  }
  trajectory.finish();
  while (trajectory.step(cycle) == StepResult::cycle) {
  }
  EXPECT_EQ(allocation_count, before);
  EXPECT_GT(blocks, 1000U);
  EXPECT_GT(cycles, 10000U);
}

TEST(MotionAlloc, PolarMovesAllocateNothing) {
  polar_test::PolarProgram program(20.0);
  program.to(20.0, 20.0).to(-20.0, 0.5).arc(0.0, 0.0, -90.0).arc(0.0, 0.0, 90.0).to(20.0, 20.0).to(20.0, 0.0);
  const std::vector<Action>& flat = program.actions();
  Machine machine = machine_with({Axis::X, Axis::Z, Axis::C});
  machine.motion.look_ahead = 32;
  Trajectory trajectory(machine, FeedPolicy{});
  PolarPolicy policy;
  policy.rotary = Axis::C;
  PolarPass pass(policy);
  toolpath_test::ListSource source(flat);
  Cycle cycle;
  std::uint64_t blocks = 0;
  const std::uint64_t before = allocation_count;
  for (int rounds = 0; rounds < 10;) {
    while (rounds < 10 && trajectory.wants_action()) {
      const Action* action = pass.next(source);
      if (action == nullptr) {
        source = toolpath_test::ListSource(flat);
        ++rounds;
      } else {
        trajectory.push(*action);
      }
    }
    trajectory.step(cycle, [&](const BlockTiming&) { ++blocks; });
  }
  trajectory.finish();
  while (trajectory.step(cycle, [&](const BlockTiming&) { ++blocks; }) == StepResult::cycle) {
  }
  EXPECT_EQ(allocation_count, before);
  EXPECT_EQ(blocks, 60U);
}

TEST(MotionAlloc, ARunAllocatesTheSameForManyBlocksAsForFew) {
  Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z, Axis::A});
  machine.motion.look_ahead = 32;
  const Path path = one_round();
  const auto allocations_of = [&](std::size_t rounds) {
    std::size_t next = 0;
    const std::uint64_t before = allocation_count;
    run(
        [&]() -> const Action* {
          return next < rounds * path.actions().size() ? &path.actions()[next++ % path.actions().size()]
                                                       : nullptr;
        },
        machine, FeedPolicy{});
    return allocation_count - before;
  };
  const std::uint64_t few = allocations_of(1);
  EXPECT_GT(few, 0U);
  EXPECT_EQ(allocations_of(50), few);
}

}  // namespace
}  // namespace kerf
