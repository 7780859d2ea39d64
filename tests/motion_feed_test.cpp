// How long moves take on a machine that accelerates at once: distance over feed as each kind of move measures
// it.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "motion_test_support.hpp"

namespace kerf {
namespace {

using motion_test::at;
using motion_test::ideal_machine;
using motion_test::Path;
using motion_test::play;

constexpr double kPi = std::numbers::pi;

Machine four_axes() {
  Machine machine = ideal_machine({Axis::X, Axis::Y, Axis::Z, Axis::A});
  machine.axis[index(Axis::A)].max_feed = 7200.0;  // 120 degree/s
  return machine;
}

double time_of(const Path& path) {
  return play(four_axes(), path.actions()).time_s;
}

RotaryFeed radius(double mm) {
  return {true, false, Axis::A, mm};
}

/// Relative tolerance of 1e-6.
void expect_time(const Path& path, double seconds) {
  EXPECT_NEAR(time_of(path), seconds, 1e-6 * seconds);
}

TEST(MotionFeed, LineIsMeasuredInXYZ) {
  expect_time(Path().line(at({{Axis::X, 10.0}, {Axis::Y, 20.0}, {Axis::Z, 20.0}}), 600.0), 3.0);
  expect_time(Path().line(at({{Axis::X, 30.0}, {Axis::A, 40.0}}), 600.0), 3.0);
}

TEST(MotionFeed, RotaryAxisAloneWithoutARadiusTurnsInDegreesAMinute) {
  expect_time(Path().line(at({{Axis::A, 90.0}}), 600.0), 9.0);
}

TEST(MotionFeed, CircleIsMeasuredAlongTheArc) {
  const Path quarter = Path(at({{Axis::X, 10.0}})).arc(0.0, 0.0, 90.0, 600.0);
  expect_time(quarter, 5.0 * kPi / 10.0);
  expect_time(Path(at({{Axis::X, 10.0}})).arc(0.0, 0.0, -720.0, 600.0), 40.0 * kPi / 10.0);
}

TEST(MotionFeed, HelixIsMeasuredAlongItsCircle) {  // DGS-219: 1.571 s, not 1.648 s
  expect_time(Path(at({{Axis::X, 10.0}})).arc(0.0, 0.0, 90.0, 600.0, at({{Axis::Z, 5.0}})), 5.0 * kPi / 10.0);
}

TEST(MotionFeed, RotaryFeedTurnsByThePeripheralSpeed) {  // DGS-081, 082, 566
  expect_time(Path().rotary_line(at({{Axis::A, 90.0}}), 600.0, radius(10.0)), kPi / 2.0);
  expect_time(Path().rotary_line(at({{Axis::A, 90.0}}), 600.0, radius(20.0)), kPi);
}

TEST(MotionFeed, RotaryFeedInInches) {  // DGS-565: radius 1 inch at 10 inch/min
  expect_time(Path().rotary_line(at({{Axis::A, 90.0}}), 254.0, radius(25.4)), 9.42477796);
}

TEST(MotionFeed, RotaryFeedWithXTakesTheLongerTime) {  // DGS-083
  // 90 degrees on radius 10 are 15.708 mm, more than 10 mm of X.
  expect_time(Path().rotary_line(at({{Axis::X, 10.0}, {Axis::A, 90.0}}), 600.0, radius(10.0)), kPi / 2.0);
  expect_time(Path().rotary_line(at({{Axis::X, 10.0}, {Axis::A, 90.0}}), 600.0, radius(5.0)), 1.0);
}

TEST(MotionFeed, RotaryFeedStaysConstantWhileZRises) {  // DGS-084, 567, 568
  const Path path =
      Path(at({{Axis::Z, 10.0}})).rotary_line(at({{Axis::Z, 20.0}, {Axis::A, 360.0}}), 600.0, radius(10.0));
  expect_time(path, 2.0 * kPi);
  const auto samples = play(four_axes(), path.actions());
  for (const Cycle& cycle : samples.cycles) {
    if (cycle.time_s > 2.0 * kPi) continue;  // the last one stands
    ASSERT_NEAR(cycle.velocity[Axis::A], 3437.746771 / 60.0, 1e-5);
    ASSERT_NEAR(cycle.velocity[Axis::Z], 95.492966 / 60.0, 1e-6);
  }
}

TEST(MotionFeed, RotaryFeedAtRadiusZeroOrAtTheTopTurnsAtTheAxisMaximum) {  // DGS-085, 569
  expect_time(Path().rotary_line(at({{Axis::A, 90.0}}), 600.0, radius(0.0)), 90.0 / 120.0);
  expect_time(Path().rotary_line(at({{Axis::A, 90.0}}), 1.0, {true, true, Axis::A, 10.0}), 90.0 / 120.0);
  // With X the block takes the longer of both.
  expect_time(Path().rotary_line(at({{Axis::X, 5.0}, {Axis::A, 90.0}}), 600.0, radius(0.0)), 90.0 / 120.0);
  expect_time(Path().rotary_line(at({{Axis::X, 20.0}, {Axis::A, 90.0}}), 600.0, radius(0.0)), 2.0);
}

TEST(MotionFeed, RotaryFeedIsLimitedByTheAxisMaximum) {
  // Radius 1 at F600 asks for 573 degree/s.
  expect_time(Path().rotary_line(at({{Axis::A, 90.0}}), 600.0, radius(1.0)), 90.0 / 120.0);
}

TEST(MotionFeed, RotaryFeedWithoutATurnIsAnOrdinaryLine) {
  expect_time(Path().rotary_line(at({{Axis::X, 20.0}}), 600.0, radius(10.0)), 2.0);
}

TEST(MotionFeed, PathSpeedIsReportedAsTheFeedIsMeasured) {
  const auto peak = [](const Path& path) {
    return play(four_axes(), path.actions()).blocks[0].peak_feed_mm_min;
  };
  EXPECT_NEAR(peak(Path().line(at({{Axis::X, 30.0}, {Axis::A, 40.0}}), 600.0)), 600.0, 1e-6);
  EXPECT_NEAR(peak(Path().rotary_line(at({{Axis::A, 90.0}}), 600.0, radius(10.0))), 600.0, 1e-6);
  EXPECT_NEAR(peak(Path(at({{Axis::X, 10.0}})).arc(0.0, 0.0, 90.0, 600.0, at({{Axis::Z, 5.0}}))), 600.0,
              1e-6);
}

TEST(MotionFeed, ExtremeMovesTakeDistanceOverFeed) {
  EXPECT_NEAR(time_of(Path().line(at({{Axis::X, 1e-6}}), 600.0)), 1e-7, 2e-11);  // the ramps take 1e-11 s
  expect_time(Path(at({{Axis::X, 1e-3}})).arc(0.0, 0.0, 360.0, 600.0), 2e-3 * kPi / 10.0);
  expect_time(Path(at({{Axis::X, 1e-3}})).arc(0.0, 0.0, 360000.0, 6000.0), 2.0 * kPi / 100.0);
  Machine coarse = four_axes();
  coarse.cycle_s = 1.0;
  const auto far = play(coarse, Path().line(at({{Axis::X, 1e6}}), 6000.0).actions());
  EXPECT_NEAR(far.time_s, 1e4, 1e-2);
  EXPECT_EQ(far.cycles.back().position[Axis::X], 1e6);
}

TEST(MotionFeed, ManyTinyMovesInOneCycleEndExactly) {
  Path path;
  for (int i = 1; i <= 50000; ++i) path.line(at({{Axis::X, 1e-6 * i}}), 6000.0);
  const auto samples = play(four_axes(), path.actions());
  EXPECT_NEAR(samples.time_s, 0.05 / 100.0, 1e-9);
  EXPECT_EQ(samples.cycles.size(), 1U);
  EXPECT_EQ(samples.cycles.back().position[Axis::X], 1e-6 * 50000);
}

}  // namespace
}  // namespace kerf
