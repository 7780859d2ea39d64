// Contours with features smaller than the tool, and all of their blocks seen together: the tool never cuts
// into any of them, or there is an alarm before it does.

#include <gtest/gtest.h>

#include "toolpath_closed_contours.hpp"
#include "toolpath_rough_contours.hpp"

namespace kerf {
namespace {

using namespace toolpath_test;

constexpr double kDeepest = 0.001;    // mm
constexpr double kFarthest = 1.4143;  // radii: where an outer corner of 90 degrees turns

Cutting random_omron(std::mt19937& random, InterferenceCheck check, double tool) {
  Cutting cutting = random_cutting(random, check, tool);
  cutting.sees_ahead = true;
  cutting.type = StartType::A;
  return cutting;
}

/// What a path does beside its contour.
struct Worst {
  double cut = 0.0;   ///< mm, into any block
  double away = 0.0;  ///< radii, from the nearest block
};

Worst worst_of(const ToolPath& path, const Course& course, double tool) {
  Worst worst;
  for (const Way& way : path.ways) {
    if (!is_of_contour(way, course)) continue;
    for (int i = 0; i <= 24; ++i) {
      const double near = distance_from(course.blocks, point_at(way.shape, i / 24.0));
      worst.cut = std::max(worst.cut, tool - near);
      worst.away = std::max(worst.away, near / tool);
    }
  }
  return worst;
}

struct Count {
  int passed = 0;
  int other_alarms = 0;
  int cuts = 0;
  int strays = 0;
  int worst_of = -1;
  double worst = 0.0;
};

Count count_cuts(InterferenceCheck check, int count) {
  std::mt19937 random(1913);
  Count counted;
  for (int i = 0; i < count; ++i) {
    const double tool = magnitude_between(random, 0.1, 100);
    const Cutting cutting = random_omron(random, check, tool);
    const Course course = random_rough(random, cutting);
    const ToolPath path = tool_path(course, cutting);
    counted.passed += path.alarm == nullptr ? 1 : 0;
    counted.other_alarms += path.alarm != nullptr && path.alarm != &kInterference ? 1 : 0;
    // In front of an alarm, too.
    const Worst worst = worst_of(path, course, tool);
    if (worst.cut > counted.worst) {
      counted.worst = worst.cut;
      counted.worst_of = i;
    }
    counted.cuts += worst.cut > kDeepest ? 1 : 0;
    counted.strays += worst.away > kFarthest ? 1 : 0;
  }
  std::printf("%d of %d without an alarm, %d with another one; deepest cut %.3g mm (contour %d), %d stray\n",
              counted.passed, count, counted.other_alarms, counted.worst, counted.worst_of, counted.strays);
  return counted;
}

TEST(OvercutProperty, PreventionCutsIntoNothing) {
  const int count = contours(2000);
  const Count counted = count_cuts(InterferenceCheck::avoid, count);
  EXPECT_EQ(counted.cuts, 0) << "deepest cut " << counted.worst << " mm, contour " << counted.worst_of;
  EXPECT_EQ(counted.strays, 0) << "the tool leaves the contour";
  EXPECT_GT(counted.passed, count * 3 / 4) << "too many contours give an alarm";
}

TEST(OvercutProperty, DetectionStopsBeforeAnythingIsCut) {
  const int count = contours(2000);
  const Count counted = count_cuts(InterferenceCheck::alarm, count);
  EXPECT_EQ(counted.cuts, 0) << "deepest cut " << counted.worst << " mm, contour " << counted.worst_of;
  EXPECT_GT(counted.passed, count / 20) << "too many contours give an alarm to prove anything";
}

// What is looked for is there when nobody looks, and neighbours alone do not show it.
TEST(OvercutProperty, WithoutTheCheckMostContoursAreCut) {
  const int count = contours(500);
  EXPECT_GT(count_cuts(InterferenceCheck::none, count).cuts, count / 2);
}

// Around closed contours the tool crosses its own run-on, and comes back to where it began.
TEST(OvercutProperty, NothingIsWrongWithAClosedContour) {
  std::mt19937 random(7);
  const int count = contours(500);
  for (int i = 0; i < count; ++i) {
    const InterferenceCheck check = i % 2 == 0 ? InterferenceCheck::alarm : InterferenceCheck::avoid;
    Closed closed = random_closed(random, check, false, 0.1, 100);
    closed.cutting.sees_ahead = true;
    closed.cutting.type = StartType::A;
    const ToolPath path = tool_path(closed.course, closed.cutting);
    ASSERT_EQ(path.alarm, nullptr) << "contour " << i << ", block " << path.alarm_block;
    double deepest = 0.0;
    ASSERT_TRUE(stays_out(closed, path, kDeepest, deepest)) << "contour " << i << ": " << deepest << " mm";
  }
}

TEST(OvercutProperty, SmallBlocksOfAClosedContourAreLeftOut) {
  std::mt19937 random(7);
  const int count = contours(500);
  int passed = 0;
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    Closed closed = random_closed(random, InterferenceCheck::avoid, true, 0.1, 100);
    closed.cutting.sees_ahead = true;
    closed.cutting.type = StartType::A;
    const ToolPath path = tool_path(closed.course, closed.cutting);
    // An inner rounding may be too small for the tool, which cannot be prevented.
    refused += path.alarm == &kInterference ? 1 : 0;
    if (path.alarm != nullptr) continue;
    ++passed;
    double deepest = 0.0;
    ASSERT_TRUE(stays_out(closed, path, kDeepest, deepest)) << "contour " << i << ": " << deepest << " mm";
  }
  std::printf("%d of %d without an alarm\n", passed, count);
  EXPECT_LE(refused, count / 500);
  EXPECT_GT(passed, count / 2);
}

}  // namespace
}  // namespace kerf
