// Random paths: what the axes really do, judged by differences of successive positions and not by the plan's
// own words.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "motion_test_support.hpp"

namespace kerf {
namespace {

using motion_test::at;
using motion_test::machine_with;
using motion_test::Path;
using motion_test::play;
using motion_test::Random;
using motion_test::Samples;

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-2;  // mm/s2: of differences of positions of some 100 mm over a cycle of 1 ms

Machine uneven_machine() {
  Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z, Axis::A});
  const auto set = [&](Axis axis, double rapid, double feed, double acceleration) {
    machine.axis[index(axis)].rapid = rapid;
    machine.axis[index(axis)].max_feed = feed;
    machine.axis[index(axis)].acceleration = acceleration;
  };
  set(Axis::X, 12000.0, 6000.0, 900.0);
  set(Axis::Y, 10000.0, 5000.0, 700.0);
  set(Axis::Z, 4000.0, 2000.0, 300.0);
  set(Axis::A, 7200.0, 3600.0, 1500.0);
  return machine;
}

void add_random_move(Path& path, Random& random) {
  const double feed = random.magnitude(300.0, 8000.0);
  const double size = random.magnitude(0.02, 30.0);
  const double heading = random.uniform(0.0, 2.0 * kPi);
  const AxisVector here = path.here();
  const double x = here[Axis::X];
  const double y = here[Axis::Y];
  AxisVector end = here;
  end[Axis::X] = x + size * std::cos(heading);
  end[Axis::Y] = y + size * std::sin(heading);
  const double kind = random.uniform(0.0, 10.0);
  if (kind < 3.0) {
    if (random.chance(0.5)) end[Axis::Z] += random.uniform(-size, size);
    if (random.chance(0.2)) end[Axis::A] += random.uniform(-90.0, 90.0);
    path.line(end, feed);
  } else if (kind < 6.0) {
    const double sweep = random.uniform(5.0, 400.0) * (random.chance(0.5) ? 1.0 : -1.0);
    AxisVector others;
    if (random.chance(0.4)) others[Axis::Z] = random.uniform(-5.0, 5.0);
    if (random.chance(0.1)) others[Axis::A] = random.uniform(-50.0, 50.0);
    path.arc(x + size * std::cos(heading), y + size * std::sin(heading), sweep, feed, others);
  } else if (kind < 7.0) {
    AxisVector turned = here;
    turned[Axis::A] += random.uniform(-180.0, 180.0);
    if (random.chance(0.5)) turned[Axis::X] += size;
    path.rotary_line(turned, feed, {true, random.chance(0.1), Axis::A, random.uniform(0.0, 10.0)});
  } else if (kind < 8.0) {
    end[Axis::Z] = random.uniform(-20.0, 20.0);
    path.rapid(end);
  } else if (kind < 8.5) {
    path.line(here, feed);
  } else if (kind < 9.0) {
    path.action(Dwell{random.uniform(0.0, 0.01)});
  } else {
    const double short_chord = random.magnitude(1e-6, 0.01);
    for (int i = 0; i < 10; ++i) {
      end = path.here();
      end[Axis::X] += short_chord * std::cos(heading + 0.05 * i);
      end[Axis::Y] += short_chord * std::sin(heading + 0.05 * i);
      path.line(end, feed);
    }
  }
}

Path random_path(unsigned seed, int moves) {
  Random random(seed);
  Path path;
  for (int i = 0; i < moves; ++i) add_random_move(path, random);
  return path;
}

AxisVector start_position() {
  return {};
}

/// No axis exceeds the faster of its rates over any cycle, so positions are continuous; where it stands in a
/// cutting block all through, it keeps to the cutting rate.
void expect_velocities_within_limits(const Samples& samples, const Machine& machine, const Path& path) {
  AxisVector last = start_position();
  std::uint32_t last_block = 0;
  for (const Cycle& cycle : samples.cycles) {
    const auto* move = std::get_if<Move>(&path.actions()[cycle.origin.block - 1].what);
    const bool cutting = cycle.origin.block == last_block && move != nullptr && move->mode != MoveMode::rapid;
    for (const Axis axis : machine.axes) {
      const double rate =
          cutting ? machine[axis].max_feed : std::max(machine[axis].rapid, machine[axis].max_feed);
      const double way = std::abs(cycle.position[axis] - last[axis]);
      ASSERT_LE(way, rate / 60.0 * machine.cycle_s * (1.0 + 1e-9) + 1e-9)
          << letter(axis) << " at " << cycle.time_s << " in block " << cycle.origin.block;
    }
    last = cycle.position;
    last_block = cycle.origin.block;
  }
}

/// Second differences of positions. Over a border between blocks the velocity may step, so only triples
/// inside one block count, unless the path is smooth.
void expect_accelerations_within_limits(const Samples& samples, const Machine& machine, bool smooth) {
  std::size_t judged = 0;
  for (std::size_t i = 2; i < samples.cycles.size(); ++i) {
    const Cycle& a = samples.cycles[i - 2];
    const Cycle& b = samples.cycles[i - 1];
    const Cycle& c = samples.cycles[i];
    if (!smooth && (a.origin.block != c.origin.block)) continue;
    ++judged;
    for (const Axis axis : machine.axes) {
      const double difference = a.position[axis] - 2.0 * b.position[axis] + c.position[axis];
      const double acceleration = std::abs(difference) / (machine.cycle_s * machine.cycle_s);
      ASSERT_LE(acceleration, machine[axis].acceleration * (1.0 + 1e-6) + kRounding)
          << letter(axis) << " at " << c.time_s << " in block " << c.origin.block;
    }
  }
  EXPECT_GT(judged, samples.cycles.size() / 10);
}

/// Reported velocities are the derivative of the positions, to the order of the cycle.
void expect_velocities_agree_with_positions(const Samples& samples, const Machine& machine) {
  for (std::size_t i = 2; i < samples.cycles.size(); ++i) {
    const Cycle& a = samples.cycles[i - 2];
    const Cycle& b = samples.cycles[i - 1];
    const Cycle& c = samples.cycles[i];
    if (a.origin.block != c.origin.block) continue;
    for (const Axis axis : machine.axes) {
      const double central = (c.position[axis] - a.position[axis]) / (2.0 * machine.cycle_s);
      ASSERT_NEAR(b.velocity[axis], central, machine[axis].acceleration * machine.cycle_s * 1.01 + 1e-6);
    }
  }
}

double angle_between(double from, double to, double sweep) {
  double angle = to - from;
  while (sweep > 0.0 && angle < -1e-6) angle += 2.0 * kPi;
  while (sweep < 0.0 && angle > 1e-6) angle -= 2.0 * kPi;
  return angle;
}

void expect_on_line(const Move& move, const AxisVector& position, const Machine& machine) {
  double along = 0.0;
  double squared = 0.0;
  for (const Axis axis : machine.axes) {
    const double step = move.end[axis] - move.start[axis];
    along += step * (position[axis] - move.start[axis]);
    squared += step * step;
  }
  if (squared == 0.0) return;
  const double fraction = along / squared;
  ASSERT_GE(fraction, -1e-9);
  ASSERT_LE(fraction, 1.0 + 1e-9);
  for (const Axis axis : machine.axes) {
    ASSERT_NEAR(position[axis], move.start[axis] + fraction * (move.end[axis] - move.start[axis]), 1e-9);
  }
}

void expect_on_arc(const Move& move, const AxisVector& position) {
  const double x = position[Axis::X] - move.arc.center[0];
  const double y = position[Axis::Y] - move.arc.center[1];
  ASSERT_NEAR(std::hypot(x, y), move.arc.radius, 1e-9);
  // The angle runs evenly with the third axis.
  const double rise = move.end[Axis::Z] - move.start[Axis::Z];
  if (std::abs(rise) < 1e-3 || std::abs(move.arc.sweep) > 359.0) return;
  const double fraction = (position[Axis::Z] - move.start[Axis::Z]) / rise;
  const double start =
      std::atan2(move.start[Axis::Y] - move.arc.center[1], move.start[Axis::X] - move.arc.center[0]);
  const double angle = angle_between(start, std::atan2(y, x), move.arc.sweep);
  ASSERT_NEAR(angle, fraction * move.arc.sweep * kPi / 180.0, 1e-6 + 1e-9 / move.arc.radius);
}

void expect_on_path(const Samples& samples, const Machine& machine, const Path& path) {
  std::uint32_t last_block = 0;
  for (const Cycle& cycle : samples.cycles) {
    ASSERT_GE(cycle.origin.block, last_block);
    last_block = cycle.origin.block;
    const auto* move = std::get_if<Move>(&path.actions()[cycle.origin.block - 1].what);
    if (move == nullptr) continue;
    if (is_arc(move->mode)) {
      ASSERT_NO_FATAL_FAILURE(expect_on_arc(*move, cycle.position)) << "block " << cycle.origin.block;
    } else {
      ASSERT_NO_FATAL_FAILURE(expect_on_line(*move, cycle.position, machine))
          << "block " << cycle.origin.block;
    }
  }
}

/// Distance over the highest feed that counts for the block, plus waiting times.
double shortest_time(const Path& path) {
  double total = 0.0;
  for (const Action& action : path.actions()) {
    if (const auto* dwell = std::get_if<Dwell>(&action.what)) total += dwell->seconds;
    const auto* move = std::get_if<Move>(&action.what);
    if (move == nullptr || move->mode == MoveMode::rapid || move->rotary_feed.active) continue;
    const AxisVector step = move->end - move->start;
    const double xyz = is_arc(move->mode) ? move->arc.radius * std::abs(move->arc.sweep) * kPi / 180.0
                                          : std::hypot(step[Axis::X], step[Axis::Y], step[Axis::Z]);
    total += xyz / (move->feed / 60.0);
  }
  return total;
}

void expect_ends_exactly(const Samples& samples, const Machine& machine, const Path& path) {
  ASSERT_FALSE(samples.cycles.empty());
  for (const Axis axis : machine.axes) EXPECT_EQ(samples.cycles.back().position[axis], path.here()[axis]);
  EXPECT_EQ(samples.cycles.back().velocity, AxisVector{});
  EXPECT_EQ(samples.blocks.size(), path.actions().size());
  double sum = 0.0;
  for (const BlockTiming& block : samples.blocks) {
    EXPECT_NEAR(block.start_s, sum, 1e-9);
    sum += block.duration_s;
  }
  EXPECT_NEAR(samples.time_s, sum, 1e-9);
  EXPECT_EQ(static_cast<double>(samples.cycles.size()), std::ceil(samples.time_s / machine.cycle_s - 1e-6));
  EXPECT_GE(samples.time_s, shortest_time(path) * (1.0 - 1e-9));
}

TEST(MotionLimits, RandomPathsKeepToPathAndLimits) {
  const Machine machine = uneven_machine();
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    const Path path = random_path(seed, 120);
    const Samples samples = play(machine, path.actions());
    expect_velocities_within_limits(samples, machine, path);
    expect_accelerations_within_limits(samples, machine, false);
    expect_velocities_agree_with_positions(samples, machine);
    expect_on_path(samples, machine, path);
    expect_ends_exactly(samples, machine, path);
    for (const Axis axis : machine.axes) {
      EXPECT_LE(samples.extremes.acceleration[axis], machine[axis].acceleration * (1.0 + 1e-9));
    }
  }
}

/// Lines and arcs that join tangentially: then the limits hold over the joints too.
TEST(MotionLimits, SmoothPathsKeepTheAccelerationEverywhere) {
  const Machine machine = machine_with({Axis::X, Axis::Y}, 800.0);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Path path;
    double heading = 0.3;
    for (int i = 0; i < 60; ++i) {
      const double feed = random.magnitude(300.0, 6000.0);
      const AxisVector here = path.here();
      if (random.chance(0.4)) {
        const double size = random.magnitude(0.05, 20.0);
        path.line(at({{Axis::X, here[Axis::X] + size * std::cos(heading)},
                      {Axis::Y, here[Axis::Y] + size * std::sin(heading)}}),
                  feed);
        continue;
      }
      const double radius = random.magnitude(0.2, 15.0);
      const double sweep = random.uniform(10.0, 200.0) * (random.chance(0.5) ? 1.0 : -1.0);
      const double left = heading + std::copysign(0.5 * kPi, sweep);
      path.arc(here[Axis::X] + radius * std::cos(left), here[Axis::Y] + radius * std::sin(left), sweep, feed);
      heading += sweep * kPi / 180.0;
    }
    const Samples samples = play(machine, path.actions());
    expect_accelerations_within_limits(samples, machine, true);
    expect_on_path(samples, machine, path);
    expect_ends_exactly(samples, machine, path);
    // It really runs through: stopping at every joint would take longer.
    double stopping = 0.0;
    for (const Action& action : path.actions()) stopping += play(machine, {action}).time_s;
    EXPECT_LT(samples.time_s, 0.97 * stopping);
  }
}

/// The speed in the cycles next to a corner is the junction speed, give or take one cycle of acceleration.
TEST(MotionLimits, CornersOfRandomPolylinesArePassedWithinTheJunctionSpeed) {
  const double acceleration = 600.0;
  const Machine machine = machine_with({Axis::X, Axis::Y}, acceleration);
  Random random(99);
  Path path;
  std::vector<double> headings;
  std::vector<double> lengths;
  for (int i = 0; i < 400; ++i) {
    headings.push_back(random.uniform(0.0, 2.0 * kPi));
    lengths.push_back(random.magnitude(1.0, 20.0));
    AxisVector end = path.here();
    end[Axis::X] += lengths.back() * std::cos(headings.back());
    end[Axis::Y] += lengths.back() * std::sin(headings.back());
    path.line(end, 4000.0);
  }
  const Samples samples = play(machine, path.actions());
  const double change = acceleration * std::sqrt(2.0) * machine.cycle_s;
  std::size_t corners = 0;
  for (std::size_t i = 1; i < samples.cycles.size(); ++i) {
    const std::uint32_t before = samples.cycles[i - 1].origin.block;
    const std::uint32_t after = samples.cycles[i].origin.block;
    if (after != before + 1) continue;
    ++corners;
    const double turn =
        std::acos(std::clamp(std::cos(headings[after - 1] - headings[before - 1]), -1.0, 1.0));
    const double sin_h = std::sin(0.5 * (kPi - turn));
    const double by_deviation = acceleration * machine.motion.junction_deviation * sin_h / (1.0 - sin_h);
    const double by_length = acceleration * 0.5 * (lengths[before - 1] + lengths[after - 1]) / turn;
    const double speed = std::sqrt(std::min(by_deviation, by_length));
    for (const Cycle& cycle : {samples.cycles[i - 1], samples.cycles[i]}) {
      ASSERT_LE(cycle.path_speed_mm_min / 60.0, speed + change + 1e-9) << "corner " << corners;
    }
  }
  EXPECT_EQ(corners, 399U);
}

/// Chords of a circle are driven no faster than the circle itself allows.
TEST(MotionLimits, FinePolylinesKeepTheCentripetalAccelerationOfTheirCurve) {
  const double acceleration = 500.0;
  const Machine machine = machine_with({Axis::X, Axis::Y}, acceleration);
  const double radius = 2.0;
  Path path(at({{Axis::X, radius}}));
  const int chords = 2000;
  for (int i = 1; i <= chords; ++i) {
    const double angle = 4.0 * kPi * i / chords;
    path.line(at({{Axis::X, radius * std::cos(angle)}, {Axis::Y, radius * std::sin(angle)}}), 6000.0);
  }
  const Samples samples = play(machine, path.actions());
  const double highest = std::sqrt(acceleration * radius);  // 31.6 mm/s, far below the feed
  double peak = 0.0;
  for (const BlockTiming& block : samples.blocks) peak = std::max(peak, block.peak_feed_mm_min / 60.0);
  EXPECT_LE(peak, highest * 1.01);
  EXPECT_GE(peak, highest * 0.99);
}

TEST(MotionLimits, TheWindowChangesTheTimeButNotThePath) {
  const Path path = random_path(4711, 80);
  double last_time = 1e9;
  AxisVector end;
  for (const int window : {1, 4, 7, 64, 1024, 5000}) {
    Machine machine = uneven_machine();
    machine.motion.look_ahead = window;
    const Samples samples = play(machine, path.actions());
    ASSERT_NO_FATAL_FAILURE(expect_accelerations_within_limits(samples, machine, false));
    expect_ends_exactly(samples, machine, path);
    end = samples.cycles.back().position;
    EXPECT_EQ(end, path.here());
    EXPECT_LE(samples.time_s, last_time * (1.0 + 1e-9)) << window;
    last_time = samples.time_s;
  }
}

TEST(MotionLimits, ASmallLookAheadIsSlowerOnShortSegmentsButSeesWhatItPromises) {
  Path path;
  for (int i = 1; i <= 1000; ++i) path.line(at({{Axis::X, 0.01 * i}}), 6000.0);
  Machine machine = machine_with({Axis::X});
  const double long_look = play(machine, path.actions()).time_s;
  machine.motion.look_ahead = 16;
  const double short_look = play(machine, path.actions()).time_s;
  // 10 mm from rest to rest at 500 mm/s2: the triangle of 70.7 mm/s.
  EXPECT_NEAR(long_look, 2.0 * std::sqrt(10.0 / 500.0), 1e-9);
  // Stopping within 24 segments of 0.01 mm, the most that is planned at once, allows sqrt(2 500 0.24) =
  // 15.5 mm/s; stopping within the 16 that are promised, 12.6 mm/s, reached and left in 2 x 12.6 / 500 s.
  EXPECT_GT(short_look, 10.0 / 15.5);
  EXPECT_LT(short_look, 10.0 / 12.6 + 0.026);
}

TEST(MotionLimits, TheStepOfVelocityAtACornerIsReported) {
  Path path;
  path.line(at({{Axis::X, 20.0}}), 3000.0).line(at({{Axis::X, 20.0}, {Axis::Y, 20.0}}), 3000.0);
  Machine machine = machine_with({Axis::X, Axis::Y});
  machine.motion.junction_deviation = 0.01;
  const Samples samples = play(machine, path.actions());
  // Half the angle between the legs is 45 degrees, both axes have 500 mm/s2:
  // v2 = 500 x 0.01 x 0.70711 / (1 - 0.70711). X loses this speed and Y gains it.
  const double speed = std::sqrt(500.0 * 0.01 * std::sqrt(0.5) / (1.0 - std::sqrt(0.5)));
  EXPECT_NEAR(samples.extremes.corner_step[Axis::X], speed, 1e-9);
  EXPECT_NEAR(samples.extremes.corner_step[Axis::Y], speed, 1e-9);
  EXPECT_LE(samples.extremes.acceleration[Axis::X], 500.0 * (1.0 + 1e-12));
}

TEST(MotionLimits, AStraightJointAndAStopHaveNoStepOfVelocity) {
  Path path;
  path.line(at({{Axis::X, 5.0}}), 3000.0).line(at({{Axis::X, 10.0}}), 1000.0).action(Dwell{0.1});
  path.line(at({{Axis::X, 10.0}, {Axis::Y, 5.0}}), 3000.0);
  const Samples samples = play(machine_with({Axis::X, Axis::Y}), path.actions());
  EXPECT_NEAR(samples.extremes.corner_step[Axis::X], 0.0, 1e-12);
  EXPECT_NEAR(samples.extremes.corner_step[Axis::Y], 0.0, 1e-12);
}

}  // namespace
}  // namespace kerf
