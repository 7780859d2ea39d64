#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "motion/profile.hpp"

namespace kerf {
namespace {

TEST(SpeedProfile, TrapezoidFromRestToRest) {
  // 100 mm at 50 mm/s and 500 mm/s2: ramps of 0.1 s and 2.5 mm, 95 mm at 50 mm/s.
  const SpeedProfile p = make_profile(100.0, 0.0, 0.0, 50.0, 500.0);
  EXPECT_NEAR(p.time1, 0.1, 1e-12);
  EXPECT_NEAR(p.time2, 0.1 + 1.9, 1e-12);
  EXPECT_NEAR(p.time3, 2.1, 1e-12);
  EXPECT_NEAR(p.at(0.05).s, 0.625, 1e-12);
  EXPECT_NEAR(p.at(0.05).speed, 25.0, 1e-12);
  EXPECT_NEAR(p.at(1.1).s, 52.5, 1e-12);
  EXPECT_NEAR(p.at(2.05).s, 100.0 - 0.625, 1e-12);
  EXPECT_DOUBLE_EQ(p.at(2.05).acceleration, -500.0);
  EXPECT_EQ(p.at(p.time3).s, 100.0);
  EXPECT_EQ(p.at(p.time3).speed, 0.0);
}

TEST(SpeedProfile, TriangleWhenTheWayIsTooShortForTheSpeed) {
  // 0.2 mm at 500 mm/s2: up and down 0.1 mm each, top sqrt(2 500 0.1) = 10 mm/s, 0.02 s each.
  const SpeedProfile p = make_profile(0.2, 0.0, 0.0, 50.0, 500.0);
  EXPECT_NEAR(p.top, 10.0, 1e-12);
  EXPECT_NEAR(p.time3, 0.04, 1e-12);
  EXPECT_NEAR(p.time2, p.time1, 1e-12);
  EXPECT_NEAR(p.peak_until(p.time3), 10.0, 1e-12);
}

TEST(SpeedProfile, EntryAboveTheCapBrakesToTheCapFirst) {
  // From 100 to 50 mm/s at 500 mm/s2: 0.1 s and 7.5 mm. From 50 to 10: 0.08 s and 2.4 mm. 20.1 mm between:
  // 0.402 s.
  const SpeedProfile p = make_profile(30.0, 100.0, 10.0, 50.0, 500.0);
  EXPECT_NEAR(p.time1, 0.1, 1e-12);
  EXPECT_NEAR(p.time2, 0.502, 1e-12);
  EXPECT_NEAR(p.time3, 0.582, 1e-12);
  EXPECT_DOUBLE_EQ(p.at(0.05).acceleration, -500.0);
  EXPECT_NEAR(p.at(0.05).speed, 75.0, 1e-12);
  EXPECT_NEAR(p.peak_until(p.time3), 100.0, 1e-12);
}

TEST(SpeedProfile, EntryAboveTheCapWithNoRoomBrakesAllTheWay) {
  // 100 -> 80 mm/s at 500 mm/s2 takes 3.6 mm; the exit is still above the cap.
  const SpeedProfile p = make_profile(3.6, 100.0, 80.0, 50.0, 500.0);
  EXPECT_NEAR(p.time3, 0.04, 1e-12);
  EXPECT_NEAR(p.at(0.02).speed, 90.0, 1e-9);
}

TEST(SpeedProfile, WithoutAFeedTheMotionStopsAndNeverEnds) {
  const SpeedProfile p = make_profile(100.0, 50.0, 0.0, 0.0, 500.0);
  EXPECT_NEAR(p.time1, 0.1, 1e-12);
  EXPECT_TRUE(std::isinf(p.time3));
  EXPECT_NEAR(p.at(1000.0).s, 2.5, 1e-12);
  EXPECT_EQ(p.at(1000.0).speed, 0.0);
}

TEST(SpeedProfile, NoLengthTakesNoTime) {
  for (const double speed : {0.0, 5.0}) {
    const SpeedProfile p = make_profile(0.0, speed, speed, 50.0, 500.0);
    EXPECT_EQ(p.time3, 0.0);
    EXPECT_EQ(p.at(0.0).speed, speed);
    EXPECT_EQ(p.peak_until(0.0), speed);
  }
}

TEST(SpeedProfile, TheCheckRejectsProfilesThatEndElsewhereOrOtherwise) {
  const SpeedProfile good = make_profile(100.0, 10.0, 20.0, 50.0, 500.0);
  EXPECT_TRUE(ends_as_planned(good));
  SpeedProfile wrong_way = good;
  wrong_way.time2 += 1e-6;
  wrong_way.time3 += 1e-6;  // that much longer at top speed
  EXPECT_FALSE(ends_as_planned(wrong_way));
  SpeedProfile wrong_speed = good;
  wrong_speed.exit += 1e-6;
  EXPECT_FALSE(ends_as_planned(wrong_speed));
  SpeedProfile backwards = good;
  backwards.time2 = backwards.time1 - 0.01;
  EXPECT_FALSE(ends_as_planned(backwards));
}

/// Over many magnitudes: the closed form ends where it should, never leaves the limits, and is continuous.
TEST(SpeedProfile, RandomProfilesKeepTheirLimits) {
  std::mt19937 random(20240517);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto magnitude = [&](double low, double high) {
    return std::exp(std::log(low) + unit(random) * (std::log(high) - std::log(low)));
  };
  for (int i = 0; i < 20000; ++i) {
    const double length = magnitude(1e-6, 1e6);
    const double acceleration = magnitude(1.0, 1e12);
    const double cap = magnitude(1e-3, 1e3);
    const double gain = 2.0 * acceleration * length;
    const double entry = unit(random) < 0.3 ? 0.0 : cap * unit(random);
    const double lowest = std::sqrt(std::max(0.0, entry * entry - gain));
    const double highest = std::min(cap, std::sqrt(entry * entry + gain));
    const double exit = entry == 0.0 && unit(random) < 0.5 ? 0.0 : lowest + (highest - lowest) * unit(random);
    const SpeedProfile p = make_profile(length, entry, exit, cap, acceleration);
    ASSERT_TRUE(std::isfinite(p.time3)) << i;
    ASSERT_TRUE(ends_as_planned(p)) << i << " length " << length << " entry " << entry << " exit " << exit;
    // The quickest: ramps at full acceleration to the highest speed that the way allows.
    const double top = std::min(cap, std::sqrt(0.5 * (gain + entry * entry + exit * exit)));
    const double ramps = (2.0 * top - entry - exit) / acceleration;
    const double flat =
        (length - (2.0 * top * top - entry * entry - exit * exit) / (2.0 * acceleration)) / top;
    const double rounding = 1e-15 * top / acceleration;  // of the differences of speeds
    ASSERT_NEAR(p.time3, ramps + flat, 1e-6 * (ramps + flat) + 4.0 * rounding) << i;
    double last = 0.0;
    for (int k = 0; k <= 40; ++k) {
      const ProfilePoint point = p.at(p.time3 * k / 40.0);
      ASSERT_LE(point.speed, cap * (1.0 + 1e-9)) << i;
      ASSERT_GE(point.speed, -1e-9 * cap) << i;
      ASSERT_LE(std::abs(point.acceleration), acceleration * (1.0 + 1e-9)) << i;
      ASSERT_GE(point.s, last - 1e-9 * length) << i;
      ASSERT_LE(point.s - last, cap * p.time3 / 40.0 + 1e-9 * length) << i;
      last = point.s;
    }
    ASSERT_NEAR(last, length, 1e-9 * length);
  }
}

}  // namespace
}  // namespace kerf
