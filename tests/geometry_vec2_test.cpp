#include <gtest/gtest.h>

#include "geometry/vec2.hpp"

namespace kerf {
namespace {

TEST(Vec2, Arithmetic) {
  EXPECT_EQ((Vec2{1, 2} + Vec2{3, -5}), (Vec2{4, -3}));
  EXPECT_EQ((Vec2{1, 2} - Vec2{3, -5}), (Vec2{-2, 7}));
  EXPECT_EQ((-Vec2{1, -2}), (Vec2{-1, 2}));
  EXPECT_EQ((2.0 * Vec2{1, 2}), (Vec2{2, 4}));
  EXPECT_EQ((Vec2{1, 2} * 3.0), (Vec2{3, 6}));
  EXPECT_EQ((Vec2{4, 2} / 2.0), (Vec2{2, 1}));
}

TEST(Vec2, Products) {
  EXPECT_DOUBLE_EQ(dot({1, 2}, {3, 4}), 11.0);
  EXPECT_DOUBLE_EQ(cross({1, 0}, {0, 1}), 1.0);
  EXPECT_DOUBLE_EQ(cross({0, 1}, {1, 0}), -1.0);
}

TEST(Vec2, Lengths) {
  EXPECT_DOUBLE_EQ(length({3, 4}), 5.0);
  EXPECT_DOUBLE_EQ(distance({1, 1}, {4, 5}), 5.0);
  EXPECT_EQ(midpoint({1, 1}, {4, 5}), (Vec2{2.5, 3}));
  EXPECT_EQ(unit({0, -7}), (Vec2{0, -1}));
  EXPECT_EQ(unit({0, 0}), (Vec2{0, 0}));
}

TEST(Vec2, Angles) {
  EXPECT_EQ(left_of({1, 0}), (Vec2{0, 1}));
  EXPECT_DOUBLE_EQ(angle_of_deg({0, 5}), 90.0);
  EXPECT_DOUBLE_EQ(angle_of_deg({-1, 0}), 180.0);
  EXPECT_DOUBLE_EQ(turn_deg({1, 0}, {1, 1}), 45.0);
  EXPECT_DOUBLE_EQ(turn_deg({0, 1}, {1, 0}), -90.0);
  EXPECT_NEAR(distance(direction_at(30.0), {0.8660254037844386, 0.5}), 0.0, 1e-15);
  EXPECT_NEAR(distance(rotated({2, 0}, 90.0), {0, 2}), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(degrees(radians(57.0)), 57.0);
}

}  // namespace
}  // namespace kerf
