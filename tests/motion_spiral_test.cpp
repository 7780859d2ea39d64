// Arcs whose radius goes evenly from start to end: the tool keeps to the spiral, the feed is that along it,
// and the axes stay within their limits.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "geometry/spiral.hpp"
#include "geometry/vec2.hpp"
#include "motion_test_support.hpp"

namespace kerf {
namespace {

using motion_test::play;
using motion_test::Random;
using motion_test::Samples;

struct SpiralMove {
  double start_radius = 0.0;
  double end_radius = 0.0;
  double sweep_deg = 0.0;
  double rise = 0.0;
  double feed = 0.0;
};

SpiralMove random_spiral(Random& random) {
  return {random.uniform(1.0, 80.0), random.uniform(1.0, 80.0),
          random.uniform(20.0, 360.0) * (random.chance(0.5) ? 1.0 : -1.0),
          random.chance(0.5) ? random.uniform(-9.0, 9.0) : 0.0, random.magnitude(100.0, 8000.0)};
}

/// About (3, -4), from the direction 30 degrees.
std::vector<Action> actions_of(const SpiralMove& spiral) {
  const Vec2 center{3.0, -4.0};
  const Vec2 start = center + spiral.start_radius * direction_at(30.0);
  const Vec2 end = center + spiral.end_radius * direction_at(30.0 + spiral.sweep_deg);
  Move move;
  move.mode = spiral.sweep_deg < 0.0 ? MoveMode::clockwise : MoveMode::counterclockwise;
  move.start[Axis::X] = start.x;
  move.start[Axis::Y] = start.y;
  move.end[Axis::X] = end.x;
  move.end[Axis::Y] = end.y;
  move.end[Axis::Z] = spiral.rise;
  move.feed = spiral.feed;
  move.arc = {{center.x, center.y}, spiral.start_radius, spiral.sweep_deg};
  Action action;
  action.origin.block = 1;
  action.what = move;
  return {action};
}

double way_of(const SpiralMove& spiral) {
  return way_of_arc(spiral.start_radius, spiral.end_radius, radians(std::abs(spiral.sweep_deg)));
}

TEST(MotionSpiral, TheFeedIsThatOfTheWay) {
  Random random(5);
  for (int i = 0; i < 30; ++i) {
    SpiralMove spiral = random_spiral(random);
    spiral.rise = 0.0;
    spiral.feed = std::min(spiral.feed, 5000.0);
    const Samples samples = play(motion_test::ideal_machine({Axis::X, Axis::Y, Axis::Z}), actions_of(spiral));
    const double time = way_of(spiral) / spiral.feed * 60.0;
    EXPECT_NEAR(samples.time_s, time, 1e-6 + 1e-6 * time) << i;
    // As fast at every instant, not only in the mean.
    for (std::size_t at = 1; at + 1 < samples.cycles.size(); ++at) {
      const AxisVector& velocity = samples.cycles[at].velocity;
      ASSERT_NEAR(std::hypot(velocity[Axis::X], velocity[Axis::Y]), spiral.feed / 60.0, 1e-6 * spiral.feed)
          << i;
    }
  }
}

TEST(MotionSpiral, KeepsToItsPathAndTheLimits) {
  Random random(6);
  Machine machine = motion_test::machine_with({Axis::X, Axis::Y, Axis::Z});
  machine.axis[index(Axis::X)].acceleration = 700.0;
  machine.axis[index(Axis::Y)].acceleration = 900.0;
  machine.axis[index(Axis::X)].max_feed = 3000.0;
  for (int i = 0; i < 60; ++i) {
    const SpiralMove spiral = random_spiral(random);
    const Samples samples = play(machine, actions_of(spiral));
    ASSERT_FALSE(samples.cycles.empty());
    const double growth = (spiral.end_radius - spiral.start_radius) / std::abs(spiral.sweep_deg);
    for (std::size_t at = 0; at < samples.cycles.size(); ++at) {
      const Cycle& now = samples.cycles[at];
      const Vec2 arm{now.position[Axis::X] - 3.0, now.position[Axis::Y] + 4.0};
      double turned = (angle_of_deg(arm) - 30.0) * (spiral.sweep_deg < 0.0 ? -1.0 : 1.0);
      turned -= 360.0 * std::floor((turned + 1e-6) / 360.0);
      const double expected = spiral.start_radius + growth * turned;
      const bool at_end = at + 1 == samples.cycles.size();
      if (!at_end) {
        ASSERT_NEAR(length(arm), expected, 1e-8) << i << " cycle " << at;
      }
      for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        ASSERT_LE(std::abs(now.velocity[axis]), machine[axis].max_feed / 60.0 * (1.0 + 1e-9)) << i;
        if (at == 0 || at_end) continue;
        const double step = now.velocity[axis] - samples.cycles[at - 1].velocity[axis];
        ASSERT_LE(std::abs(step), machine[axis].acceleration * machine.cycle_s * (1.0 + 1e-6) + 1e-9)
            << i << " cycle " << at;
      }
    }
  }
}

}  // namespace
}  // namespace kerf
