// Moves of a polar plane, judged by the positions of the axes at every cycle: the path on the work is the
// line or arc of the program, and both axes stay within their limits.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "execute/polar_plane.hpp"
#include "geometry/polar.hpp"
#include "motion_test_support.hpp"
#include "polar_program.hpp"

namespace kerf {
namespace {

using motion_test::machine_with;
using motion_test::play;
using motion_test::Random;
using motion_test::Samples;
using polar_test::passed;
using polar_test::PolarProgram;

constexpr double kRounding = 2e-2;  // mm/s2 and degrees/s2: of second differences over a cycle of 1 ms

Machine polar_machine() {
  Machine machine = machine_with({Axis::X, Axis::Z, Axis::C});
  const auto set = [&](Axis axis, double rapid, double feed, double acceleration) {
    machine.axis[index(axis)].rapid = rapid;
    machine.axis[index(axis)].max_feed = feed;
    machine.axis[index(axis)].acceleration = acceleration;
  };
  set(Axis::X, 12000.0, 6000.0, 900.0);
  set(Axis::Z, 4000.0, 2000.0, 300.0);
  set(Axis::C, 36000.0, 18000.0, 3000.0);
  return machine;
}

/// Lines and arcs between 0.01 and 60 mm from the centre, some of which come near it or run through it.
PolarProgram random_program(unsigned seed, int moves) {
  Random random(seed);
  const bool minus = random.chance(0.5);
  PolarProgram program(minus ? -20.0 : 20.0, random.uniform(-50.0, 50.0), random.uniform(-180.0, 180.0));
  for (int i = 0; i < moves; ++i) {
    program.feed(random.magnitude(300.0, 8000.0));
    const Vec2 here = program.here();
    const double size = random.magnitude(0.02, 30.0);
    const Vec2 end =
        length(here) > 40.0 ? 0.5 * here : here + size * direction_at(random.uniform(-180.0, 180.0));
    if (random.chance(0.05)) {
      program.to(-0.5 * here.x, -0.5 * here.y);
    } else if (random.chance(0.4)) {
      const Vec2 center = random.chance(0.3) ? Vec2{} : end;
      program.arc(center.x, center.y, random.uniform(5.0, 400.0) * (random.chance(0.5) ? 1.0 : -1.0));
    } else if (random.chance(0.1)) {
      program.rapid(end.x, end.y);
    } else {
      program.to(end.x, end.y, random.chance(0.2) ? random.uniform(-20.0, 20.0) : 0.0);
    }
  }
  return program;
}

/// Where the axes put the tool on the work.
Vec2 on_the_work(const PolarPlane& polar, const AxisVector& position) {
  return (position[polar.linear] - polar.center) * direction_at(position[polar.rotary] - polar.zero);
}

double distance_to_line(Vec2 point, Vec2 start, Vec2 end) {
  const Vec2 way = end - start;
  const double square = dot(way, way);
  const double part = square > 0.0 ? std::clamp(dot(point - start, way) / square, 0.0, 1.0) : 0.0;
  return distance(point, start + part * way);
}

void expect_on_the_programmed_path(const Samples& samples, const std::vector<Action>& program) {
  std::uint32_t last_block = 0;
  for (const Cycle& cycle : samples.cycles) {
    ASSERT_GE(cycle.origin.block, last_block);
    last_block = cycle.origin.block;
    const Move& move = std::get<Move>(program[cycle.origin.block - 1].what);
    const double x = move.polar.center;
    const Vec2 point = on_the_work(move.polar, cycle.position);
    const Vec2 start{move.start[Axis::X] - x, move.start[Axis::C]};
    const Vec2 end{move.end[Axis::X] - x, move.end[Axis::C]};
    if (!is_arc(move.mode)) {
      ASSERT_LT(distance_to_line(point, start, end), 1e-6) << "block " << cycle.origin.block;
      continue;
    }
    const Vec2 center{move.arc.center[0] - x, move.arc.center[1]};
    ASSERT_NEAR(distance(point, center), move.arc.radius, 1e-6) << "block " << cycle.origin.block;
    if (std::abs(move.arc.sweep) >= 359.0) continue;
    const double ahead = ahead_deg(start - center, point - center, move.arc.sweep < 0.0);
    const double turned = std::abs(ahead < -1e-3 ? ahead + 360.0 : ahead);
    ASSERT_LE(turned, std::abs(move.arc.sweep) + 1e-3) << "block " << cycle.origin.block;
  }
}

void expect_within_limits(const Samples& samples, const Machine& machine, const std::vector<Action>& program,
                          const AxisVector& start) {
  AxisVector last = start;
  std::size_t judged = 0;
  for (std::size_t i = 0; i < samples.cycles.size(); ++i) {
    const Cycle& now = samples.cycles[i];
    const bool rapid = std::get<Move>(program[now.origin.block - 1].what).mode == MoveMode::rapid;
    const bool same = i > 0 && samples.cycles[i - 1].origin.block == now.origin.block;
    for (const Axis axis : machine.axes) {
      const double rate = rapid || !same ? machine[axis].rapid : machine[axis].max_feed;
      ASSERT_LE(std::abs(now.position[axis] - last[axis]),
                rate / 60.0 * machine.cycle_s * (1.0 + 1e-9) + 1e-9)
          << letter(axis) << " at " << now.time_s << " in block " << now.origin.block;
    }
    last = now.position;
    if (i < 2 || samples.cycles[i - 2].origin.block != now.origin.block) continue;
    ++judged;
    for (const Axis axis : machine.axes) {
      const double second = samples.cycles[i - 2].position[axis] -
                            2.0 * samples.cycles[i - 1].position[axis] + now.position[axis];
      ASSERT_LE(std::abs(second) / (machine.cycle_s * machine.cycle_s),
                machine[axis].acceleration * (1.0 + 1e-3) + kRounding)
          << letter(axis) << " at " << now.time_s << " in block " << now.origin.block;
    }
  }
  EXPECT_GT(judged, samples.cycles.size() / 10);
}

AxisVector first_position(const std::vector<Action>& actions) {
  return std::get<Move>(actions.front().what).start;
}

TEST(MotionPolar, RandomContoursAreTrueToTheirPathAtEveryCycle) {
  const Machine machine = polar_machine();
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const PolarProgram program = random_program(seed, 60);
    const auto actions = passed(program.actions());
    const Samples samples = play(machine, actions);
    expect_on_the_programmed_path(samples, program.actions());
    expect_within_limits(samples, machine, program.actions(), first_position(actions));
    ASSERT_EQ(samples.blocks.size(), actions.size());
    for (const Axis axis : machine.axes) {
      EXPECT_EQ(samples.cycles.back().position[axis], std::get<Move>(actions.back().what).end[axis]);
      EXPECT_LE(samples.extremes.acceleration[axis], machine[axis].acceleration * (1.0 + 1e-7));
    }
  }
}

TEST(MotionPolar, FarFromTheCentreTheToolKeepsTheFeed) {
  // A square of 60 mm at F1200: 240 mm of way at 20 mm/s and four corners.
  PolarProgram program(30.0);
  program.feed(1200.0).to(30.0, 30.0).to(-30.0, 30.0).to(-30.0, -30.0).to(30.0, -30.0).to(30.0, 0.0);
  const Machine machine = motion_test::ideal_machine({Axis::X, Axis::Z, Axis::C});
  const Samples samples = play(machine, passed(program.actions()));
  EXPECT_NEAR(samples.time_s, 240.0 / 20.0, 1e-6);
  ASSERT_EQ(samples.blocks.size(), 5U);
  EXPECT_NEAR(samples.blocks[1].length_mm, 60.0, 1e-9);
  EXPECT_NEAR(samples.blocks[1].duration_s, 3.0, 1e-6);
  for (const Cycle& cycle : samples.cycles) {
    ASSERT_LE(cycle.path_speed_mm_min, 1200.0 + 1e-6);
  }
}

TEST(MotionPolar, NearTheCentreTheRotaryAxisSetsThePace) {
  // Past the centre at 0.5 mm. C turns at most 100 mm/s = 100 degrees/s: at the nearest point the tool does
  // no more than radians(100) x 0.5 = 0.87 mm/s, at 20 mm it does the feed of 20 mm/s.
  Machine machine = motion_test::ideal_machine({Axis::X, Axis::Z, Axis::C});
  PolarProgram program(20.0);
  program.feed(1200.0).to(20.0, 0.5).to(-20.0, 0.5);
  const Samples samples = play(machine, passed(program.actions()));
  double fastest = 0.0;
  double most_turned = 0.0;
  double at_nearest = 1e9;
  for (std::size_t i = 1; i < samples.cycles.size(); ++i) {
    const double turned =
        std::abs(samples.cycles[i].position[Axis::C] - samples.cycles[i - 1].position[Axis::C]);
    most_turned = std::max(most_turned, turned / machine.cycle_s);
    fastest = std::max(fastest, samples.cycles[i].path_speed_mm_min);
    if (samples.cycles[i].position[Axis::X] < 0.501)
      at_nearest = std::min(at_nearest, samples.cycles[i].path_speed_mm_min);
  }
  EXPECT_LE(most_turned, 100.0 * (1.0 + 1e-6));
  EXPECT_GE(most_turned, 95.0);
  EXPECT_NEAR(fastest, 1200.0, 1e-6);
  const double bound = 60.0 * std::numbers::pi / 180.0 * 100.0 * 0.5;
  EXPECT_LE(at_nearest, bound * (1.0 + 1e-3));
  EXPECT_GE(at_nearest, bound / 1.35);
  // With the rate free at every point it takes the integral of rate over path; pieces cost at most their
  // spread.
  double ideal = 0.0;
  constexpr int kSteps = 40000;
  for (int i = 0; i < kSteps; ++i) {
    const double x = 20.0 - 40.0 * (i + 0.5) / kSteps;
    const double turn = 0.5 / (x * x + 0.25);  // rad/mm
    ideal += 40.0 / kSteps / std::min(20.0, radians(100.0) / turn);
  }
  const double taken = samples.blocks.back().duration_s;
  EXPECT_GE(taken, ideal * (1.0 - 1e-3));
  EXPECT_LE(taken, ideal * 1.3);
}

TEST(MotionPolar, AnArcAwayFromTheCentreComesBackToTheFeed) {
  // A circle of radius 20 about (0, 20) that passes the centre of rotation at 0.00001 mm, from beside it. C
  // turns at most 300 degrees/s.
  const Machine machine = polar_machine();
  PolarProgram program(0.02);
  program.feed(1200.0).arc(0.0, 20.0, 80.0);
  const Samples samples = play(machine, passed(program.actions()));
  double ideal = 0.0;
  constexpr int kSteps = 400'000;
  const auto point_at = [](double part) {
    return Vec2{0.0, 20.0} +
           std::hypot(20.0, 0.02) * direction_at(-90.0 + degrees(0.02 / 20.0) + 80.0 * part);
  };
  for (int i = 0; i < kSteps; ++i) {
    const Vec2 from = point_at(static_cast<double>(i) / kSteps);
    const Vec2 to = point_at(static_cast<double>(i + 1) / kSteps);
    const double turned = std::abs(shortest_turn_deg(angle_of_deg(to) - angle_of_deg(from)));
    ideal += std::max(distance(from, to) / 20.0, turned / 300.0);
  }
  EXPECT_GE(samples.time_s, ideal * (1.0 - 1e-3));
  EXPECT_LE(samples.time_s, ideal * 1.3 + 0.5);
  EXPECT_NEAR(samples.cycles[samples.cycles.size() / 2].path_speed_mm_min, 1200.0, 1e-3);
}

TEST(MotionPolar, InTheCentreAHeightMoveTurnsNothing) {
  for (const double x : {20.0, -20.0}) {
    PolarProgram program(x, 5.0, 30.0);
    program.to(0.0, 0.0).to(0.0, 0.0, -5.0).to(0.0, 0.0, 0.0).to(x, 0.0, 0.0);
    const Samples samples = play(polar_machine(), passed(program.actions()));
    ASSERT_GT(samples.cycles.size(), 100U);
    for (const Cycle& cycle : samples.cycles)
      ASSERT_NEAR(cycle.position[Axis::C], 30.0, 1e-9) << cycle.time_s;
  }
}

TEST(MotionPolar, TheTurnInTheCentreIsAsFastAsTheAxisCan) {
  // Half a turn at 100 degrees/s, not at 10 degrees/min; 40 mm at 10 mm/min.
  Machine machine = motion_test::ideal_machine({Axis::X, Axis::Z, Axis::C});
  machine.motion.feed_of_all_axes = true;
  PolarProgram program(20.0);
  program.feed(10.0).to(-20.0, 0.0);
  const Samples samples = play(machine, passed(program.actions()));
  EXPECT_NEAR(samples.time_s, 180.0 / 100.0 + 40.0 / 10.0 * 60.0, 1e-3);
}

TEST(MotionPolar, AnArcThatEndsInTheCentreBringsTheAxisToItsEnd) {
  // A circle of radius 10 about (10, 0), half around to the centre of rotation: C turns by 90 degrees,
  // evenly, and away from there along the tangent, which is no turn.
  const Machine machine = polar_machine();
  PolarProgram program(20.0);
  program.feed(1200.0).arc(10.0, 0.0, 180.0).arc(10.0, 0.0, 90.0);
  const auto actions = passed(program.actions());
  const Samples samples = play(machine, actions);
  double last = 0.0;
  for (const Cycle& cycle : samples.cycles) {
    const double rate = machine[Axis::C].rapid / 60.0;
    ASSERT_LE(std::abs(cycle.position[Axis::C] - last), rate * machine.cycle_s * (1.0 + 1e-6))
        << cycle.time_s;
    last = cycle.position[Axis::C];
  }
  EXPECT_NEAR(std::get<Move>(actions[0].what).end[Axis::C], 90.0, 1e-9);
}

TEST(MotionPolar, PiecesOfAMoveRunIntoEachOther) {
  // Radially the same: 40 mm past the centre, with accelerations. It never stands within the move.
  const Machine machine = polar_machine();
  PolarProgram program(20.0);
  program.feed(1200.0).to(20.0, 1.0).to(-20.0, 1.0);
  const Samples samples = play(machine, passed(program.actions()));
  ASSERT_EQ(samples.blocks.size(), 2U);
  double slowest = 1e9;
  for (const Cycle& cycle : samples.cycles) {
    const bool inside = cycle.origin.block == 2 && cycle.time_s > samples.blocks[1].start_s + 0.05 &&
                        cycle.time_s < samples.time_s - 0.05;
    if (inside) slowest = std::min(slowest, cycle.path_speed_mm_min);
  }
  EXPECT_GT(slowest, 60.0);
  EXPECT_NEAR(samples.blocks[0].duration_s + samples.blocks[1].duration_s, samples.time_s, 1e-9);
  EXPECT_NEAR(samples.blocks[1].length_mm, 40.0, 1e-9);
}

TEST(MotionPolar, AFeedOverrideChangesTheTimeOnly) {
  const Machine machine = polar_machine();
  const PolarProgram program = random_program(77, 20);
  const auto actions = passed(program.actions());
  const Samples samples = play(machine, actions, {}, [](Trajectory& trajectory, std::size_t cycles) {
    if (cycles % 300 == 0) trajectory.set_feed_override(static_cast<double>(20 + cycles % 90));
  });
  expect_on_the_programmed_path(samples, program.actions());
  expect_within_limits(samples, machine, program.actions(), first_position(actions));
}

}  // namespace
}  // namespace kerf
