#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "motion/junction.hpp"
#include "motion_test_support.hpp"

namespace kerf {
namespace {

using motion_test::at;
using motion_test::machine_with;

constexpr double kLong = 1000.0;  // mm, long enough for the rule of short segments not to count

AxisVector heading(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return at({{Axis::X, std::cos(angle)}, {Axis::Y, std::sin(angle)}});
}

double speed_squared(double turn_degrees, double mean_length, double deviation, const Machine& machine) {
  return junction_speed_squared(heading(30.0), heading(30.0 + turn_degrees), mean_length, deviation,
                                make_axis_limits(machine));
}

TEST(Junction, RightAngleByTheFormula) {
  const Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z}, 500.0);
  // h = 45 degrees: sin h / (1 - sin h) = 0.707107 / 0.292893 = 2.414214; 500 x 0.01 x 2.414214.
  EXPECT_NEAR(speed_squared(90.0, kLong, 0.01, machine), 12.07107, 1e-5);
  EXPECT_NEAR(speed_squared(-90.0, kLong, 0.01, machine), 12.07107, 1e-5);
}

TEST(Junction, SixtyDegreesBetweenTheLegsByTheFormula) {
  const Machine machine = machine_with({Axis::X, Axis::Y}, 800.0);
  // Turn of 120 degrees, h = 30 degrees: 0.5 / 0.5 = 1; 800 x 0.02.
  EXPECT_NEAR(speed_squared(120.0, kLong, 0.02, machine), 16.0, 1e-9);
}

TEST(Junction, ReversalStops) {
  const Machine machine = machine_with({Axis::X, Axis::Y});
  EXPECT_NEAR(speed_squared(180.0, kLong, 0.01, machine), 0.0, 1e-6);
}

TEST(Junction, TangentSegmentsAreFree) {
  const Machine machine = machine_with({Axis::X, Axis::Y});
  EXPECT_TRUE(std::isinf(speed_squared(0.0, kLong, 0.01, machine)));
  EXPECT_TRUE(std::isinf(speed_squared(0.0, kLong, 0.0, machine)));
}

TEST(Junction, DeviationZeroStopsAtCornersOnly) {
  const Machine machine = machine_with({Axis::X, Axis::Y});
  EXPECT_EQ(speed_squared(1.0, kLong, 0.0, machine), 0.0);
  EXPECT_GT(speed_squared(0.001, kLong, 0.0, machine), 1e6);
}

TEST(Junction, ShortSegmentsCountAsACurve) {
  const Machine machine = machine_with({Axis::X, Axis::Y}, 500.0);
  // 0.1 mm chords turning by 0.01 rad: radius 10 mm, v2 = 500 x 10. The deviation alone would allow 500 x
  // 0.01 x 8e4.
  const double degrees = 0.01 * 180.0 / std::numbers::pi;
  EXPECT_NEAR(speed_squared(degrees, 0.1, 0.01, machine), 5000.0, 0.1);
}

TEST(Junction, TheSlowestAxisInThePlaneOfTheTurnCounts) {
  Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z}, 500.0);
  machine.axis[index(Axis::Y)].acceleration = 100.0;
  machine.axis[index(Axis::Z)].acceleration = 1.0;  // does not take part
  EXPECT_NEAR(speed_squared(90.0, kLong, 0.01, machine), 12.07107 / 5.0, 1e-5);
}

TEST(Junction, AnAxisOutsideThePlaneByHalfCountsByItsShare) {
  Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z}, 500.0);
  machine.axis[index(Axis::Z)].acceleration = 100.0;
  // From +X to (0, 1, 1)/sqrt 2: in that plane Z has at most 1/sqrt 2 of any acceleration, so a = 100 sqrt 2.
  const double half = std::sqrt(0.5);
  const double squared = junction_speed_squared(at({{Axis::X, 1.0}}), at({{Axis::Y, half}, {Axis::Z, half}}),
                                                kLong, 0.01, make_axis_limits(machine));
  EXPECT_NEAR(squared, 100.0 * std::sqrt(2.0) * 0.01 * 2.414214, 1e-5);
}

}  // namespace
}  // namespace kerf
