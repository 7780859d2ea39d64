#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "report/drawing_scale.hpp"
#include "report/move_geometry.hpp"
#include "report_test_support.hpp"

namespace kerf {
namespace {

using report_test::arc_xy;
using report_test::at;
using report_test::straight;
using report_test::timed_moves;

constexpr MoveMode kRapid = MoveMode::rapid;
constexpr MoveMode kFeed = MoveMode::linear;

TEST(ReportMoveGeometry, PositionOnArcs) {
  const Move quarter = arc_xy(at(10, 0, 0), at(0, 10, 4), 0, 0, 90);
  const AxisVector middle = position_at(quarter, 0.5);
  EXPECT_NEAR(middle[Axis::X], 10.0 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(middle[Axis::Y], 10.0 * std::sqrt(0.5), 1e-12);
  EXPECT_DOUBLE_EQ(middle[Axis::Z], 2.0);
  EXPECT_EQ(position_at(quarter, 1.0), quarter.end);
  EXPECT_EQ(position_at(quarter, 0.0), quarter.start);
  const AxisVector opposite = position_at(arc_xy(at(10, 0, 0), at(10, 0, 0), 0, 0, -360), 0.5);
  EXPECT_NEAR(opposite[Axis::X], -10.0, 1e-12);
  EXPECT_NEAR(opposite[Axis::Y], 0.0, 1e-12);
}

TEST(ReportMoveGeometry, RadiusGoesEvenlyFromStartToEnd) {
  const Move spiral = arc_xy(at(10, 0, 0), at(-12, 0, 0), 0, 0, 180);
  EXPECT_NEAR(position_at(spiral, 0.5)[Axis::Y], 11.0, 1e-12);
}

// Positive sweep is counter-clockwise seen from the positive third axis: Y towards the viewer in X-Z has Z to
// the right of X, so the picture with X to the right shows the other sense.
TEST(ReportMoveGeometry, SenseOfTurningOnThePicture) {
  Move move = arc_xy(at(10, 0, 0), at(0, 10, 0), 0, 0, 90);
  EXPECT_TRUE(appears_round(move, kPlanView));
  EXPECT_FALSE(appears_round(move, kElevationView));
  EXPECT_FALSE(turns_clockwise(move, kPlanView));
  move.plane = kPlaneZX;
  EXPECT_FALSE(appears_round(move, kPlanView));
  EXPECT_TRUE(appears_round(move, kElevationView));
  EXPECT_TRUE(turns_clockwise(move, kElevationView));
  move.arc.sweep = -90;
  EXPECT_FALSE(turns_clockwise(move, kElevationView));
  EXPECT_FALSE(appears_round(straight(kFeed, at(0, 0, 0), at(1, 0, 0)), kPlanView));
}

TEST(ReportMoveGeometry, ExtentsIncludeWhereArcsBulge) {
  const auto actions = timed_moves(
      {straight(kRapid, at(0, 0, 50), at(0, 0, 0)), arc_xy(at(0, 0, 0), at(20, 0, 0), 10, 0, -180)});
  const RunExtents extents = extents_of(actions);
  EXPECT_FALSE(extents.empty);
  EXPECT_NEAR(extents.all[index(Axis::Y)].high, 10.0, 1e-9);
  EXPECT_NEAR(extents.all[index(Axis::Y)].low, 0.0, 1e-9);
  EXPECT_EQ(extents.all[index(Axis::Z)].high, 50.0);
  EXPECT_EQ(extents.cutting[index(Axis::Z)].high, 0.0);
  EXPECT_TRUE(extents_of({}).empty);
  EXPECT_EQ(extents_of({}).all[0].length(), 0.0);
  EXPECT_EQ(extents_of({}).all[0].middle(), 0.0);
}

TEST(ReportMoveGeometry, MovesThatAreNotFiniteAreLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto actions = timed_moves({straight(kFeed, at(0, 0, 0), at(nan, 0, 0))});
  EXPECT_TRUE(extents_of(actions).empty);
  EXPECT_TRUE(find_holes(actions).empty());
}

TEST(ReportMoveGeometry, FindsDrilledHolesAndCountsPecksOnce) {
  const auto actions = timed_moves({
      straight(kRapid, at(0, 0, 10), at(5, 6, 10)),
      straight(kRapid, at(5, 6, 10), at(5, 6, 2)),
      straight(kFeed, at(5, 6, 2), at(5, 6, -4)),
      straight(kRapid, at(5, 6, -4), at(5, 6, 2)),
      straight(kFeed, at(5, 6, 2), at(5, 6, -8)),
      straight(kRapid, at(5, 6, -8), at(5, 6, 2)),
      straight(kRapid, at(5, 6, 2), at(15, 6, 2)),
      straight(kFeed, at(15, 6, 2), at(15, 6, -3)),
      straight(kFeed, at(15, 6, -3), at(15, 6, 2)),
  });
  const auto holes = find_holes(actions);
  ASSERT_EQ(holes.size(), 2U);
  EXPECT_EQ(holes[0].at.x, 5.0);
  EXPECT_EQ(holes[0].at.y, 6.0);
  EXPECT_EQ(holes[0].bottom, -8.0);
  EXPECT_EQ(holes[1].at.x, 15.0);
  EXPECT_EQ(holes[1].bottom, -3.0);
}

TEST(ReportMoveGeometry, APlungeBeforeAContourIsNoHole) {
  const auto actions = timed_moves({
      straight(kFeed, at(0, 0, 2), at(0, 0, -4)),
      straight(kFeed, at(0, 0, -4), at(10, 0, -4)),
      straight(kRapid, at(10, 0, -4), at(10, 0, 2)),
  });
  EXPECT_TRUE(find_holes(actions).empty());
  // Turning the part between feed and retraction is no drilling at one place either.
  const auto turned = timed_moves({
      straight(kFeed, at(0, 0, 2), at(0, 0, -4)),
      straight(kFeed, at(0, 0, -4), at(0, 0, -4, 90)),
      straight(kRapid, at(0, 0, -4, 90), at(0, 0, 2, 90)),
  });
  EXPECT_TRUE(find_holes(turned).empty());
}

TEST(ReportDrawingScale, RoundNumbers) {
  EXPECT_DOUBLE_EQ(round_up_125(3.0), 5.0);
  EXPECT_DOUBLE_EQ(round_up_125(5.0), 5.0);
  EXPECT_DOUBLE_EQ(round_up_125(0.06), 0.1);
  EXPECT_DOUBLE_EQ(round_up_125(1000.0), 1000.0);
  EXPECT_DOUBLE_EQ(round_down_125(3.0), 2.0);
  EXPECT_DOUBLE_EQ(round_down_125(99.0), 50.0);
  EXPECT_DOUBLE_EQ(round_down_125(0.01), 0.01);
}

TEST(ReportDrawingScale, TicksAreMultiplesWithinTheRange) {
  EXPECT_EQ(ticks_between(-3.0, 4.1, 2.0), (std::vector<double>{-2.0, 0.0, 2.0, 4.0}));
  const auto tenths = ticks_between(0.1, 0.3, 0.1);
  ASSERT_EQ(tenths.size(), 3U);  // 0.3 / 0.1 is less than 3 in binary
  EXPECT_NEAR(tenths[2], 0.3, 1e-12);
  EXPECT_LE(ticks_between(0.0, 1e9, 1.0).size(), 200U);
  EXPECT_EQ(tick_text(2.5, 0.5), "2.5");
  EXPECT_EQ(tick_text(20.0, 10.0), "20");
  EXPECT_EQ(tick_text(0.02, 0.01), "0.02");
}

}  // namespace
}  // namespace kerf
