#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "report/svg_plot.hpp"
#include "report/svg_strokes.hpp"
#include "report/svg_view.hpp"
#include "report_test_support.hpp"

namespace kerf {
namespace {

using report_test::arc_xy;
using report_test::at;
using report_test::count_of;
using report_test::machine_with;
using report_test::straight;
using report_test::timed_moves;
using report_test::xml_fault;

const Machine kMachine = machine_with({Axis::X, Axis::Y, Axis::Z, Axis::A});

std::string plot_of(const std::vector<Move>& moves, std::string_view title = "part.nc") {
  RunRecord record;
  record.summary.axes = kMachine.axes;
  record.actions = timed_moves(moves);
  return svg_plot(record, kMachine, {title, "kerf test"});
}

/// A frame of one picture unit a millimetre with the machine's origin at its lower left corner.
ViewFrame unit_frame(View view) {
  ViewFrame frame;
  frame.view = view;
  frame.width = frame.height = 100.0;
  return frame;
}

ViewStrokes strokes_in(View view, const std::vector<Move>& moves) {
  return strokes_of(timed_moves(moves), {}, unit_frame(view), 1'000'000);
}

// Places on the picture by hand: x to the right, y = 100 - machine Y.
TEST(ReportSvgView, StrokesOfEachKind) {
  const std::vector<Move> moves{
      straight(MoveMode::rapid, at(0, 0, 50), at(10, 20, 50)),
      straight(MoveMode::linear, at(10, 20, 50), at(40, 20, 10)),
      arc_xy(at(40, 20, 10), at(50, 30, 10), 40, 30, 90),
      arc_xy(at(50, 30, 10), at(60, 40, 10), 60, 30, -90),
  };
  const ViewStrokes plan = strokes_in(kPlanView, moves);
  EXPECT_EQ(plan.rapid, "M0 100l10-20");
  EXPECT_EQ(plan.line, "M10 80l30 0");
  EXPECT_EQ(plan.arc, "M40 80a10 10 0 0 0 10-10 10 10 0 0 1 10-10");
  const ViewStrokes elevation = strokes_in(kElevationView, moves);
  EXPECT_EQ(elevation.rapid, "M0 50l10 0");
  EXPECT_EQ(elevation.line, "M10 50l30 40");
  EXPECT_EQ(elevation.arc, "M40 90l20 0");  // seen from the side
}

TEST(ReportSvgView, AFullCircleIsSeveralArcsThatClose) {
  const ViewStrokes plan = strokes_in(kPlanView, {arc_xy(at(60, 50, 0), at(60, 50, 0), 50, 50, 360)});
  EXPECT_EQ(plan.arc, "M60 50a10 10 0 0 0-15-8.66 10 10 0 0 0 0 17.32 10 10 0 0 0 15-8.66");
}

TEST(ReportSvgView, ArcInZXTurnsTheOtherWayOnTheElevation) {
  // From Z+ to X+ about the origin (50, 50): a positive quarter in the plane Z-X.
  Move move = arc_xy(at(50, 0, 60), at(60, 0, 50), 50, 50, 90);
  move.plane = kPlaneZX;
  EXPECT_EQ(strokes_in(kElevationView, {move}).arc, "M50 40a10 10 0 0 1 10 10");
  EXPECT_EQ(strokes_in(kPlanView, {move}).arc, "M50 100l10 0");
}

TEST(ReportSvgPlot, IsWellFormedAndHasItsParts) {
  const std::string svg = plot_of({
      straight(MoveMode::rapid, at(0, 0, 20), at(10, 10, 20)),
      straight(MoveMode::linear, at(10, 10, 20), at(10, 10, -5), 100),
      straight(MoveMode::rapid, at(10, 10, -5), at(10, 10, 20)),
      straight(MoveMode::linear, at(10, 10, 20), at(80, 10, 0), 100),
      arc_xy(at(80, 10, 0), at(100, 30, 0), 80, 30, 90),
  });
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_NE(svg.find("viewBox=\"0 0 1000 "), std::string::npos);
  EXPECT_NE(svg.find("vector-effect:non-scaling-stroke"), std::string::npos);
  EXPECT_NE(svg.find(">X (mm)<"), std::string::npos);
  EXPECT_NE(svg.find(">Y (mm)<"), std::string::npos);
  EXPECT_NE(svg.find(">Z (mm)"), std::string::npos);
  EXPECT_NE(svg.find(">drilled hole (1)<"), std::string::npos);
  EXPECT_EQ(count_of(svg, "class=\"hole\""), 2U);   // one mark in the plan, one in the legend
  EXPECT_EQ(count_of(svg, "class=\"start\""), 3U);  // plan, elevation, legend
  EXPECT_EQ(count_of(svg, "class=\"end\""), 3U);
  EXPECT_NE(svg.find("20 mm<"), std::string::npos);  // scale bar: 898 units show 112 mm
  EXPECT_EQ(svg.find("unrolled"), std::string::npos);
}

TEST(ReportSvgPlot, TurningAxisIsShownUnrolled) {
  const std::string svg = plot_of({straight(MoveMode::linear, at(0, 0, 0, 0), at(50, 0, 0, 360), 100)});
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_NE(svg.find(">A (°), unrolled<"), std::string::npos);
  EXPECT_NE(svg.find("A  0.000 … 360.000  (360.000 °)"), std::string::npos);
}

TEST(ReportSvgPlot, NothingDividesByZero) {
  const AxisVector point = at(5, 5, 5);
  const std::vector<std::vector<Move>> runs{
      {},
      {straight(MoveMode::linear, point, point, 100)},
      {straight(MoveMode::linear, at(0, 0, 0), at(0, 0, -5), 100)},
      {straight(MoveMode::linear, at(0, 0, 0), at(0, 1000, 0), 100)},
      {straight(MoveMode::linear, at(-1e-7, 0, 0), at(1e-7, 0, 0), 100)},
      {straight(MoveMode::linear, at(-9999, -9999, -9999), at(9999, 9999, 9999), 100)},
      {straight(MoveMode::linear, at(0, 0, 0), at(std::numeric_limits<double>::quiet_NaN(), 0, 0), 100)},
      {straight(MoveMode::linear, at(0, 0, 0), at(std::numeric_limits<double>::infinity(), 0, 0), 100)},
  };
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string svg = plot_of(runs[i]);
    EXPECT_EQ(xml_fault(svg), "") << i;
    const std::string body = svg.substr(svg.find("</style>"));
    for (const std::string_view word : {"nan", "inf", "null"}) {
      EXPECT_EQ(body.find(word), std::string::npos) << i << ": " << word;
    }
  }
  EXPECT_NE(plot_of({}).find("nothing moves"), std::string::npos);
}

TEST(ReportSvgPlot, TitleCannotBecomeMarkup) {
  const std::string svg = plot_of({}, "</text><script>alert(1)</script>&\x01");
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

// 60,000 moves along 300 wavy passes, finer than the picture.
TEST(ReportSvgPlot, LongProgramsStaySmall) {
  std::vector<Move> moves;
  AxisVector last = at(0, 0, 0);
  for (int pass = 0; pass < 300; ++pass) {
    for (int i = 0; i <= 200; ++i) {
      const double x = pass % 2 == 0 ? i * 0.4 : 80.0 - i * 0.4;
      const AxisVector next = at(x, pass * 0.2, std::sin(x / 5.0) * std::cos(pass / 40.0));
      moves.push_back(straight(MoveMode::linear, last, next, 1000));
      last = next;
    }
  }
  const std::string svg = plot_of(moves);
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_LT(svg.size(), 1'000'000U);
  EXPECT_GT(svg.size(), 10'000U);
}

}  // namespace
}  // namespace kerf
