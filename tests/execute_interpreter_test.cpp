#include <gtest/gtest.h>

#include "dialect/setup.hpp"
#include "execute/interpreter.hpp"
#include "toolpath/toolpath.hpp"

namespace kerf {
namespace {

Controller controller(std::vector<std::string> assignments = {}) {
  SetupOptions options;
  options.dialect = "dgshape";
  options.assignments = std::move(assignments);
  auto made = make_controller(options);
  EXPECT_TRUE(made.has_value());
  return std::move(*made);
}

Interpreter interpreter(const Controller& c, std::string_view text) {
  return Interpreter(c.rules, Source::from_text("test", text), c.interpreter_options);
}

const Move& next_move(Interpreter& program) {
  for (;;) {
    const Action* action = program.next();
    EXPECT_NE(action, nullptr);
    if (const auto* move = std::get_if<Move>(&action->what)) return *move;
  }
}

constexpr std::string_view kDrilling =
    "%\nG21G90S1000M03F100.0\nG91G81X10.0Z-1.0R-1.0K3\nG80\nG90G00X0\nM02\n%\n";

TEST(Interpreter, ACopyInsideAFixedCycleGoesOnAlike) {
  const Controller c = controller();
  Interpreter original = interpreter(c, kDrilling);
  next_move(original);
  next_move(original);
  Interpreter copy = original;
  std::vector<AxisVector> first;
  std::vector<AxisVector> second;
  while (const Action* action = original.next()) {
    if (const auto* move = std::get_if<Move>(&action->what)) first.push_back(move->end);
  }
  while (const Action* action = copy.next()) {
    if (const auto* move = std::get_if<Move>(&action->what)) second.push_back(move->end);
  }
  EXPECT_EQ(first.size(), 3U * 4U - 2U + 1U);
  EXPECT_EQ(first, second);
}

TEST(Interpreter, AnAlarmChangesNothing) {
  const Controller c = controller();
  // The faulty block sets G91, F, S and a coordinate system before the unknown word stops it.
  Interpreter program = interpreter(c, "%\nG21G90F100.0\nG91G55F200.0S500X1.0B2\nG00X5.0\nM02\n");
  const Action* action = program.next();
  ASSERT_TRUE(std::holds_alternative<Alarm>(action->what));
  EXPECT_EQ(program.state().registers.modal[Group::distance], code(90));
  EXPECT_EQ(program.state().registers.modal[Group::work_system], code(54));
  EXPECT_DOUBLE_EQ(program.state().registers.feed, 100.0);
  EXPECT_EQ(program.next(), nullptr);
  program.recover();
  EXPECT_DOUBLE_EQ(next_move(program).end[Axis::X], 5.0);
}

TEST(Interpreter, EveryActionKnowsItsBlock) {
  const Controller c = controller();
  Interpreter program = interpreter(c, "%\nO12\nN10G21G90\nN20G00X1.0\n\nY2.0\nM02\n");
  const Action* action = program.next();
  EXPECT_EQ(action->origin.program, 12);
  EXPECT_EQ(action->origin.sequence_number, 20);
  EXPECT_EQ(action->origin.span.line, 4U);
  EXPECT_EQ(action->origin.block, 3U);
  action = program.next();
  EXPECT_EQ(action->origin.sequence_number, 20) << "the number in force stays until the next";
  EXPECT_EQ(action->origin.span.line, 6U);
}

TEST(Interpreter, DataThatJustEndsStopsTheSpindleWithAWarning) {
  const Controller c = controller();
  Interpreter program = interpreter(c, "%\nS1000M03\n");
  EXPECT_EQ(std::get<Spindle>(program.next()->what).direction, SpindleDirection::clockwise);
  const auto warning = std::get<Alarm>(program.next()->what);
  EXPECT_EQ(warning.kind->detail, "no-program-end");
  EXPECT_EQ(warning.kind->severity, Severity::warning);
  EXPECT_EQ(std::get<Spindle>(program.next()->what).direction, SpindleDirection::off);
  EXPECT_TRUE(std::holds_alternative<End>(program.next()->what));
  EXPECT_EQ(program.next(), nullptr);
}

TEST(Interpreter, OverTravelIsFoundBeforeTheBlockMoves) {
  const Controller c = controller({"axes.X.limits=[0,100]"});
  Interpreter program = interpreter(c, "%\nG21G90\nG00X100.001\nG91X1.0\nM02\n");
  EXPECT_EQ(std::get<Alarm>(program.next()->what).kind->detail, "over-travel");
  program.recover();
  EXPECT_DOUBLE_EQ(next_move(program).end[Axis::X], 101.001) << "the blocks behind count on the refused one";
}

TEST(Interpreter, OneMistakeGivesOneAlarm) {
  const Controller c = controller({"axes.X.limits=[0,100]"});
  const auto alarms = [&](const std::string& blocks) {
    Interpreter program = interpreter(c, "%\nG21G90\n" + blocks + "M02\n");
    std::string found;
    while (const Action* action = program.next()) {
      const auto* alarm = std::get_if<Alarm>(&action->what);
      if (alarm == nullptr) continue;
      found += std::string(alarm->kind->detail) + ":" + std::to_string(alarm->span.line) + " ";
      program.recover();
    }
    return found;
  };
  // The end of the refused arc is where the next one starts: radius 10 reaches from X20 to X40.
  EXPECT_EQ(alarms("M03F100.0\nG02X20.0R1.0\nG02X40.0R10.0\n"), "arc-radius:4 ");
  EXPECT_EQ(alarms("M03\nG01X1.0\nG01X2.0\n"), "no-feed:4 ") << "that F is missing is said once";
  EXPECT_EQ(alarms("M03F100.0\nG00X200.0\nG91G01X1.0\nX1.0\nX-110.0\nX-50.0\n"), "over-travel:4 ");
  EXPECT_EQ(alarms("M03F100.0\nG00X200.0\nX10.0\nX300.0\n"), "over-travel:4 over-travel:6 ");
  EXPECT_EQ(alarms("M03J1.0\nF100.0G01X1.0\n"), "unused-word:3 ") << "the spindle is taken as started";
  EXPECT_EQ(alarms("M03F100.0\nG91X10.0J1.0\nG01X95.0\n"), "unused-word:4 over-travel:5 ");
}

TEST(Interpreter, ATextThatNeverStartsHasNoEndToMiss) {
  const Controller c = controller();
  Interpreter program = interpreter(c, "Dear machinist,\n");
  EXPECT_EQ(std::get<Alarm>(program.next()->what).kind->detail, "no-data-start");
  program.recover();
  EXPECT_EQ(program.next(), nullptr);
}

TEST(Interpreter, OverTravelOfAnArcNamesTheAxisAndItsOutermostPoint) {
  const Controller c = controller({"axes.X.limits=[-50,50]", "axes.Y.limits=[-20,50]"});
  const std::string head = "%\nG21G90S1000F100.0\nM03\nG00X5.0Y0\n";
  const auto message = [&](const std::string& arc) {
    Interpreter program = interpreter(c, head + arc + "\nM02\n");
    for (;;) {
      const Action* action = program.next();
      if (action == nullptr) return std::string();
      if (const auto* alarm = std::get_if<Alarm>(&action->what)) return std::string(message_of(*alarm));
    }
  };
  EXPECT_NE(message("G02X60.0Y0I27.5J0").find("X would reach 60.000"), std::string::npos);
  // Both ends lie inside, the lowest point of the half circle 22.5 mm below them does not.
  EXPECT_NE(message("G03X50.0Y0I22.5J0").find("Y would reach -22.500"), std::string::npos);
  EXPECT_EQ(message("G02X50.0Y0I22.5J0"), "");
}

TEST(Setup, ReportsEveryErrorAtOnce) {
  SetupOptions options;
  options.assignments = {"axes.X.rapit=1", "dgshape.feed_override=lots"};
  const auto made = make_controller(options);
  ASSERT_FALSE(made.has_value());
  ASSERT_EQ(made.error().size(), 2U);
  EXPECT_NE(error_text(made.error()[0]).find("axes.X.rapid"), std::string::npos);
}

TEST(Setup, SettingsThatContradictEachOtherAreRefused) {
  const auto refusal = [](std::vector<std::string> assignments) {
    SetupOptions options;
    options.assignments = std::move(assignments);
    const auto made = make_controller(options);
    return made.has_value() ? std::string() : error_text(made.error()[0]);
  };
  EXPECT_NE(refusal({"dgshape.feed_min=500", "dgshape.feed_max=100"}).find("dgshape.feed_min"),
            std::string::npos);
  EXPECT_NE(refusal({"dgshape.spindle_max=100", "dgshape.spindle_min=200"}).find("is above"),
            std::string::npos);
  EXPECT_EQ(refusal({"dgshape.feed_min=100", "dgshape.feed_max=100"}), "");
  SetupOptions one_axis;
  one_axis.machine_text = "[axes.X]\nrapid = 8000\n";
  const auto made = make_controller(one_axis);
  ASSERT_FALSE(made.has_value()) << "words of the other axes would be dropped";
  EXPECT_NE(error_text(made.error()[0]).find("no axis Y"), std::string::npos);
  EXPECT_NE(refusal({"axes.X.limits=[0,10]", "axes.X.home=11"}).find("axes.X.home"), std::string::npos);
}

TEST(Setup, UnknownDialectNamesTheKnownOnes) {
  SetupOptions options;
  options.dialect = "fanuc";
  const auto made = make_controller(options);
  ASSERT_FALSE(made.has_value());
  EXPECT_NE(made.error()[0].remedy.find("dgshape"), std::string::npos);
}

}  // namespace
}  // namespace kerf
