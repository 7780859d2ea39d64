// Random closed contours of lines and arcs, tools of 0.001 to 10000 mm, both sides, types A and B, the three
// planes: the tool never cuts into any part of the contour, not only into what the interference check looks
// at; and where it reaches all of the contour, its path is the parallel, no more and no less.
//
// This holds for contours of which blocks that are not neighbours are farther away from each other than 2.5
// times the tool's radius, because the check does not see farther than to the neighbours.

#include <gtest/gtest.h>

#include "toolpath_closed_contours.hpp"

namespace kerf {
namespace {

using namespace toolpath_test;

constexpr double kLeast = 1e-3;    // mm
constexpr double kLargest = 1e4;   // mm
constexpr double kDeepest = 1e-3;  // mm

struct Count {
  int passed = 0;
  int cuts = 0;
  int worst_of = -1;
  double worst = 0.0;
};

Count count_cuts(InterferenceCheck check, int count) {
  std::mt19937 random(29);
  Count counted;
  for (int i = 0; i < count; ++i) {
    const Closed closed = random_closed(random, check, true, kLeast, kLargest);
    const ToolPath path = tool_path(closed.course, closed.cutting);
    if (path.alarm != nullptr) continue;
    ++counted.passed;
    double cut = 0.0;
    if (stays_out(closed, path, std::min(kDeepest, 0.6 * closed.cutting.tool), cut)) continue;
    ++counted.cuts;
    if (cut <= counted.worst) continue;
    counted.worst = cut;
    counted.worst_of = i;
  }
  std::printf("%d of %d without an alarm, %d cut\n", counted.passed, count, counted.cuts);
  return counted;
}

TEST(OffsetProperty, AvoidingCutsNowhereIntoAContourWithSmallBlocks) {
  const int count = contours(300);
  const Count counted = count_cuts(InterferenceCheck::avoid, count);
  EXPECT_EQ(counted.cuts, 0) << "deepest cut " << counted.worst << " mm, contour " << counted.worst_of;
  EXPECT_GT(counted.passed, count / 2);
}

TEST(OffsetProperty, AlarmsComeBeforeAnyCutIntoAContourWithSmallBlocks) {
  const int count = contours(300);
  const Count counted = count_cuts(InterferenceCheck::alarm, count);
  EXPECT_EQ(counted.cuts, 0) << "deepest cut " << counted.worst << " mm, contour " << counted.worst_of;
  EXPECT_GT(counted.passed, count / 2);
}

/// Farthest from the parallel: of points of the path from where they should be, and of points of the parallel
/// from the path. mm
double error_of(const Closed& closed, const ToolPath& path) {
  const double tool = closed.cutting.tool;
  double error = 0.0;
  for (const Way& way : path.ways) {
    const std::size_t own = way.block - 2;
    if (way.block < 3 || own + 1 >= closed.course.blocks.size()) continue;
    for (int i = 0; i <= 24; ++i) {
      const Vec2 point = point_at(way.shape, i / 24.0);
      double nearest = HUGE_VAL;
      bool at_corner = false;
      for (const Block& block : closed.ring) {
        const double away = distance_from(block, point);
        if (away >= nearest) continue;
        nearest = away;
        const double part = nearest_part(block, point);
        at_corner = part <= 1e-9 || part >= 1.0 - 1e-9;
      }
      const double farthest = at_corner ? std::sqrt(2.0) * tool : tool;
      error = std::max({error, tool - nearest, nearest - farthest});
    }
  }
  for (const Block& block : closed.ring) {
    for (int i = 1; i < 32; ++i) {
      const Vec2 point = beside(block, i / 32.0, left_mm(closed.cutting));
      if (distance_from(closed.ring, point) < (1.0 - 1e-9) * tool) continue;
      double nearest = HUGE_VAL;
      for (const Way& way : path.ways) nearest = std::min(nearest, distance_from(way.shape, point));
      error = std::max(error, nearest);
    }
  }
  return error;
}

/// DGSHAPE joins inner angles of up to 1 degree straight, and cuts.
bool has_reversal(const Contour& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (std::abs(turn_between(ring[i], ring[(i + 1) % ring.size()])) >= 179.0) return true;
  return false;
}

// Blocks that are 2.5 times the radius apart leave room for the tool at every inner corner.
TEST(OffsetProperty, AToolThatReachesEverythingRunsOnTheParallel) {
  static constexpr InterferenceCheck kChecks[] = {InterferenceCheck::none, InterferenceCheck::alarm,
                                                  InterferenceCheck::avoid};
  const int count = contours(300);
  std::mt19937 random(37);
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    Closed closed = random_closed(random, kChecks[i % 3], false, kLeast, kLargest);
    closed.cutting.dgshape = i % 6 == 0 && !has_reversal(closed.ring);
    const ToolPath path = tool_path(closed.course, closed.cutting);
    ASSERT_EQ(path.alarm, nullptr) << "contour " << i << ", block " << path.alarm_block;
    const double error = error_of(closed, path);
    worst = std::max(worst, error / closed.cutting.tool);
    EXPECT_LT(error, 2e-6 + 1e-9 * closed.cutting.tool)
        << "contour " << i << ", tool " << closed.cutting.tool;
  }
  std::printf("%d contours, worst error %.3g of the radius\n", count, worst);
}

}  // namespace
}  // namespace kerf
