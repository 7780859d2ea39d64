// The pass that makes moves of the axes: legs of rapid moves, and axes that follow another one.

#include <gtest/gtest.h>

#include "motion/run.hpp"
#include "motion_test_support.hpp"
#include "toolpath/axis_motion.hpp"
#include "toolpath_program.hpp"

namespace kerf {
namespace {

using motion_test::at;
using toolpath_test::ListSource;

Machine three_axes() {
  return motion_test::machine_with({Axis::X, Axis::Y, Axis::Z}, 500.0);
}

Action rapid(const AxisVector& end, bool each_axis) {
  Move move;
  move.each_axis = each_axis;
  move.end = end;
  return {{}, move};
}

std::vector<Move> moves_of(const Machine& machine, const std::vector<Action>& actions) {
  AxisMotionPass pass(machine);
  ListSource source(actions);
  std::vector<Move> moves;
  while (const Action* action = pass.next(source)) moves.push_back(std::get<Move>(action->what));
  return moves;
}

TEST(AxisMotion, WhatNeedsNothingIsHandedThroughWithoutACopy) {
  const std::vector<Action> actions{rapid(at({{Axis::X, 1.0}}), false), {{}, Dwell{1.0}}};
  AxisMotionPass pass(three_axes());
  ListSource source(actions);
  for (const Action& action : actions) EXPECT_EQ(pass.next(source), &action);
  EXPECT_EQ(pass.next(source), nullptr);
}

TEST(AxisMotion, ALegEndsWhereAnAxisArrives) {
  Machine machine = three_axes();
  machine.axis[index(Axis::Y)].rapid = 6000.0;
  // X 12000, Y 6000, Z 12000 mm/min: X needs 1/120, Y 1/60, Z 1/480 of a minute.
  Action action = rapid(at({{Axis::X, 100.0}, {Axis::Y, -100.0}, {Axis::Z, 25.0}}), true);
  std::get<Move>(action.what).exact_stop = true;
  std::get<Move>(action.what).from_rest = true;
  const auto legs = moves_of(machine, {action});
  ASSERT_EQ(legs.size(), 3U);
  EXPECT_EQ(legs[0].end, at({{Axis::X, 25.0}, {Axis::Y, -12.5}, {Axis::Z, 25.0}}));
  EXPECT_EQ(legs[1].end, at({{Axis::X, 100.0}, {Axis::Y, -50.0}, {Axis::Z, 25.0}}));
  EXPECT_EQ(legs[2].end, at({{Axis::X, 100.0}, {Axis::Y, -100.0}, {Axis::Z, 25.0}}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(legs[i].last_axis, Axis::Y);
    EXPECT_EQ(legs[i].passes_on, i < 2);
    EXPECT_EQ(legs[i].exact_stop, i == 2);
    EXPECT_EQ(legs[i].from_rest, i == 0);
    if (i > 0) {
      EXPECT_EQ(legs[i].start, legs[i - 1].end);
    }
  }
}

TEST(AxisMotion, AxesThatArriveTogetherEndOneLeg) {
  EXPECT_EQ(moves_of(three_axes(), {rapid(at({{Axis::X, 10.0}, {Axis::Y, -10.0}}), true)}).size(), 1U);
}

/// X with U 7 mm beside it; along lines, a positioning axis by axis, and an arc.
struct Gantry {
  Machine machine = motion_test::machine_with({Axis::X, Axis::Y, Axis::U}, 500.0);
  std::vector<Action> actions;

  Gantry() {
    machine.axis[index(Axis::U)].master = Axis::X;
    machine.axis[index(Axis::U)].start = 7.0;
    machine.axis[index(Axis::U)].rapid = 1.0;
    machine.axis[index(Axis::U)].acceleration = 0.01;
    motion_test::Path path(at({{Axis::U, 7.0}}));
    path.line(at({{Axis::X, 20.0}, {Axis::Y, 5.0}, {Axis::U, 7.0}}), 1200.0);
    path.arc(20.0, 15.0, 270.0, 900.0);
    path.rapid(at({{Axis::X, -30.0}, {Axis::Y, 2.0}, {Axis::U, 7.0}}));
    actions = path.actions();
    std::get<Move>(actions.back().what).each_axis = true;
  }

  RunRecord play(RunOptions options) const {
    AxisMotionPass pass(machine);
    ListSource source(actions);
    return run([&] { return pass.next(source); }, machine, FeedPolicy{}, options);
  }
};

TEST(AxisMotion, AFollowerIsBesideItsMasterInEveryCycle) {
  std::uint64_t cycles = 0;
  RunOptions options;
  options.on_cycle = [&](const Cycle& cycle, const AxisVector& actual) {
    ++cycles;
    ASSERT_NEAR(cycle.position[Axis::U], cycle.position[Axis::X] + 7.0, 1e-9);
    ASSERT_EQ(cycle.velocity[Axis::U], cycle.velocity[Axis::X]);
    ASSERT_NEAR(actual[Axis::U], actual[Axis::X] + 7.0, 1e-6);
  };
  const RunRecord record = Gantry().play(options);
  EXPECT_GT(cycles, 1000U);
  const auto& bounds = record.summary.bounds;
  // The arc about (20, 15) from below by 270 degrees: X from 10 to 30; then back to -30.
  EXPECT_NEAR(bounds[index(Axis::X)].high, 30.0, 1e-6);
  EXPECT_NEAR(bounds[index(Axis::U)].high, 37.0, 1e-6);
  EXPECT_NEAR(bounds[index(Axis::U)].low, -23.0, 1e-6);
  EXPECT_EQ(record.summary.peak[index(Axis::U)].velocity, record.summary.peak[index(Axis::X)].velocity);
}

TEST(AxisMotion, ItsOwnLimitsSlowNothingDown) {
  Gantry alone;
  alone.machine.axis[index(Axis::U)].master.reset();
  alone.machine.axes.erase(Axis::U);
  EXPECT_NEAR(Gantry().play({}).summary.time_s, alone.play({}).summary.time_s, 1e-9);
}

TEST(AxisMotion, TheAxisThatArrivesLastIsNotSlowedDown) {
  const Machine machine = three_axes();
  const auto time_of = [&](const Action& action) {
    AxisMotionPass pass(machine);
    const std::vector<Action> actions{action};
    ListSource source(actions);
    return run([&] { return pass.next(source); }, machine, FeedPolicy{}).summary.time_s;
  };
  // 100 mm at 200 mm/s would need 80 mm to get there and back: 0.4 s up, 0.1 s, 0.4 s down.
  EXPECT_NEAR(time_of(rapid(at({{Axis::X, 100.0}, {Axis::Y, 30.0}, {Axis::Z, 99.0}}), true)), 0.9, 1e-9);
}

}  // namespace
}  // namespace kerf
