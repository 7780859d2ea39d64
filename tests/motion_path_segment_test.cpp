#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "motion/path_segment.hpp"
#include "motion_test_support.hpp"

namespace kerf {
namespace {

using motion_test::at;
using motion_test::machine_with;
using motion_test::Path;

PathSegment segment_of(const Path& path, const Machine& machine) {
  PathSegment segment;
  const Move& move = std::get<Move>(path.actions().back().what);
  set_path(segment, move, make_axis_limits(machine), move.feed);
  return segment;
}

TEST(PathSegment, LineLimitsComeFromTheAxisThatReachesItsOwnFirst) {
  Machine machine = machine_with({Axis::X, Axis::Y}, 500.0);
  machine.axis[index(Axis::Y)].acceleration = 100.0;
  machine.axis[index(Axis::Y)].max_feed = 600.0;
  // Direction (0.8, 0.6): Y limits acceleration to 100 / 0.6 and speed to 10 / 0.6.
  const PathSegment segment = segment_of(Path().line(at({{Axis::X, 80}, {Axis::Y, 60}}), 6000.0), machine);
  EXPECT_NEAR(segment.length, 100.0, 1e-12);
  EXPECT_NEAR(segment.acceleration, 100.0 / 0.6, 1e-9);
  EXPECT_NEAR(segment.speed_limit, 10.0 / 0.6, 1e-9);
}

TEST(PathSegment, FeedOfALineIsMeasuredInXYZ) {
  const Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z, Axis::A});
  const PathSegment segment = segment_of(Path().line(at({{Axis::X, 30}, {Axis::A, 40}}), 600.0), machine);
  EXPECT_NEAR(segment.length, 50.0, 1e-12);
  EXPECT_NEAR(segment.length_mm, 30.0, 1e-12);
  EXPECT_NEAR(segment.feed_per_speed, 36.0, 1e-12);  // 1 mm/s of s is 0.6 mm/s in X
}

TEST(PathSegment, ArcKeepsCentripetalAndTangentialTogetherWithinTheAxis) {
  const Machine machine = machine_with({Axis::X, Axis::Y}, 500.0);
  // Radius 1: the centripetal share 0.8 x 500 is reached at 20 mm/s; 0.6 x 500 remain along the path.
  const PathSegment tight = segment_of(Path(at({{Axis::X, 1.0}})).arc(0.0, 0.0, 180.0, 6000.0), machine);
  EXPECT_NEAR(tight.speed_limit, 20.0, 1e-9);
  EXPECT_NEAR(tight.acceleration, 300.0, 1e-9);
  EXPECT_NEAR(tight.length, std::numbers::pi, 1e-12);
  // At F60 the room is that of twice the feed, 2 mm/s: 4 mm/s2 centripetal.
  const PathSegment slow = segment_of(Path(at({{Axis::X, 1.0}})).arc(0.0, 0.0, 180.0, 60.0), machine);
  EXPECT_NEAR(slow.speed_limit, 2.0, 1e-9);
  EXPECT_NEAR(slow.acceleration, std::sqrt(500.0 * 500.0 - 16.0), 1e-9);
}

TEST(PathSegment, HelixIncludesTheThirdAxis) {
  Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z}, 500.0);
  machine.axis[index(Axis::Z)].acceleration = 10.0;
  machine.axis[index(Axis::Z)].max_feed = 60.0;
  const double circle = 2.0 * std::numbers::pi * 10.0;
  const PathSegment segment =
      segment_of(Path(at({{Axis::X, 10.0}})).arc(0.0, 0.0, 360.0, 3000.0, at({{Axis::Z, circle}})), machine);
  const double diagonal = std::sqrt(2.0);  // Z climbs as fast as the circle runs
  EXPECT_NEAR(segment.length, circle * diagonal, 1e-9);
  EXPECT_NEAR(segment.length_mm, circle * diagonal, 1e-9);
  EXPECT_NEAR(segment.acceleration, 10.0 * diagonal, 1e-9);
  EXPECT_NEAR(segment.speed_limit, 1.0 * diagonal, 1e-9);
  EXPECT_NEAR(segment.feed_per_speed, 60.0 / diagonal, 1e-9);
}

TEST(PathSegment, TangentsOfArcs) {
  const Machine machine = machine_with({Axis::X, Axis::Y});
  const PathSegment ccw = segment_of(Path(at({{Axis::X, 10.0}})).arc(0.0, 0.0, 90.0, 600.0), machine);
  EXPECT_NEAR(start_tangent(ccw)[Axis::X], 0.0, 1e-12);
  EXPECT_NEAR(start_tangent(ccw)[Axis::Y], 1.0, 1e-12);
  EXPECT_NEAR(end_tangent(ccw)[Axis::X], -1.0, 1e-12);
  EXPECT_NEAR(end_tangent(ccw)[Axis::Y], 0.0, 1e-12);
  const PathSegment cw = segment_of(Path(at({{Axis::X, 10.0}})).arc(0.0, 0.0, -90.0, 600.0), machine);
  EXPECT_NEAR(start_tangent(cw)[Axis::Y], -1.0, 1e-12);
  EXPECT_NEAR(end_tangent(cw)[Axis::X], -1.0, 1e-12);
}

/// Position, velocity and acceleration belong together: differences of one are the other.
TEST(PathSegment, DerivativesOfAHelixAgreeWithDifferences) {
  const Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z});
  const PathSegment segment = segment_of(
      Path(at({{Axis::X, 3.0}, {Axis::Y, 4.0}})).arc(1.0, 1.0, -500.0, 600.0, at({{Axis::Z, 7.0}})), machine);
  const double speed = 3.0;
  const double acceleration = 5.0;
  const double step = 1e-4;
  const auto evaluate_at = [&](double t) {
    PathPoint point;
    evaluate(segment, 4.0 + (speed + 0.5 * acceleration * t) * t, speed + acceleration * t, acceleration,
             point);
    return point;
  };
  const PathPoint here = evaluate_at(0.0);
  const AxisVector before = evaluate_at(-step).position;
  const AxisVector after = evaluate_at(step).position;
  for (const Axis axis : machine.axes) {
    EXPECT_NEAR(here.velocity[axis], (after[axis] - before[axis]) / (2.0 * step), 1e-5);
    EXPECT_NEAR(here.acceleration[axis],
                (after[axis] - 2.0 * here.position[axis] + before[axis]) / (step * step), 1e-4);
  }
}

TEST(PathSegment, ArcWhoseEndLiesOffTheCircleEndsAtTheEndPoint) {
  const Machine machine = machine_with({Axis::X, Axis::Y});
  Move move;
  move.mode = MoveMode::counterclockwise;
  move.feed = 600.0;
  move.start = at({{Axis::X, 10.0}});
  move.end = at({{Axis::Y, 10.008}});
  move.arc = {{0.0, 0.0}, 10.0, 90.0};
  PathSegment segment;
  set_path(segment, move, make_axis_limits(machine), move.feed);
  PathPoint point;
  evaluate(segment, segment.length, 1.0, 0.0, point);
  EXPECT_NEAR(point.position[Axis::X], 0.0, 1e-12);
  EXPECT_NEAR(point.position[Axis::Y], 10.008, 1e-12);
  evaluate(segment, 0.5 * segment.length, 1.0, 0.0, point);
  EXPECT_NEAR(std::hypot(point.position[Axis::X], point.position[Axis::Y]), 10.004, 1e-9);
}

TEST(PathSegment, RangeOfAnArcReachesItsQuarterPoints) {
  const Machine machine = machine_with({Axis::X, Axis::Y});
  const double half = std::sqrt(0.5);
  // From 45 to 315 degrees counter-clockwise on radius 1 around (5, 7): reaches the top, the left and the
  // bottom.
  const PathSegment segment = segment_of(
      Path(at({{Axis::X, 5.0 + half}, {Axis::Y, 7.0 + half}})).arc(5.0, 7.0, 270.0, 600.0), machine);
  AxisVector low = segment.start;
  AxisVector high = segment.start;
  extend_range(segment, low, high);
  EXPECT_NEAR(low[Axis::X], 4.0, 1e-12);
  EXPECT_NEAR(high[Axis::X], 5.0 + half, 1e-12);
  EXPECT_NEAR(low[Axis::Y], 6.0, 1e-12);
  EXPECT_NEAR(high[Axis::Y], 8.0, 1e-12);
}

TEST(PathSegment, MovesOfNoOrUnusableLengthDoNotMove) {
  const Machine machine = machine_with({Axis::X, Axis::Y});
  EXPECT_EQ(segment_of(Path().line({}, 600.0), machine).length, 0.0);
  EXPECT_EQ(segment_of(Path().line(at({{Axis::X, 1e-12}}), 600.0), machine).length, 0.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(segment_of(Path().line(at({{Axis::X, nan}}), 600.0), machine).length, 0.0);
  EXPECT_GT(segment_of(Path().line(at({{Axis::X, 1e-6}}), 600.0), machine).length, 0.0);
}

}  // namespace
}  // namespace kerf
