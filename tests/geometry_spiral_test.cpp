// Spirals by the length of their way.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "geometry/spiral.hpp"

namespace kerf {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Chords of a million parts.
double measured(const Spiral& spiral, double angle) {
  constexpr int kParts = 1'000'000;
  double way = 0.0;
  double x = spiral.radius;
  double y = 0.0;
  for (int i = 1; i <= kParts; ++i) {
    const double at = angle * i / kParts;
    const double radius = spiral.radius + spiral.growth * at;
    const double next_x = radius * std::cos(at);
    const double next_y = radius * std::sin(at);
    way += std::hypot(next_x - x, next_y - y);
    x = next_x;
    y = next_y;
  }
  return way;
}

TEST(Spiral, WayIsThatOfItsChords) {
  for (const Spiral& spiral :
       {Spiral{50.0, -10.0 / kTurn}, Spiral{80.0, -70.0 / kTurn}, Spiral{0.01, 30.0}, Spiral{5.0, 1e-3}}) {
    const double way = way_after(spiral, kTurn);
    EXPECT_NEAR(way, measured(spiral, kTurn), 1e-9 * way);
  }
}

// OMR-144: three turns with radius 50 to 40, 40 to 30, 30 to 20.
TEST(Spiral, TurnsOfTheManual) {
  EXPECT_NEAR(way_of_arc(50.0, 40.0, kTurn), 282.921, 0.0005);
  EXPECT_NEAR(way_of_arc(40.0, 30.0, kTurn), 220.140, 0.0005);
  EXPECT_NEAR(way_of_arc(30.0, 20.0, kTurn), 157.402, 0.0005);
  EXPECT_EQ(way_of_arc(50.0, 50.0, kTurn), 50.0 * kTurn);
}

TEST(Spiral, AngleIsTheInverseOfTheWay) {
  for (const double growth : {-7.9, -1.0, -0.01, 0.01, 2.0, 1000.0}) {
    const Spiral spiral{50.0, growth};
    const double way = way_after(spiral, kTurn);
    for (int i = 0; i <= 100; ++i) {
      const double angle = kTurn * i / 100.0;
      EXPECT_NEAR(angle_after(spiral, way_after(spiral, angle), kTurn), angle, 1e-10) << growth << " " << i;
    }
    EXPECT_LE(angle_after(spiral, way * 1.1, kTurn), kTurn);
  }
}

}  // namespace
}  // namespace kerf
