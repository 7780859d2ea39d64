#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "execute/watched.hpp"
#include "report/programmed_path.hpp"
#include "report/svg_direction.hpp"
#include "report/svg_plot.hpp"
#include "report/svg_strokes.hpp"
#include "report_test_support.hpp"

namespace kerf {
namespace {

using report_test::arc_xy;
using report_test::at;
using report_test::count_of;
using report_test::machine_with;
using report_test::origin_of;
using report_test::straight;
using report_test::timed_moves;
using report_test::xml_fault;

constexpr MoveMode kRapid = MoveMode::rapid;
constexpr MoveMode kFeed = MoveMode::linear;

Move compensated(Move move, double amount) {
  move.compensation = {Side::left, amount};
  return move;
}

/// A move at an angle of the tool (the machine's A) that goes evenly from one to the other.
Move pointing(AxisVector start, AxisVector end, double from_deg, double to_deg) {
  start[Axis::A] = from_deg;
  end[Axis::A] = to_deg;
  Move move = straight(kFeed, start, end);
  move.normal_line = Side::left;
  return move;
}

/// One picture unit a millimetre with the machine's origin at its lower left corner: x, 100 - y.
ViewFrame unit_frame(View view) {
  ViewFrame frame;
  frame.view = view;
  frame.width = frame.height = 100.0;
  return frame;
}

ViewStrokes strokes_in(View view, const std::vector<Move>& moves, const DrawingExtras& extras = {}) {
  return strokes_of(timed_moves(moves), extras, unit_frame(view), 1'000'000);
}

ProgrammedPath programmed_of(const std::vector<Move>& moves) {
  ProgrammedPath path;
  std::uint32_t line = 0;
  for (const Move& move : moves) path.add({origin_of(++line), move});
  return path;
}

TEST(ReportSweptBand, IsAsWideAsTheToolOfCuttingMovesInForce) {
  const Move cut = straight(kFeed, at(10, 20, 0), at(40, 20, 0));
  EXPECT_EQ(swept_radius(compensated(cut, 6.0)), 6.0);
  EXPECT_EQ(swept_radius(compensated(cut, -6.0)), 6.0);  // a negative amount changes the side, not the tool
  EXPECT_EQ(swept_radius(cut), 0.0);
  EXPECT_EQ(swept_radius(compensated(straight(kRapid, cut.start, cut.end), 6.0)), 0.0);
}

TEST(ReportSweptBand, FollowsTheToolCentreTrueToScale) {
  const std::vector<Move> moves{compensated(straight(kFeed, at(10, 20, 0), at(40, 20, 0)), 6.0),
                                compensated(arc_xy(at(40, 20, 0), at(50, 30, 0), 40, 30, 90), 6.0),
                                straight(kFeed, at(50, 30, 0), at(90, 30, 0))};
  const ViewStrokes plan = strokes_in(kPlanView, moves);
  ASSERT_EQ(plan.swept.size(), 1U);
  EXPECT_EQ(plan.swept[0].width, 12.0);
  EXPECT_EQ(plan.swept[0].data, "M10 80l30 0a10 10 0 0 0 10-10");
  EXPECT_EQ(plan.line, "M10 80l30 0M50 70l40 0");
  // Half a picture unit a millimetre: the band is half as wide.
  ViewFrame half = unit_frame(kPlanView);
  half.x_scale = half.y_scale = 0.5;
  EXPECT_EQ(strokes_of(timed_moves(moves), {}, half, 1'000'000).swept.at(0).width, 6.0);
}

TEST(ReportSweptBand, ToolsOfDifferentWidthsAreBandsOfTheirOwn) {
  const ViewStrokes plan =
      strokes_in(kPlanView, {compensated(straight(kFeed, at(10, 20, 0), at(40, 20, 0)), 6.0),
                             compensated(straight(kFeed, at(40, 50, 0), at(10, 50, 0)), 1.5)});
  ASSERT_EQ(plan.swept.size(), 2U);
  EXPECT_EQ(plan.swept[0].width, 3.0);
  EXPECT_EQ(plan.swept[0].data, "M40 50l-30 0");
  EXPECT_EQ(plan.swept[1].width, 12.0);
}

// A cylinder seen from its side sweeps no band of this width.
TEST(ReportSweptBand, IsDrawnOnlyWhereTheViewLooksAtThePlane) {
  Move move = compensated(straight(kFeed, at(10, 20, 30), at(40, 20, 30)), 6.0);
  EXPECT_TRUE(strokes_in(kElevationView, {move}).swept.empty());
  EXPECT_TRUE(strokes_in({Axis::X, Axis::A}, {move}).swept.empty());
  move.plane = kPlaneZX;
  EXPECT_TRUE(strokes_in(kPlanView, {move}).swept.empty());
  EXPECT_EQ(strokes_in(kElevationView, {move}).swept.at(0).data, "M10 70l30 0");
}

// Z drawn twice as large: laid out true to scale (y = 100 - 30), then stretched about the lower edge, y =
// 100.
TEST(ReportSweptBand, IsStretchedWithTheView) {
  Move move = compensated(straight(kFeed, at(10, 20, 30), at(40, 20, 30)), 6.0);
  move.plane = kPlaneZX;
  ViewFrame frame = unit_frame(kElevationView);
  frame.y_scale = 2.0;
  const ViewStrokes strokes = strokes_of(timed_moves({move}), {}, frame, 1'000'000);
  EXPECT_EQ(strokes.line, "M10 40l30 0");
  std::string svg;
  append_strokes(svg, frame, strokes);
  EXPECT_NE(svg.find("<g class=\"swept\" transform=\"matrix(1 0 0 2 0 -100)\">\n"
                     "<path stroke-width=\"12\" d=\"M10 70l30 0\"/>\n</g>\n"),
            std::string::npos)
      << svg;
  EXPECT_LT(svg.find("class=\"swept\""), svg.find("class=\"line\""));
}

TEST(ReportToolDirection, IsTheAngleOfTheAxisFromTheFirstAxisOfThePlane) {
  Move move = pointing(at(10, 20, 0), at(50, 20, 0), 90, 180);
  const auto expect_at = [&](double fraction, View view, double x, double y) {
    const Point2 direction = tool_direction(move, Axis::A, fraction, view);
    EXPECT_NEAR(direction.x, x, 1e-12);
    EXPECT_NEAR(direction.y, y, 1e-12);
  };
  expect_at(0.0, kPlanView, 0.0, 1.0);
  expect_at(0.5, kPlanView, -std::sqrt(0.5), std::sqrt(0.5));
  expect_at(1.0, kPlanView, -1.0, 0.0);
  move.normal_zero = 90.0;
  expect_at(0.0, kPlanView, 1.0, 0.0);
  // The first axis of Z-X goes up on the elevation, the second to the right.
  move.plane = kPlaneZX;
  expect_at(0.0, kElevationView, 0.0, 1.0);
  expect_at(1.0, kElevationView, 1.0, 0.0);
}

// 48 units hold two spacings of 24: ticks of 11 units at 12 and 36, upwards for 90 degrees.
TEST(ReportToolDirection, TicksStandEvenlyOnAMove) {
  const Move along = pointing(at(10, 20, 0), at(58, 20, 0), 90, 90);
  const ViewStrokes plan = strokes_in(kPlanView, {along}, {nullptr, Axis::A});
  EXPECT_EQ(plan.direction, "M22 80l0-11M46 80l0-11");
  EXPECT_EQ(strokes_in(kElevationView, {along}, {nullptr, Axis::A}).direction, "");
  EXPECT_EQ(strokes_in(kPlanView, {along}).direction, "");
  Move free = along;
  free.normal_line = Side::none;
  EXPECT_EQ(strokes_in(kPlanView, {free}, {nullptr, Axis::A}).direction, "");
}

TEST(ReportToolDirection, TicksStandAtBothEndsOfATurn) {
  const Move turn = pointing(at(50, 50, 0), at(50, 50, 0), 0, 90);
  EXPECT_EQ(strokes_in(kPlanView, {turn}, {nullptr, Axis::A}).direction, "M50 50l11 0M50 50l0-11");
}

// 240 moves of 0.4 units, 96 units together: a tick every 24 of them, as on one long move.
TEST(ReportToolDirection, ShortMovesShareTheTicks) {
  std::vector<Move> moves;
  for (int i = 0; i < 240; ++i) moves.push_back(pointing(at(0.4 * i, 0, 0), at(0.4 * (i + 1), 0, 0), 90, 90));
  const ViewStrokes plan = strokes_in(kPlanView, moves, {nullptr, Axis::A});
  EXPECT_EQ(count_of(plan.direction, "M"), 4U) << plan.direction;
}

TEST(ReportProgrammedPath, KeepsWhatCompensationChanges) {
  const std::vector<Move> program{
      straight(kRapid, at(0, 0, 5), at(5, 5, 5)),
      compensated(straight(kFeed, at(5, 5, 5), at(10, 20, 5)), 6.0),
      compensated(straight(kFeed, at(10, 20, 5), at(10, 20, -2)), 6.0),  // down: nothing to be seen
      compensated(arc_xy(at(10, 20, -2), at(20, 30, -2), 10, 30, 90), 6.0),
      straight(kFeed, at(20, 30, -2), at(20, 30, 5)),  // still beside the path
      straight(kFeed, at(20, 30, 5), at(40, 30, 5)),   // leads back to it
      straight(kRapid, at(40, 30, 5), at(0, 0, 5)),
  };
  const ProgrammedPath path = programmed_of(program);
  ASSERT_EQ(path.size(), 3U);
  EXPECT_FALSE(path.truncated());
  EXPECT_EQ(path[0].end, at(10, 20, 5));
  EXPECT_EQ(path[1].arc.sweep, 90.0);
  EXPECT_EQ(path[1].arc.center, program[3].arc.center);
  EXPECT_EQ(path[2].start, at(20, 30, 5));
  EXPECT_EQ(path[2].end, at(40, 30, 5));
  const ViewStrokes plan = strokes_in(kPlanView, {}, {&path, std::nullopt});
  EXPECT_EQ(plan.programmed, "M5 95l5-15a10 10 0 0 0 10-10l20 0");
  EXPECT_EQ(strokes_in(kElevationView, {}, {&path, std::nullopt}).programmed, "");
}

TEST(ReportProgrammedPath, WithoutAnAmountNothingIsBeside) {
  const std::vector<Move> program{compensated(straight(kFeed, at(0, 0, 0), at(10, 0, 0)), 0.0),
                                  straight(kFeed, at(10, 0, 0), at(20, 0, 0))};
  EXPECT_EQ(programmed_of(program).size(), 0U);
}

TEST(ReportProgrammedPath, EndsWithTheRecord) {
  const Move move = compensated(straight(kFeed, at(0, 0, 0), at(10, 0, 0)), 1.0);
  ProgrammedPath path = programmed_of({move, move, move, move});  // blocks 1 to 4
  path.end_at(3);
  EXPECT_EQ(path.size(), 3U);
  path.end_at(7);
  EXPECT_EQ(path.size(), 3U);
}

TEST(ReportProgrammedPath, IsBoundedAndSaysSo) {
  const Move move = compensated(straight(kFeed, at(0, 0, 0), at(10, 0, 0)), 1.0);
  ProgrammedPath path;
  for (std::size_t i = 0; i < ProgrammedPath::kMost; ++i) path.add({origin_of(1), move});
  EXPECT_FALSE(path.truncated());
  path.add({origin_of(1), move});
  EXPECT_TRUE(path.truncated());
  EXPECT_EQ(path.size(), ProgrammedPath::kMost);
  RunRecord record;
  record.actions = timed_moves({move});
  const std::string svg =
      svg_plot(record, machine_with({Axis::X, Axis::Y}), {"part.nc", "kerf"}, {&path, {}});
  EXPECT_NE(svg.find("only the first part is drawn"), std::string::npos);
}

TEST(ReportCompensatedPlot, ShowsAndNamesOnlyWhatIsThere) {
  const Machine machine = machine_with({Axis::X, Axis::Y, Axis::Z, Axis::A});
  RunRecord record;
  const Move contour = compensated(straight(kFeed, at(0, 0, 0), at(60, 0, 0)), 4.0);
  record.actions = timed_moves({compensated(straight(kFeed, at(0, 4, 0), at(60, 4, 0)), 4.0)});
  const ProgrammedPath path = programmed_of({contour});
  const std::string svg = svg_plot(record, machine, {"part.nc", "kerf"}, {&path, Axis::A});
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_EQ(count_of(svg, ">programmed path<"), 1U);
  EXPECT_EQ(count_of(svg, ">swept by the tool<"), 1U);
  EXPECT_EQ(count_of(svg, ">where the tool points<"), 0U);
  EXPECT_EQ(count_of(svg, "class=\"programmed\""), 2U);  // plan and legend
  EXPECT_EQ(count_of(svg, "class=\"swept\""), 2U);

  record.actions = timed_moves({pointing(at(0, 0, 0), at(60, 0, 0), 90, 90)});
  const std::string knife = svg_plot(record, machine, {"part.nc", "kerf"}, {nullptr, Axis::A});
  EXPECT_EQ(xml_fault(knife), "");
  EXPECT_EQ(count_of(knife, ">where the tool points<"), 1U);
  EXPECT_EQ(count_of(knife, ">programmed path<"), 0U);
  EXPECT_EQ(count_of(knife, ">swept by the tool<"), 0U);
}

// The tool reaches from -4 to 64 and from 0 to 8, the contour lies on 0.
TEST(ReportCompensatedPlot, TheFrameHoldsTheToolAndTheContour) {
  const auto actions = timed_moves({compensated(straight(kFeed, at(0, 4, 0), at(60, 4, 0)), 4.0)});
  const ProgrammedPath path = programmed_of({compensated(straight(kFeed, at(0, -3, 0), at(60, -3, 0)), 4.0)});
  const RunExtents extents = extents_of(actions, {&path, std::nullopt});
  EXPECT_EQ(extents.drawn[index(Axis::X)].low, -4.0);
  EXPECT_EQ(extents.drawn[index(Axis::X)].high, 64.0);
  EXPECT_EQ(extents.drawn[index(Axis::Y)].low, -3.0);
  EXPECT_EQ(extents.drawn[index(Axis::Y)].high, 8.0);
  EXPECT_EQ(extents.cutting[index(Axis::Y)].low, 4.0);
}

struct TwoActions {
  Action actions[2];
  int given = 0;
  bool recovered = false;
  const Action* next() { return given < 2 ? &actions[given++] : nullptr; }
  void recover() { recovered = true; }
};

TEST(ExecuteWatched, HandsActionsThroughAndShowsThem) {
  TwoActions upstream;
  Watched<TwoActions> watched(upstream);
  EXPECT_EQ(watched.next(), &upstream.actions[0]);
  std::vector<const Action*> seen;
  watched.watch([&](const Action& action) { seen.push_back(&action); });
  EXPECT_EQ(watched.next(), &upstream.actions[1]);
  EXPECT_EQ(watched.next(), nullptr);
  EXPECT_EQ(seen, (std::vector<const Action*>{&upstream.actions[1]}));
  watched.recover();
  EXPECT_TRUE(upstream.recovered);
}

}  // namespace
}  // namespace kerf
