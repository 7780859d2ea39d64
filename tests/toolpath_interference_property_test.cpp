// Random chains of blocks, many of them shorter than the tool: with the interference check on "avoid" or
// "alarm" the tool never cuts into a block that the check looks at, or there is an alarm.

#include <gtest/gtest.h>

#include "toolpath/interference.hpp"
#include "toolpath_contours.hpp"

namespace kerf {
namespace {

using namespace toolpath_test;

constexpr double kDeepest = 0.001;  // mm

struct Count {
  int passed = 0;
  int cuts = 0;
  int worst_of = -1;
  double worst = 0.0;
};

Count count_cuts(InterferenceCheck check, int count) {
  std::mt19937 random(1913);
  Count counted;
  for (int i = 0; i < count; ++i) {
    const double tool = magnitude_between(random, 0.1, 1e4);
    const Course course = random_chain(random, tool);
    const ToolPath path = tool_path(course, random_cutting(random, check, tool));
    if (path.alarm != nullptr) continue;
    ++counted.passed;
    const double cut = deepest_cut_seen(path, course, tool);
    if (cut > counted.worst) {
      counted.worst = cut;
      counted.worst_of = i;
    }
    counted.cuts += cut > kDeepest ? 1 : 0;
  }
  std::printf("%d of %d without an alarm; deepest cut %.3g mm (chain %d)\n", counted.passed, count,
              counted.worst, counted.worst_of);
  return counted;
}

TEST(InterferenceProperty, AvoidingNeverCutsIntoWhatTheCheckSees) {
  const int count = contours(2000);
  const Count counted = count_cuts(InterferenceCheck::avoid, count);
  EXPECT_EQ(counted.cuts, 0) << "deepest cut " << counted.worst << " mm, chain " << counted.worst_of;
  EXPECT_GT(counted.passed, count / 2) << "too many chains give an alarm to prove anything";
}

TEST(InterferenceProperty, WithAlarmsNothingIsCutEither) {
  const int count = contours(2000);
  const Count counted = count_cuts(InterferenceCheck::alarm, count);
  EXPECT_EQ(counted.cuts, 0) << "deepest cut " << counted.worst << " mm, chain " << counted.worst_of;
  EXPECT_GT(counted.passed, count / 8) << "too many chains give an alarm to prove anything";
}

// What the tests above look for is there when nobody looks.
TEST(InterferenceProperty, WithoutTheCheckManyChainsAreCut) {
  const int count = contours(2000);
  EXPECT_GT(count_cuts(InterferenceCheck::none, count).cuts, count / 10);
}

// Two of the rare chains whose changed path would still cut: beside a tool of 10 mm on the left, an arc turns
// back on the one before it.
TEST(InterferenceProperty, WhatCannotBeAvoidedIsAnAlarm) {
  const auto after = [](const Block& block, double turn_deg, double radius, double sweep_deg) {
    const double side = sweep_deg < 0.0 ? -1.0 : 1.0;
    const Vec2 along = rotated(direction_of(block, 1.0), turn_deg);
    return arc_around(block.end, block.end + side * radius * left_of(along), sweep_deg);
  };
  const auto check = [&](double turn1, const Vec2& arc1, double turn2, const Vec2& arc2, double turn3) {
    Course course{{line({0, 0}, {60, 0})}, {-50, 0}, {}};
    course.blocks.push_back(after(course.blocks.back(), turn1, arc1.x, arc1.y));
    course.blocks.push_back(after(course.blocks.back(), turn2, arc2.x, arc2.y));
    const Vec2 at = course.blocks.back().end;
    const Vec2 along = rotated(direction_of(course.blocks.back(), 1.0), turn3);
    course.blocks.push_back(line(at, at + 60.0 * along));
    course.behind = at + 110.0 * along;
    Cutting cutting{Side::left, 10.0, InterferenceCheck::none, StartType::A, kPlaneXY};
    EXPECT_GT(deepest_cut_seen(tool_path(course, cutting), course, 10.0), 1.0);
    for (const InterferenceCheck way : {InterferenceCheck::alarm, InterferenceCheck::avoid}) {
      cutting.check = way;
      EXPECT_EQ(tool_path(course, cutting).alarm, &kInterference);
    }
  };
  check(35, {28, -105}, -85, {17, -105}, -30);
  check(-50, {28, -5}, -70, {23, -145}, -90);
}

// Where one block has been avoided and nothing is left of the next arc, that arc's path meets no other.
TEST(InterferenceProperty, NothingMeetsAPathThatIsGone) {
  OffsetSegment arc = offset_of(curved({0, 1}, {1, 0}, {0, 0}, 1.0, -90.0), 2.0);
  arc.offset = straight({3, 3}, {3, 3});
  const PlanarSegment line = straight({0, 0}, {6, 0});
  const PlanarSegment bow = curved({0, 0}, {10, 10}, {0, 10}, 10.0, 90.0);
  EXPECT_FALSE(avoiding_point(arc, {3, 3}, offset_of(line, 2.0)));
  EXPECT_FALSE(avoiding_point(arc, {3, 3}, offset_of(bow, 2.0)));
}

}  // namespace
}  // namespace kerf
