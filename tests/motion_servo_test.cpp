#include <cmath>
#include <gtest/gtest.h>

#include "motion/servo.hpp"
#include "motion_test_support.hpp"

namespace kerf {
namespace {

using motion_test::at;

MotionSettings gain(double value) {
  MotionSettings settings;
  settings.servo_gain = value;
  return settings;
}

TEST(ServoModel, FollowingErrorAtConstantVelocityIsVelocityOverGain) {
  ServoModel servo(gain(50.0), 0.001, at({{Axis::X, 2.0}}));
  AxisVector actual;
  double command = 2.0;
  for (int i = 0; i < 2000; ++i) {
    command += 0.1;  // 100 mm/s
    actual = servo.step(at({{Axis::X, command}}));
  }
  EXPECT_NEAR(command - actual[Axis::X], 100.0 / 50.0, 1e-9);
}

/// A step that lasts one cycle is a ramp over that cycle and then rest; the solution of the lag is known for
/// both.
TEST(ServoModel, SettlesAsALagOfTheFirstOrder) {
  const double k = 60.0;
  const double h = 0.002;
  ServoModel servo(gain(k), h, {});
  double actual = servo.step(at({{Axis::Y, 1.0}}))[Axis::Y];
  const double after_ramp = 1.0 - (1.0 - std::exp(-k * h)) / (k * h);
  EXPECT_NEAR(actual, after_ramp, 1e-12);
  for (int i = 0; i < 10; ++i) actual = servo.step(at({{Axis::Y, 1.0}}))[Axis::Y];
  EXPECT_NEAR(1.0 - actual, (1.0 - after_ramp) * std::exp(-k * h * 10), 1e-12);
}

TEST(ServoModel, TheCycleDoesNotChangeTheResponseToARamp) {
  ServoModel coarse(gain(40.0), 0.01, {});
  ServoModel fine(gain(40.0), 0.001, {});
  double fine_actual = 0.0;
  for (int i = 1; i <= 10; ++i) fine_actual = fine.step(at({{Axis::X, 0.1 * i}}))[Axis::X];
  EXPECT_NEAR(coarse.step(at({{Axis::X, 1.0}}))[Axis::X], fine_actual, 1e-12);
}

TEST(ServoModel, WithoutAGainTheDriveIsIdeal) {
  ServoModel servo(gain(0.0), 0.001, {});
  EXPECT_EQ(servo.step(at({{Axis::X, 3.5}}))[Axis::X], 3.5);
}

}  // namespace
}  // namespace kerf
