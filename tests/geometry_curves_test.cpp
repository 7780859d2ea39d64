// Arcs, segments and their parallels, meeting points.

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "geometry/circular_arc.hpp"
#include "geometry/intersection.hpp"
#include "geometry/planar_segment.hpp"

namespace kerf {
namespace {

void expect_near(Vec2 actual, Vec2 expected, double tolerance = 1e-12) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
}

// ---- arcs

TEST(CircularArc, AheadAndBehind) {
  EXPECT_DOUBLE_EQ(ahead_deg({1, 0}, {0, 1}, false), 90.0);
  EXPECT_DOUBLE_EQ(ahead_deg({1, 0}, {0, 1}, true), -90.0);
  EXPECT_DOUBLE_EQ(ahead_deg({1, 0}, {-1, 0}, false), 180.0);
  EXPECT_DOUBLE_EQ(ahead_deg({1, 0}, {-1, 0}, true), 180.0);
}

TEST(CircularArc, PointsAndTangents) {
  const CircularArc arc = arc_through({30, 0}, {30, 10}, 90.0);
  EXPECT_DOUBLE_EQ(arc.radius, 10.0);
  EXPECT_DOUBLE_EQ(arc.start_angle_deg, -90.0);
  expect_near(start_of(arc), {30, 0});
  expect_near(end_of(arc), {40, 10});
  expect_near(point_on(arc, 45.0), {30 + 10 * std::sqrt(0.5), 10 - 10 * std::sqrt(0.5)});
  expect_near(tangent_on(arc, 0.0), {1, 0});
  expect_near(tangent_on(arc, 90.0), {0, 1});
  EXPECT_NEAR(length_of(arc), 15.707963267948966, 1e-12);

  const CircularArc back = arc_through({40, 10}, {30, 10}, -90.0);
  expect_near(end_of(back), {30, 0});
  expect_near(tangent_on(back, 0.0), {0, -1});
}

TEST(CircularArc, Bounds) {
  // From 30 to 200 degrees: over the top and the left, not the right nor the bottom.
  const CircularArc arc{{1, 2}, 10.0, 30.0, 170.0};
  const PlanarBox box = bounds_of(arc);
  EXPECT_NEAR(box.low.x, -9.0, 1e-12);
  EXPECT_NEAR(box.high.y, 12.0, 1e-12);
  EXPECT_NEAR(box.high.x, 1.0 + 10.0 * std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(box.low.y, 2.0 + 10.0 * std::sin(radians(200.0)), 1e-12);
}

TEST(CircularArc, BoundsTheOtherWayAndAllRound) {
  // Clockwise from -170 to -280 degrees passes 180 only.
  const PlanarBox box = bounds_of({{0, 0}, 1.0, -170.0, -110.0});
  EXPECT_DOUBLE_EQ(box.low.x, -1.0);
  EXPECT_NEAR(box.high.y, 1.0, 1e-15);
  EXPECT_NEAR(box.high.x, std::cos(radians(-280.0)), 1e-12);
  EXPECT_NEAR(box.low.y, std::sin(radians(-170.0)), 1e-12);

  const PlanarBox circle = bounds_of({{5, 5}, 2.0, 77.0, -360.0});
  EXPECT_EQ(circle.low, (Vec2{3, 3}));
  EXPECT_EQ(circle.high, (Vec2{7, 7}));
}

TEST(CircularArc, BoundsHoldEveryPoint) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> angle(-720.0, 720.0);
  for (int i = 0; i < 300; ++i) {
    const CircularArc arc{{3, -4}, 5.0, angle(random), angle(random)};
    const PlanarBox box = bounds_of(arc);
    double low_x = 1e9;
    double high_y = -1e9;
    constexpr int kSteps = 2000;
    for (int step = 0; step <= kSteps; ++step) {
      const Vec2 point = point_on(arc, arc.sweep_deg * step / kSteps);
      low_x = std::min(low_x, point.x);
      high_y = std::max(high_y, point.y);
    }
    // The samples lie at most 0.36 degrees from the outermost point, which is 5 (1 - cos 0.36) = 0.0001 mm
    // inside.
    EXPECT_LE(box.low.x, low_x + 1e-12);
    EXPECT_NEAR(box.low.x, low_x, 2e-4);
    EXPECT_GE(box.high.y, high_y - 1e-12);
    EXPECT_NEAR(box.high.y, high_y, 2e-4);
  }
}

// ---- meeting points

TEST(Meeting, LinesMeet) {
  const Meeting meeting = meeting_of(line_through({0, 2}, {10, 2}), line_through({8, -5}, {8, 5}));
  ASSERT_EQ(meeting.points.size(), 1U);
  expect_near(meeting.points[0], {8, 2});
}

TEST(Meeting, ParallelLinesMiss) {
  const Meeting meeting = meeting_of(line_through({0, 2}, {10, 2}), line_through({10, 5}, {0, 5}));
  EXPECT_TRUE(meeting.points.empty());
  EXPECT_DOUBLE_EQ(meeting.gap_mm, 3.0);
}

TEST(Meeting, LineHelpers) {
  const PlanarLine line = line_through({0, 0}, {3, 4});
  expect_near(line.direction, {0.6, 0.8});
  expect_near(offset_line(line, 5.0).point, {-4, 3});
  expect_near(offset_line(line, -5.0).point, {4, -3});
  expect_near(foot_on(line, {-4, 3}), {0, 0});
}

// DGS-341: 40 - sqrt(12^2 - 2^2) = 28.168.
TEST(Meeting, LineAndCircle) {
  const PlanarCircle circle{{40, 0}, 12.0};
  const Meeting meeting = meeting_of(line_through({10, 2}, {30, 2}), circle);
  ASSERT_EQ(meeting.points.size(), 2U);
  expect_near(*nearest_point(meeting, {30, 0}), {40 - std::sqrt(140.0), 2});
  expect_near(*nearest_point(meeting, {50, 0}), {40 + std::sqrt(140.0), 2});
  expect_near(*nearest_point(meeting_of(circle, line_through({10, 2}, {30, 2})), {30, 0}),
              {40 - std::sqrt(140.0), 2});
}

TEST(Meeting, LineTouchesCircle) {
  const Meeting meeting = meeting_of(line_through({0, 3}, {1, 3}), PlanarCircle{{7, 0}, 3.0});
  ASSERT_FALSE(meeting.points.empty());
  expect_near(*nearest_point(meeting, {7, 3}), {7, 3}, 1e-7);
}

TEST(Meeting, LineMissesCircle) {
  const PlanarLine line = line_through({0, 5}, {1, 5});
  const PlanarCircle circle{{7, 0}, 3.0};
  const Meeting meeting = meeting_of(line, circle);
  EXPECT_TRUE(meeting.points.empty());
  EXPECT_DOUBLE_EQ(meeting.gap_mm, 2.0);
  expect_near(meeting.nearest_on_first, {7, 5});
  expect_near(meeting.nearest_on_second, {7, 3});
  const Meeting swapped = meeting_of(circle, line);
  expect_near(swapped.nearest_on_first, {7, 3});
  expect_near(swapped.nearest_on_second, {7, 5});
  EXPECT_FALSE(nearest_point(meeting, {0, 0}).has_value());
}

// DGS-355: circles of radius 9 around (0,0) and (16,0) meet at (8, +-sqrt(17)).
TEST(Meeting, Circles) {
  const Meeting meeting = meeting_of(PlanarCircle{{0, 0}, 9.0}, PlanarCircle{{16, 0}, 9.0});
  ASSERT_EQ(meeting.points.size(), 2U);
  expect_near(*nearest_point(meeting, {8, 6}), {8, std::sqrt(17.0)});
  expect_near(*nearest_point(meeting, {8, -6}), {8, -std::sqrt(17.0)});
}

TEST(Meeting, CirclesTouch) {
  const Meeting outside = meeting_of(PlanarCircle{{0, 0}, 4.0}, PlanarCircle{{7, 0}, 3.0});
  ASSERT_FALSE(outside.points.empty());
  expect_near(outside.points[0], {4, 0}, 1e-6);
  const Meeting inside = meeting_of(PlanarCircle{{0, 0}, 4.0}, PlanarCircle{{1, 0}, 3.0});
  ASSERT_FALSE(inside.points.empty());
  expect_near(inside.points[0], {4, 0}, 1e-6);
}

TEST(Meeting, CirclesMiss) {
  // DGS-354: radius 7 each, 16 apart.
  const Meeting apart = meeting_of(PlanarCircle{{0, 0}, 7.0}, PlanarCircle{{16, 0}, 7.0});
  EXPECT_TRUE(apart.points.empty());
  EXPECT_DOUBLE_EQ(apart.gap_mm, 2.0);
  expect_near(apart.nearest_on_first, {7, 0});
  expect_near(apart.nearest_on_second, {9, 0});

  const Meeting within = meeting_of(PlanarCircle{{1, 0}, 2.0}, PlanarCircle{{0, 0}, 10.0});
  EXPECT_TRUE(within.points.empty());
  EXPECT_DOUBLE_EQ(within.gap_mm, 7.0);
  expect_near(within.nearest_on_first, {3, 0});
  expect_near(within.nearest_on_second, {10, 0});

  const Meeting concentric = meeting_of(PlanarCircle{{1, 1}, 2.0}, PlanarCircle{{1, 1}, 3.5});
  EXPECT_TRUE(concentric.points.empty());
  EXPECT_DOUBLE_EQ(concentric.gap_mm, 1.5);
}

TEST(Meeting, RandomMeetingPointsLieOnBothCurves) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-20.0, 20.0);
  std::uniform_real_distribution<double> radius(1.0, 25.0);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const PlanarCircle a{{coordinate(random), coordinate(random)}, radius(random)};
    const PlanarCircle b{{coordinate(random), coordinate(random)}, radius(random)};
    const PlanarLine line =
        line_through({coordinate(random), coordinate(random)}, {coordinate(random), coordinate(random)});
    for (const Vec2 point : meeting_of(a, b).points) {
      ++met;
      EXPECT_NEAR(distance(point, a.center), a.radius, 1e-6);
      EXPECT_NEAR(distance(point, b.center), b.radius, 1e-6);
    }
    for (const Vec2 point : meeting_of(line, a).points) {
      ++met;
      EXPECT_NEAR(distance(point, a.center), a.radius, 1e-6);
      EXPECT_NEAR(distance(point, foot_on(line, point)), 0.0, 1e-9);
    }
  }
  EXPECT_GT(met, 2000);
}

// ---- segments

TEST(PlanarSegment, Straight) {
  const PlanarSegment line = straight({0, 0}, {3, 4});
  EXPECT_DOUBLE_EQ(length_of(line), 5.0);
  expect_near(start_tangent(line), {0.6, 0.8});
  expect_near(end_tangent(line), {0.6, 0.8});
  const PlanarSegment moved = offset_segment(line, 5.0);
  expect_near(moved.start, {-4, 3});
  expect_near(moved.end, {-1, 7});
  expect_near(offset_segment(line, -5.0).start, {4, -3});
  EXPECT_EQ(start_tangent(straight({1, 1}, {1, 1})), (Vec2{}));
}

TEST(PlanarSegment, CounterclockwiseArc) {
  const PlanarSegment arc = curved({30, 0}, {40, 10}, {30, 10}, 10.0, 90.0);
  expect_near(start_tangent(arc), {1, 0});
  expect_near(end_tangent(arc), {0, 1});
  EXPECT_NEAR(length_of(arc), 15.707963267948966, 1e-12);
  EXPECT_DOUBLE_EQ(offset_radius(arc, 2.0), 8.0);
  EXPECT_DOUBLE_EQ(offset_radius(arc, -2.0), 12.0);
  EXPECT_DOUBLE_EQ(offset_radius(arc, 12.0), -2.0);
  const PlanarSegment inside = offset_segment(arc, 2.0);
  expect_near(inside.start, {30, 2});
  expect_near(inside.end, {38, 10});
  EXPECT_DOUBLE_EQ(inside.radius, 8.0);
  EXPECT_DOUBLE_EQ(inside.sweep_deg, 90.0);
}

TEST(PlanarSegment, ClockwiseArc) {
  const PlanarSegment arc = curved({40, 10}, {30, 0}, {30, 10}, 10.0, -90.0);
  expect_near(start_tangent(arc), {0, -1});
  expect_near(end_tangent(arc), {-1, 0});
  EXPECT_DOUBLE_EQ(offset_radius(arc, 2.0), 12.0);
  const PlanarSegment outside = offset_segment(arc, 2.0);
  expect_near(outside.start, {42, 10});
  expect_near(outside.end, {30, -2});
  const PlanarSegment point = offset_segment(arc, -10.0);
  EXPECT_DOUBLE_EQ(point.radius, 0.0);
  expect_near(point.start, {30, 10});
}

TEST(PlanarSegment, RandomParallelsLieAtTheOffset) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-50.0, 50.0);
  std::uniform_real_distribution<double> sweep(-350.0, 350.0);
  std::uniform_real_distribution<double> offset(-3.0, 3.0);
  for (int i = 0; i < 500; ++i) {
    const Vec2 start{coordinate(random), coordinate(random)};
    const Vec2 other{coordinate(random), coordinate(random)};
    const double left = offset(random);
    const PlanarSegment line = offset_segment(straight(start, other), left);
    for (const double part : {0.0, 0.3, 1.0}) {
      const Vec2 point = line.start + part * (line.end - line.start);
      EXPECT_NEAR(cross(unit(other - start), point - start), left, 1e-9);
    }
    const double radius = distance(start, other);
    if (radius < 4.0) continue;
    const double turn = sweep(random);
    const PlanarSegment arc =
        offset_segment(curved(start, other + rotated(start - other, turn), other, radius, turn), left);
    const double expected = turn > 0.0 ? radius - left : radius + left;
    EXPECT_NEAR(arc.radius, expected, 1e-9);
    EXPECT_NEAR(distance(arc.start, other), expected, 1e-9);
    EXPECT_NEAR(distance(arc.end, other), expected, 1e-9);
  }
}

}  // namespace
}  // namespace kerf
