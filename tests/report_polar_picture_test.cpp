// Moves of a polar plane in pictures and events: figures on the work, worked out by hand.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "polar_program.hpp"
#include "report/html_report.hpp"
#include "report/json_lines.hpp"
#include "report/move_geometry.hpp"
#include "report/polar_picture.hpp"
#include "report/programmed_path.hpp"
#include "report/svg_plot.hpp"
#include "report_test_support.hpp"

namespace kerf {
namespace {

using polar_test::passed;
using polar_test::PolarProgram;
using report_test::count_of;
using report_test::xml_fault;

/// A linear axis with its centre at 100, C at 30 degrees: around a square corner, and an arc over the centre
/// line.
PolarProgram corner_and_arc() {
  PolarProgram program(20.0, 100.0, 30.0);
  program.to(20.0, 10.0).to(-20.0, 10.0).arc(-20.0, 0.0, 180.0);
  return program;
}

std::vector<TimedAction> timed(const std::vector<Action>& actions) {
  std::vector<TimedAction> out;
  for (const Action& action : actions) out.push_back({action, 0.0, 1.0, 1.0, 1.0});
  return out;
}

void expect_at(const AxisVector& position, double x, double y) {
  EXPECT_NEAR(position[Axis::X], x, 1e-9);
  EXPECT_NEAR(position[Axis::Y], y, 1e-9);
}

TEST(ReportPolarPicture, AMoveOfTheAxesBecomesItsFigure) {
  const auto actions = passed(corner_and_arc().actions());
  ASSERT_EQ(actions.size(), 3U);
  const Move line = as_figure(std::get<Move>(actions[1].what));
  expect_at(line.start, 120.0, 10.0);
  expect_at(line.end, 80.0, 10.0);
  EXPECT_EQ(line.plane, kPlaneXY);
  EXPECT_EQ(line.polar.form, PolarForm::none);
  expect_at(position_at(line, 0.5), 100.0, 10.0);
  const Move arc = as_figure(std::get<Move>(actions[2].what));
  expect_at(arc.end, 80.0, -10.0);
  EXPECT_EQ(arc.arc.center[0], 80.0);
  EXPECT_EQ(arc.arc.center[1], 0.0);
  expect_at(position_at(arc, 0.5), 70.0, 0.0);
  // The rotary axis keeps its angle: 30 and that of (-20, -10), on over half a turn.
  EXPECT_NEAR(arc.end[Axis::C], 30.0 + 180.0 + std::atan2(10.0, 20.0) * 180.0 / 3.14159265358979, 1e-6);
}

TEST(ReportPolarPicture, TheFigureLiesBesideWhereTheThirdAxisStands) {
  PolarProgram program(20.0);
  program.to(20.0, 10.0);
  auto actions = passed(program.actions());
  Move& move = std::get<Move>(actions[0].what);
  move.start[Axis::Y] = move.end[Axis::Y] = -7.0;
  expect_at(as_figure(move).end, 20.0, 3.0);
}

TEST(ReportPolarPicture, EveryLinearAxisHasItsPlane) {
  Move move;
  move.polar.form = PolarForm::axes;
  const auto across = [&](Axis linear, Axis height) {
    move.polar.linear = linear;
    move.plane = {linear, Axis::C, height};
    return figure_axis(move);
  };
  EXPECT_EQ(across(Axis::X, Axis::Z), Axis::Y);
  EXPECT_EQ(across(Axis::Y, Axis::X), Axis::Z);
  EXPECT_EQ(across(Axis::Z, Axis::Y), Axis::X);
  EXPECT_EQ(across(Axis::U, Axis::Z), std::nullopt);
  move.polar.form = PolarForm::none;
  EXPECT_EQ(across(Axis::X, Axis::Z), std::nullopt);
}

TEST(ReportPolarPicture, ExtentsAreThoseOfTheFigureAndOfTheAxes) {
  const RunExtents extents = extents_of(timed(passed(corner_and_arc().actions())));
  EXPECT_NEAR(extents.drawn[index(Axis::X)].low, 70.0, 1e-2);
  EXPECT_NEAR(extents.drawn[index(Axis::X)].high, 120.0, 1e-9);
  EXPECT_NEAR(extents.drawn[index(Axis::Y)].low, -10.0, 1e-9);
  EXPECT_NEAR(extents.drawn[index(Axis::Y)].high, 10.0, 1e-9);
  // The axis itself comes as near as 10 mm to the centre, over the middle of the line, and is farthest away
  // on the arc.
  EXPECT_NEAR(extents.all[index(Axis::X)].low, 110.0, 1e-9);
  EXPECT_NEAR(extents.all[index(Axis::X)].high, 130.0, 1e-9);
  ASSERT_TRUE(extents.across.has_value());
  EXPECT_EQ(extents.across->shown, Axis::Y);
  EXPECT_EQ(extents.across->rotary, Axis::C);
}

TEST(ReportPolarPicture, TheProgrammedPathIsAFigureToo) {
  PolarProgram program(20.0);
  program.to(20.0, 10.0);
  Action action = program.actions()[0];
  std::get<Move>(action.what).compensation = {Side::left, 2.0};
  ProgrammedPath path;
  path.add(action);
  ASSERT_EQ(path.size(), 1U);
  expect_at(path[0].end, 20.0, 10.0);
  EXPECT_EQ(path[0].plane, kPlaneXY);
}

TEST(ReportPolarPicture, PlotAndReportSayWhatTheyShow) {
  Machine machine = report_test::machine_with({Axis::X, Axis::Z, Axis::C});
  machine.axis[index(Axis::C)].type = AxisType::rotary;
  RunRecord record;
  record.actions = timed(passed(corner_and_arc().actions()));
  const std::string plot = svg_plot(record, machine, {"cam", "kerf"});
  EXPECT_EQ(xml_fault(plot), "");
  EXPECT_EQ(count_of(plot, "Y, C across (mm)"), 1U);
  EXPECT_NE(plot.find("X  110.000 … 130.000"), std::string::npos);
}

TEST(ReportPolarPicture, AFigureInAnyPlaneIsDrawnToScale) {
  Machine machine = report_test::machine_with({Axis::X, Axis::Y, Axis::Z});
  const auto plot_of = [&](const Plane& plane) {
    Move arc = report_test::arc_xy(report_test::at(0, 0, 0), report_test::at(10, 0, 0), 5, 0, 180);
    arc.plane = plane;
    arc.start = arc.end = arc.commanded = {};
    arc.end[plane.first] = arc.commanded[plane.first] = 10.0;
    RunRecord record;
    record.actions = timed({{{}, arc}});
    return svg_plot(record, machine, {"arc", "kerf"});
  };
  // The plan is there in any case, the view from the side only for a figure that it shows; each has a scale
  // bar then.
  EXPECT_EQ(count_of(plot_of(kPlaneXY), "class=\"scale\""), 1U);
  EXPECT_EQ(count_of(plot_of(kPlaneZX), "class=\"scale\""), 2U);
  EXPECT_EQ(count_of(plot_of(kPlaneYZ), "class=\"scale\""), 2U);
  EXPECT_EQ(plot_of(kPlaneXY).find("clip-YZ"), std::string::npos);
  EXPECT_NE(plot_of(kPlaneYZ).find("clip-YZ"), std::string::npos);
  EXPECT_EQ(plot_of(kPlaneZX).find("drawn ×"), std::string::npos);
}

TEST(ReportPolarPicture, EventsTellHowAxesBecomeTheFigure) {
  const Machine machine = report_test::machine_with({Axis::X, Axis::Z, Axis::C});
  std::string out;
  JsonLines(machine).write(passed(corner_and_arc().actions())[0], out);
  const auto event = nlohmann::json::parse(out);
  EXPECT_EQ(event["polar"], nlohmann::json::parse(R"({"linear":"X","rotary":"C","center":100,"zero":30})"));
  EXPECT_NEAR(event["end"]["X"].get<double>(), 100.0 + std::sqrt(500.0), 1e-9);
}

}  // namespace
}  // namespace kerf
