// Expected centres and sweeps are worked out by hand; DGS numbers are rows of the DGSHAPE table of
// statements.

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "geometry/arc_construction.hpp"

namespace kerf {
namespace {

constexpr bool kClockwise = true;
constexpr bool kCounterclockwise = false;

void expect_arc(const ArcResult& result, Vec2 center, double radius, double sweep_deg) {
  ASSERT_EQ(result.fault, ArcFault::none);
  EXPECT_NEAR(result.arc.center.x, center.x, 1e-9);
  EXPECT_NEAR(result.arc.center.y, center.y, 1e-9);
  EXPECT_NEAR(result.arc.radius, radius, 1e-9);
  EXPECT_NEAR(result.arc.sweep_deg, sweep_deg, 1e-9);
}

// By how much the arc's own end misses the end asked for.
double miss_of(const PlanarArc& arc, Vec2 start, Vec2 end) {
  return distance(arc.center + rotated(start - arc.center, arc.sweep_deg), end);
}

TEST(ArcFromCenter, QuarterBothWays) {
  expect_arc(arc_from_center({0, 0}, {10, -10}, {0, -10}, kClockwise, 0.01), {0, -10}, 10, -90);
  expect_arc(arc_from_center({0, 0}, {10, -10}, {0, -10}, kCounterclockwise, 0.01), {0, -10}, 10, 270);
}

TEST(ArcFromCenter, HalfCircle) {
  expect_arc(arc_from_center({0, 0}, {10, 0}, {5, 0}, kClockwise, 0.01), {5, 0}, 5, -180);
  expect_arc(arc_from_center({0, 0}, {10, 0}, {5, 0}, kCounterclockwise, 0.01), {5, 0}, 5, 180);
}

// DGS-200.
TEST(ArcFromCenter, EndAtStartIsAFullCircle) {
  expect_arc(arc_from_center({0, 0}, {0, 0}, {5, 0}, kCounterclockwise, 0.01), {5, 0}, 5, 360);
  expect_arc(arc_from_center({0, 0}, {0, 5e-10}, {5, 0}, kClockwise, 0.01), {5, 0}, 5, -360);
}

// DGS-210: start radius 10, end radius sqrt(10^2 + 1^2) = 10.0499.
TEST(ArcFromCenter, RadiusDifference) {
  const ArcResult refused = arc_from_center({0, 0}, {10, -9}, {0, -10}, kClockwise, 0.01);
  EXPECT_EQ(refused.fault, ArcFault::radius_difference);
  EXPECT_NEAR(refused.difference_mm, std::sqrt(101.0) - 10.0, 1e-12);

  const ArcResult taken = arc_from_center({0, 0}, {10, -9}, {0, -10}, kClockwise, 0.1);
  ASSERT_EQ(taken.fault, ArcFault::none);
  EXPECT_NEAR(taken.difference_mm, std::sqrt(101.0) - 10.0, 1e-12);
  EXPECT_NEAR(distance(taken.arc.center, {0, 0}), distance(taken.arc.center, {10, -9}), 1e-12);
  EXPECT_NEAR(miss_of(taken.arc, {0, 0}, {10, -9}), 0.0, 1e-12);
}

// The chord is horizontal, so the centre moves along x only: from 4.9 to 5.
TEST(ArcFromCenter, CenterMovesAlongTheChord) {
  const ArcResult result = arc_from_center({0, 0}, {10, 0}, {4.9, -5}, kClockwise, 1.0);
  expect_arc(result, {5, -5}, std::sqrt(50.0), -90);
}

TEST(ArcFromCenter, RoundingIsNoDifference) {
  EXPECT_EQ(arc_from_center({0.1, 0.2}, {0.1 + 0.3, 0.2 + 0.3}, {0.4, 0.2}, kCounterclockwise, 0.0).fault,
            ArcFault::none);
}

TEST(ArcFromCenter, ZeroRadius) {
  EXPECT_EQ(arc_from_center({1, 1}, {1, 1}, {1, 1}, kClockwise, 0.01).fault, ArcFault::zero_radius);
  EXPECT_EQ(arc_from_center({1, 1}, {2, 1}, {1, 1}, kClockwise, 10).fault, ArcFault::zero_radius);
}

// A circle that ends 0.005 mm outside its start: no single radius comes near it, though the radii differ by
// so little.
TEST(ArcFromCenter, AlmostClosedCircleWithADifference) {
  EXPECT_EQ(arc_from_center({10, 0}, {10.005, 0.0001}, {0, 0}, kClockwise, 0.01).fault,
            ArcFault::radius_difference);
  const ArcResult exact = arc_from_center({10, 0}, 10.0 * direction_at(-359.9), {0, 0}, kClockwise, 0.01);
  expect_arc(exact, {0, 0}, 10, -359.9);
}

// DGS-206 to 208.
TEST(ArcFromRadius, SignSelectsTheArc) {
  const double height = std::sqrt(75.0);
  expect_arc(arc_from_radius({0, 0}, {10, 0}, 10, kClockwise, 0.01), {5, -height}, 10, -60);
  expect_arc(arc_from_radius({0, 0}, {10, 0}, -10, kClockwise, 0.01), {5, height}, 10, -300);
  expect_arc(arc_from_radius({0, 0}, {10, 0}, 10, kCounterclockwise, 0.01), {5, height}, 10, 60);
  expect_arc(arc_from_radius({0, 0}, {10, 0}, -10, kCounterclockwise, 0.01), {5, -height}, 10, 300);
  expect_arc(arc_from_radius({0, 0}, {10, 0}, 5, kClockwise, 0.01), {5, 0}, 5, -180);
}

TEST(ArcFromRadius, SlightlyShortRadiusIsAHalfCircle) {
  const ArcResult taken = arc_from_radius({0, 0}, {10, 0}, 4.995, kCounterclockwise, 0.01);
  expect_arc(taken, {5, 0}, 5, 180);
  EXPECT_NEAR(taken.difference_mm, 0.005, 1e-12);
  const ArcResult refused = arc_from_radius({0, 0}, {10, 0}, 4.98, kCounterclockwise, 0.01);
  EXPECT_EQ(refused.fault, ArcFault::chord_too_long);
  EXPECT_NEAR(refused.difference_mm, 0.02, 1e-12);
}

TEST(ArcFromRadius, Faults) {
  EXPECT_EQ(arc_from_radius({1, 2}, {1, 2}, 5, kClockwise, 0.01).fault, ArcFault::end_equals_start);
  EXPECT_EQ(arc_from_radius({1, 2}, {3, 2}, 0, kClockwise, 0.01).fault, ArcFault::zero_radius);
}

TEST(ArcConstruction, RandomArcsEndAtTheirEnd) {
  std::mt19937 random(20240511);
  std::uniform_real_distribution<double> coordinate(-500.0, 500.0);
  std::uniform_real_distribution<double> angle(1.0, 359.0);
  std::uniform_real_distribution<double> error(-0.005, 0.005);
  int made = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 start{coordinate(random), coordinate(random)};
    const Vec2 center{coordinate(random), coordinate(random)};
    const double sweep = (i % 2 == 0 ? 1.0 : -1.0) * angle(random);
    const double radius = distance(start, center);
    const Vec2 end = center + (1.0 + error(random) / radius) * rotated(start - center, sweep);
    const ArcResult by_center = arc_from_center(start, end, center, sweep < 0.0, 0.01);
    if (by_center.fault == ArcFault::none) {
      ++made;
      EXPECT_NEAR(miss_of(by_center.arc, start, end), 0.0, 1e-9 * radius);
      EXPECT_NEAR(by_center.arc.sweep_deg, sweep, 1.0);
    }
    const double signed_radius = std::abs(sweep) > 180.0 ? -radius : radius;
    const ArcResult by_radius = arc_from_radius(start, end, signed_radius, sweep < 0.0, 0.01);
    ASSERT_EQ(by_radius.fault, ArcFault::none);
    EXPECT_NEAR(miss_of(by_radius.arc, start, end), 0.0, 1e-9 * radius);
    EXPECT_NEAR(by_radius.arc.sweep_deg, sweep, 5.0);
  }
  EXPECT_GT(made, 1900);  // the rest are nearly closed
}

// Arcs of up to 180 degrees leave the programmed circle by at most the difference of the radii.
TEST(ArcConstruction, CorrectedMinorArcsStayNearTheProgrammedCircle) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(0.1, 179.9);
  for (int i = 0; i < 500; ++i) {
    const double sweep = angle(random);
    const Vec2 end = 10.008 * direction_at(sweep);
    const ArcResult result = arc_from_center({10, 0}, end, {0, 0}, kCounterclockwise, 0.01);
    ASSERT_EQ(result.fault, ArcFault::none);
    for (double part = 0.0; part <= 1.0; part += 0.125) {
      const Vec2 point =
          result.arc.center + rotated(Vec2{10, 0} - result.arc.center, part * result.arc.sweep_deg);
      EXPECT_GE(length(point), 10.0 - 0.0081);
      EXPECT_LE(length(point), 10.008 + 0.0081);
    }
  }
}

}  // namespace
}  // namespace kerf
