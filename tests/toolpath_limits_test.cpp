// Travel limits, and the chain of both passes.

#include <gtest/gtest.h>

#include "toolpath/toolpath.hpp"
#include "toolpath_compensation_policy.hpp"

namespace kerf {
namespace {

using toolpath_test::ListSource;
using toolpath_test::Program;
using toolpath_test::text_of;

constexpr AlarmKind kOverTravel{"T", "over-travel", "", "", "", Severity::alarm};

// X 0..500, Y -20..400, Z -100..50, A 0..360.
Machine machine() {
  Machine machine;
  const auto add = [&](Axis axis, double low, double high) {
    machine.axes.insert(axis);
    machine.axis[index(axis)].lower_limit = low;
    machine.axis[index(axis)].upper_limit = high;
  };
  add(Axis::X, 0, 500);
  add(Axis::Y, -20, 400);
  add(Axis::Z, -100, 50);
  add(Axis::A, 0, 360);
  machine.axis[index(Axis::A)].type = AxisType::rotary;
  return machine;
}

std::vector<Action> limited(const std::vector<Action>& actions, bool clip = false) {
  TravelLimitPass pass(machine(), {&kOverTravel, clip});
  return toolpath_test::run_through(pass, actions);
}

std::string limited_path(const Program& program, bool clip = false) {
  return text_of(limited(program.actions(), clip));
}

std::string first_message(const std::vector<Action>& actions) {
  for (const Action& action : limited(actions))
    if (const Alarm* alarm = std::get_if<Alarm>(&action.what)) return std::string(message_of(*alarm));
  return "";
}

TEST(TravelLimits, InsideIsHandedThroughWithoutACopy) {
  const Program program = Program().to(500, 400).dwell().to(0, -20).ccw(20, 0, 0, 0).z(50).end();
  TravelLimitPass pass(machine(), {&kOverTravel, false});
  ListSource source(program.actions());
  for (const Action& action : program.actions()) EXPECT_EQ(pass.next(source), &action);
  EXPECT_EQ(pass.next(source), nullptr);
}

// DGS-164.
TEST(TravelLimits, AlarmBeforeTheMove) {
  EXPECT_EQ(limited_path(Program().to(10, 0).to(600, 0)), "10,0 | alarm over-travel");
  EXPECT_EQ(first_message(Program().to(10, 0).to(600, 0).actions()),
            "X would reach 600.0000 mm; travel is 0 to 500 mm");
  EXPECT_EQ(first_message(Program().to(10, -20.5).actions()),
            "Y would reach -20.5000 mm; travel is -20 to 400 mm");
  EXPECT_EQ(limited(Program().to(10, 0).to(600, 0).actions())[1].origin.block, 2U);
}

TEST(TravelLimits, RotaryAxisIsInDegrees) {
  std::vector<Action> actions = Program().to(10, 0).actions();
  std::get<Move>(actions[0].what).end[Axis::A] = 400.0;
  EXPECT_EQ(first_message(actions), "A would reach 400.0000 deg; travel is 0 to 360 deg");
}

TEST(TravelLimits, AxesTheMachineLacksHaveNone) {
  std::vector<Action> actions = Program().to(10, 0).actions();
  std::get<Move>(actions[0].what).end[Axis::W] = 1e9;
  EXPECT_EQ(text_of(limited(actions)), "10,0");
}

// Half circles from (100,0) to (140,0) and back: the lower one reaches Y -20, one of radius 21 Y -21.
TEST(TravelLimits, OutermostPointsOfArcs) {
  EXPECT_EQ(limited_path(Program().to(100, 0).ccw(140, 0, 120, 0)), "100,0 | ccw 140,0 c 120,0 r 20");
  EXPECT_EQ(limited_path(Program().to(100, 0).ccw(142, 0, 121, 0)), "100,0 | alarm over-travel");
  EXPECT_EQ(first_message(Program().to(100, 0).ccw(142, 0, 121, 0).actions()),
            "Y would reach -21.0000 mm; travel is -20 to 400 mm");
  EXPECT_EQ(limited_path(Program().to(100, 0).cw(142, 0, 121, 0)), "100,0 | cw 142,0 c 121,0 r 21");
}

TEST(TravelLimits, TheNextMoveGoesOnFromTheTool) {
  EXPECT_EQ(limited_path(Program().to(10, 0).to(600, 0).to(100, 50)), "10,0 | alarm over-travel | 100,50");
  EXPECT_EQ(limited_path(Program().to(100, 0).ccw(142, 0, 121, 0).cw(100, 0, 121, 0).cw(140, 0, 120, 0)),
            "100,0 | alarm over-travel | alarm over-travel | cw 140,0 c 120,0 r 20");
  EXPECT_EQ(limited_path(Program().to(100, 0).ccw(142, 0, 121, 0).cw(162, 20, 142, 20)),
            "100,0 | alarm over-travel | 142,0 | cw 162,20 c 142,20 r 20");
}

TEST(TravelLimits, ClipsLinesAtTheBorder) {
  EXPECT_EQ(limited_path(Program().to(100, 100).to(900, 300).to(100, 300), true),
            "100,100 | 500,200 | 100,300");
  // The first border on the way counts: Y 400 after 3/8 of it, X 500 after 1/2.
  EXPECT_EQ(limited_path(Program().to(100, 100).to(900, 900), true), "100,100 | 400,400");
  EXPECT_EQ(limited_path(Program().to(100, 100).to(-100, 100), true), "100,100 | 0,100");
}

TEST(TravelLimits, ClippedMoveAtTheBorderIsDropped) {
  EXPECT_EQ(limited_path(Program().to(500, 0).to(600, 50).to(600, 60).to(400, 60), true), "500,0 | 400,60");
}

TEST(TravelLimits, ClippingTakesTheOtherAxesAlong) {
  const std::vector<Action> out = limited(Program().to(100, 0).to(900, 0, -80).actions(), true);
  ASSERT_EQ(out.size(), 2U);
  EXPECT_DOUBLE_EQ(std::get<Move>(out[1].what).end[Axis::Z], -40.0);
  EXPECT_EQ(std::get<Move>(out[1].what).end[Axis::X], 500.0);
}

TEST(TravelLimits, ClippingDoesNotApplyToArcs) {
  EXPECT_EQ(limited_path(Program().to(100, 0).ccw(142, 0, 121, 0), true), "100,0 | alarm over-travel");
}

TEST(TravelLimits, ResetForgetsTheProgram) {
  const Program program = Program().to(10, 0).to(600, 0);
  TravelLimitPass pass(machine(), {&kOverTravel, false});
  toolpath_test::run_through(pass, program.actions());
  pass.reset();
  ListSource source(program.actions());
  EXPECT_EQ(pass.next(source), &program.actions()[0]);
}

// The programmed contour reaches Y 400, its parallel Y 402.
TEST(Toolpath, ChecksTheCompensatedPath) {
  const auto run = [](double offset) {
    const Program program = Program().left(offset).to(10, 400).to(20, 400).none().to(30, 390).end();
    ListSource source(program.actions());
    Toolpath toolpath(source, machine(),
                      {toolpath_test::compensation_policy(), {}, {}, {}, {&kOverTravel, false}});
    std::vector<Action> out;
    while (const Action* action = toolpath.next()) {
      out.push_back(*action);
      if (std::holds_alternative<Alarm>(action->what)) toolpath.recover();
    }
    return text_of(out);
  };
  EXPECT_EQ(run(-2), "10,398 | 20,398 | 30,390 | end");
  EXPECT_EQ(run(2), "alarm over-travel | 30,390 | end") << "the second block goes on outside";
}

TEST(Toolpath, AnAlarmOfAPassIsTheLastAction) {
  const Program program = Program().left(2).to(10, 400).to(20, 390).none().to(30, 390).end();
  ListSource source(program.actions());
  Toolpath toolpath(source, machine(),
                    {toolpath_test::compensation_policy(), {}, {}, {}, {&kOverTravel, false}});
  std::vector<Action> out;
  while (const Action* action = toolpath.next()) out.push_back(*action);
  EXPECT_EQ(text_of(out), "alarm over-travel");
}

TEST(Toolpath, ResetStartsAnew) {
  const Program program = Program().left(2).to(10, 0).to(20, 0);
  ListSource first(program.actions());
  Toolpath toolpath(first, machine(),
                    {toolpath_test::compensation_policy(), {}, {}, {}, {&kOverTravel, false}});
  EXPECT_NE(toolpath.next(), nullptr);
  toolpath.reset();
  EXPECT_EQ(toolpath.next(), nullptr);  // the move held back is forgotten and the list is at its end
}

}  // namespace
}  // namespace kerf
