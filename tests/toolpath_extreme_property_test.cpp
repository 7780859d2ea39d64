// Extreme numbers: joints that are all but tangent, exact reversals and almost exact ones, lines and arcs
// from 0.0001 mm to 10 m, tools from 0.001 mm to 10 m, in any mixture. Whatever comes out is a path of finite
// numbers that goes on where it ended, or an alarm; and where the interference check looks, the path stays
// near the contour.

#include <gtest/gtest.h>

#include "toolpath_contours.hpp"

namespace kerf {
namespace {

using namespace toolpath_test;

constexpr double kShortest = 1e-4;  // mm
constexpr double kLongest = 1e4;    // mm

/// Degrees between the end of a block and the start of the next.
double extreme_turn(std::mt19937& random) {
  const double sign = between(random, 0, 1) < 0.5 ? -1.0 : 1.0;
  switch (random() % 5) {
    case 0:
      return sign * magnitude_between(random, 1e-9, 1.0);
    case 1:
      return sign * (180.0 - magnitude_between(random, 1e-9, 1.0));
    case 2:
      return 180.0;
    case 3:
      return 0.0;
    default:
      return between(random, -180, 180);
  }
}

Course extreme_chain(std::mt19937& random) {
  Course course;
  Vec2 at{between(random, -1, 1) * kLongest, between(random, -1, 1) * kLongest};
  Vec2 along = direction_at(between(random, -180, 180));
  course.before = at - magnitude_between(random, kShortest, kLongest) * along;
  const int count = static_cast<int>(between(random, 2, 9));
  while (static_cast<int>(course.blocks.size()) < count) {
    const double turn = extreme_turn(random);
    along = turn == 180.0 ? -along : rotated(along, turn);
    const double size = magnitude_between(random, kShortest, kLongest);
    if (between(random, 0, 1) < 0.5) {
      course.blocks.push_back(line(at, at + size * along));
    } else {
      const double side = between(random, 0, 1) < 0.5 ? -1.0 : 1.0;
      const double sweep = between(random, 0, 1) < 0.5
                               ? between(random, 1, 359)
                               : degrees(magnitude_between(random, kShortest, size) / size);
      course.blocks.push_back(arc_around(at, at + side * size * left_of(along), side * sweep));
      along = direction_of(course.blocks.back(), 1.0);
    }
    at = course.blocks.back().end;
  }
  const Vec2 away = rotated(along, extreme_turn(random));
  course.behind = at + magnitude_between(random, kShortest, kLongest) * away;
  return course;
}

bool is_finite(Vec2 point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

/// How far a point of the path is from the contour and from where the tool comes and goes at most. mm
double farthest_from(const Course& course, const ToolPath& path) {
  Contour all = course.blocks;
  all.push_back(line(course.before, all.front().start));
  all.push_back(line(course.blocks.back().end, course.behind));
  double farthest = 0.0;
  for (const Way& way : path.ways) {
    for (int i = 0; i <= 12; ++i)
      farthest = std::max(farthest, distance_from(all, point_at(way.shape, i / 12.0)));
  }
  return farthest;
}

/// By how much the pieces of a path miss each other, and arcs their own ends. mm
double gaps_of(const ToolPath& path) {
  double gap = 0.0;
  for (std::size_t i = 0; i < path.ways.size(); ++i) {
    const Block& shape = path.ways[i].shape;
    gap = std::max(gap, distance(point_at(shape, 1.0), shape.end));
    if (i > 0) gap = std::max(gap, distance(path.ways[i - 1].shape.end, shape.start));
  }
  return gap;
}

void check_chains(InterferenceCheck check, double farthest_radii, bool dgshape = false) {
  const int count = contours(2000);
  std::mt19937 random(59);
  int alarms = 0;
  double farthest = 0.0;
  double gap = 0.0;
  for (int i = 0; i < count; ++i) {
    const double tool = magnitude_between(random, 1e-3, 1e4);
    const Course course = extreme_chain(random);
    Cutting cutting = random_cutting(random, check, tool);
    cutting.dgshape = dgshape;
    const ToolPath path = tool_path(course, cutting);
    alarms += path.alarm != nullptr ? 1 : 0;
    for (const Way& way : path.ways) {
      ASSERT_TRUE(is_finite(way.shape.start) && is_finite(way.shape.end)) << "contour " << i;
      if (!way.shape.arc) continue;
      ASSERT_TRUE(is_finite(way.shape.center) && std::isfinite(way.shape.sweep_deg)) << "contour " << i;
      ASSERT_LE(std::abs(way.shape.sweep_deg), 360.0) << "contour " << i;
    }
    const double away = (farthest_from(course, path) - 1e-3) / tool;
    EXPECT_LE(away, farthest_radii) << "contour " << i << ", tool " << tool;
    farthest = std::max(farthest, away);
    // Where arcs of less than a thousandth of a millimetre meet beside a tool of metres, rounding carries
    // far.
    EXPECT_LE(gaps_of(path), 1e-5 + 1e-6 * tool) << "contour " << i << ", tool " << tool;
    gap = std::max(gap, gaps_of(path));
  }
  EXPECT_LT(alarms, count * 9 / 10);
  std::printf("%d of %d with an alarm, farthest %.3g radii, gaps up to %.2g mm\n", alarms, count, farthest,
              gap);
}

TEST(ExtremeProperty, WithAlarms) {
  check_chains(InterferenceCheck::alarm, 2.0);
}
TEST(ExtremeProperty, Avoiding) {
  check_chains(InterferenceCheck::avoid, 2.0);
}
// An inner corner is where the parallels meet, 1 / tan(0.0005 degrees) = 1.15e5 radii away at most: joints
// nearer to an exact reversal are taken for one.
TEST(ExtremeProperty, WithoutTheCheck) {
  check_chains(InterferenceCheck::none, 1.2e5);
}
// With angles of up to 1 degree joined straight: 1 / tan(0.5 degrees).
TEST(ExtremeProperty, WithTheRulesOfDgshape) {
  check_chains(InterferenceCheck::none, 115.0, true);
}

// Two acute outer corners with all their points become known at once: two blocks of four moves and the one
// that leads away, all of them held back until then.
TEST(ExtremeProperty, TheLongestCorners) {
  const Block first = arc_around({0, 0}, {0, -50}, -30.0);
  const Vec2 along = rotated(direction_of(first, 1.0), -130.0);
  const Block second = arc_around(first.end, first.end - 50.0 * left_of(along), -30.0);
  const Vec2 away = rotated(direction_of(second, 1.0), -130.0);
  const Course course{{first, second}, {-50, 5}, second.end + 50.0 * away};
  const ToolPath path =
      tool_path(course, {Side::left, 5.0, InterferenceCheck::avoid, StartType::B, kPlaneXY});
  EXPECT_EQ(path.alarm, nullptr);
  std::vector<std::size_t> blocks;
  for (const Way& way : path.ways) blocks.push_back(way.block);
  EXPECT_EQ(blocks, (std::vector<std::size_t>{1, 2, 3, 3, 3, 3, 4, 4, 4, 4}));
  EXPECT_LE(gaps_of(path), 1e-9);
}

}  // namespace
}  // namespace kerf
