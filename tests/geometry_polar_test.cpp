// A contour seen from the centre of rotation, against hand-worked figures and against walking along it.

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "geometry/polar.hpp"

namespace kerf {
namespace {

/// What walking along a segment in small steps shows.
struct Walk {
  double turn_deg = 0.0;
  double least_turn_deg = 0.0;
  double greatest_turn_deg = 0.0;
  double least_radius = 0.0;
  double greatest_radius = 0.0;
  double turn = 0.0;  // largest |d angle / ds|, rad/mm
  double least_turn = 0.0;
  double turn2 = 0.0;
  double radius2 = 0.0;
};

Vec2 point_at(const PlanarSegment& segment, double part) {
  if (!segment.is_arc) return segment.start + part * (segment.end - segment.start);
  const double start_radius = distance(segment.center, segment.start);
  const double radius = start_radius + part * (distance(segment.center, segment.end) - start_radius);
  const double angle = angle_of_deg(segment.start - segment.center) + part * segment.sweep_deg;
  return segment.center + radius * direction_at(angle);
}

Walk walk(const PlanarSegment& segment, int steps) {
  Walk found;
  std::vector<double> angle{0.0};
  std::vector<double> radius{length(segment.start)};
  Vec2 before = segment.start;
  for (int i = 1; i <= steps; ++i) {
    const Vec2 now = point_at(segment, static_cast<double>(i) / steps);
    angle.push_back(angle.back() + std::atan2(cross(before, now), dot(before, now)));
    radius.push_back(length(now));
    before = now;
  }
  const double ds = length_of(segment) / steps;
  found.turn_deg = degrees(angle.back());
  found.least_turn = 1e30;
  found.least_radius = found.greatest_radius = radius.front();
  for (std::size_t i = 0; i < angle.size(); ++i) {
    found.least_turn_deg = std::min(found.least_turn_deg, degrees(angle[i]));
    found.greatest_turn_deg = std::max(found.greatest_turn_deg, degrees(angle[i]));
    found.least_radius = std::min(found.least_radius, radius[i]);
    found.greatest_radius = std::max(found.greatest_radius, radius[i]);
    if (i == 0 || i + 1 == angle.size()) continue;
    const double rate = std::abs(angle[i + 1] - angle[i - 1]) / (2.0 * ds);
    found.turn = std::max(found.turn, rate);
    found.least_turn = std::min(found.least_turn, rate);
    found.turn2 = std::max(found.turn2, std::abs(angle[i + 1] - 2.0 * angle[i] + angle[i - 1]) / (ds * ds));
    found.radius2 =
        std::max(found.radius2, std::abs(radius[i + 1] - 2.0 * radius[i] + radius[i - 1]) / (ds * ds));
  }
  return found;
}

/// Lines and arcs of 1 to 100 mm that stay at least 1 mm away from the origin.
class AnySegment {
 public:
  PlanarSegment next() {
    for (;;) {
      const PlanarSegment segment = uniform(0.0, 1.0) < 0.3 ? any_line() : any_arc();
      if (walk(segment, 400).least_radius > 1.0) return segment;
    }
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec2 any_point() { return {uniform(-50.0, 50.0), uniform(-50.0, 50.0)}; }
  PlanarSegment any_line() { return straight(any_point(), any_point()); }
  PlanarSegment any_arc() {
    const Vec2 center = uniform(0.0, 1.0) < 0.2 ? Vec2{} : any_point();
    const double radius = uniform(2.0, 60.0);
    const double sweep = uniform(-360.0, 360.0);
    const double angle = uniform(-180.0, 180.0);
    return curved(center + radius * direction_at(angle), center + radius * direction_at(angle + sweep),
                  center, radius, sweep);
  }

  std::mt19937 random_{20261122};
};

TEST(PolarContour, ShortestTurn) {
  EXPECT_DOUBLE_EQ(shortest_turn_deg(190.0), -170.0);
  EXPECT_DOUBLE_EQ(shortest_turn_deg(-190.0), 170.0);
  EXPECT_DOUBLE_EQ(shortest_turn_deg(540.0), 180.0);
  EXPECT_DOUBLE_EQ(shortest_turn_deg(-180.0), 180.0);
}

TEST(PolarContour, TurnOfALineWorkedByHand) {
  EXPECT_NEAR(turn_around_origin_deg(straight({20, 0}, {20, 20})), 45.0, 1e-12);
  EXPECT_NEAR(turn_around_origin_deg(straight({20, 20}, {-20, 20})), 90.0, 1e-12);
  EXPECT_NEAR(turn_around_origin_deg(straight({-20, 20}, {20, 20})), -90.0, 1e-12);
  EXPECT_EQ(turn_around_origin_deg(straight({20, 20}, {0, 0})), 0.0);
  EXPECT_EQ(turn_around_origin_deg(straight({0, 0}, {-3, 4})), 0.0);
}

TEST(PolarContour, TurnOfAnArcWorkedByHand) {
  // Around the origin, the whole circle and more than half of it.
  EXPECT_NEAR(turn_around_origin_deg(curved({20, 0}, {20, 0}, {0, 0}, 20, 360)), 360.0, 1e-9);
  EXPECT_NEAR(turn_around_origin_deg(curved({0, -20}, {-20, 0}, {0, 0}, 20, -270)), -270.0, 1e-9);
  // A circle of radius 20 about (5, 0), once around the origin inside of it.
  EXPECT_NEAR(turn_around_origin_deg(curved({25, 0}, {25, 0}, {5, 0}, 20, 360)), 360.0, 1e-9);
  // The origin outside of it: it comes back to the same direction.
  EXPECT_NEAR(turn_around_origin_deg(curved({35, 0}, {35, 0}, {30, 0}, 5, 360)), 0.0, 1e-9);
  // From (30, 5) the long way to (30, -5): over the near side, from atan(5/30) down to its opposite.
  EXPECT_NEAR(turn_around_origin_deg(curved({30, 5}, {30, -5}, {30, 0}, 5, 180)),
              -2.0 * degrees(std::atan2(5, 30)), 1e-9);
  // From the origin on a circle through it: half the angle at the circle's centre.
  EXPECT_NEAR(turn_around_origin_deg(curved({0, 0}, {5, 5}, {5, 0}, 5, -90)), -45.0, 1e-9);
}

TEST(PolarContour, SpiralAcrossTheDistanceOfTheOrigin) {
  // From radius 10 to 30 about (20, 0), two quarters counterclockwise: over (20, 20), the origin stays on the
  // left.
  const PlanarSegment spiral = curved({30, 0}, {-10, 0}, {20, 0}, 10, 180);
  EXPECT_NEAR(turn_around_origin_deg(spiral), 180.0, 1e-6);
}

TEST(PolarContour, TurnAndRangeAreThoseOfWalkingAlong) {
  AnySegment any;
  for (int i = 0; i < 400; ++i) {
    const PlanarSegment segment = any.next();
    SCOPED_TRACE(i);
    const Walk walked = walk(segment, 4000);
    EXPECT_NEAR(turn_around_origin_deg(segment), walked.turn_deg, 1e-6);
    const PolarRange range = polar_range(segment);
    EXPECT_NEAR(range.least_radius, walked.least_radius, 1e-2);
    EXPECT_LE(range.least_radius, walked.least_radius + 1e-9);
    EXPECT_NEAR(range.greatest_radius, walked.greatest_radius, 1e-2);
    EXPECT_GE(range.greatest_radius, walked.greatest_radius - 1e-9);
    EXPECT_NEAR(range.least_turn_deg, walked.least_turn_deg, 1e-2);
    EXPECT_LE(range.least_turn_deg, walked.least_turn_deg + 1e-9);
    EXPECT_NEAR(range.greatest_turn_deg, walked.greatest_turn_deg, 1e-2);
    EXPECT_GE(range.greatest_turn_deg, walked.greatest_turn_deg - 1e-9);
  }
}

TEST(PolarContour, RatesHoldEverywhereOnTheWay) {
  AnySegment any;
  for (int i = 0; i < 400; ++i) {
    const PlanarSegment segment = any.next();
    SCOPED_TRACE(i);
    const Walk walked = walk(segment, 4000);
    const PolarRates rates = polar_rates(segment);
    const auto holds = [](double bound, double seen) { return bound * 1.001 + 1e-5 >= seen; };
    EXPECT_TRUE(holds(rates.turn, walked.turn)) << rates.turn << " " << walked.turn;
    EXPECT_TRUE(holds(rates.turn2, walked.turn2)) << rates.turn2 << " " << walked.turn2;
    EXPECT_TRUE(holds(rates.radius2, walked.radius2)) << rates.radius2 << " " << walked.radius2;
    EXPECT_LE(rates.least_turn, walked.least_turn * 1.001 + 1e-5);
    // Where the rate is greatest is known, so the bound is no more than that, but for the last step at the
    // ends.
    EXPECT_NEAR(rates.turn, walked.turn, 1e-5 + 2.0 * rates.turn2 * length_of(segment) / 4000.0);
  }
}

TEST(PolarContour, FindsTheWayThroughTheOrigin) {
  EXPECT_NEAR(part_before_origin(straight({30, 0}, {-10, 0})), 0.75, 1e-12);
  EXPECT_EQ(part_before_origin(straight({30, 1e-3}, {-10, 1e-3})), 0.0);
  EXPECT_EQ(part_before_origin(straight({30, 0}, {0, 0})), 0.0);
  EXPECT_EQ(part_before_origin(straight({30, 0}, {10, 0})), 0.0);
  // A circle of radius 5 about (5, 0), from its far point over the top to its lowest: half a turn of three
  // quarters.
  EXPECT_NEAR(part_before_origin(curved({10, 0}, {5, -5}, {5, 0}, 5, 270)), 2.0 / 3.0, 1e-9);
  EXPECT_EQ(part_before_origin(curved({10, 0}, {5, 5}, {5, 0}, 5, 90)), 0.0);
}

TEST(PolarContour, PartsMakeTheWhole) {
  AnySegment any;
  for (int i = 0; i < 100; ++i) {
    const PlanarSegment segment = any.next();
    const PlanarSegment first = part_of(segment, 0.0, 0.3);
    const PlanarSegment second = part_of(segment, 0.3, 1.0);
    EXPECT_NEAR(distance(first.end, second.start), 0.0, 1e-12);
    EXPECT_EQ(second.end.x, segment.end.x);
    EXPECT_EQ(second.end.y, segment.end.y);
    EXPECT_NEAR(length_of(first), 0.3 * length_of(segment), 1e-9);
    EXPECT_NEAR(turn_around_origin_deg(first) + turn_around_origin_deg(second),
                turn_around_origin_deg(segment), 1e-7);
  }
}

}  // namespace
}  // namespace kerf
