// The pass that gives moves of a polar plane the positions of their axes.

#include <gtest/gtest.h>

#include "polar_program.hpp"

namespace kerf {
namespace {

using polar_test::passed;
using polar_test::PolarProgram;

std::vector<Move> moves_of(const std::vector<Action>& actions) {
  std::vector<Move> moves;
  for (const Action& action : actions) moves.push_back(std::get<Move>(action.what));
  return moves;
}

void expect_axes(const Move& move, double x, double c) {
  EXPECT_NEAR(move.end[Axis::X], x, 1e-9);
  EXPECT_NEAR(move.end[Axis::C], c, 1e-9);
}

TEST(PolarPass, WithoutARotaryAxisNothingIsTouched) {
  PolarProgram program(40.0);
  program.to(20.0, 0.0);
  PolarPass pass({});
  toolpath_test::ListSource source(program.actions());
  EXPECT_EQ(pass.next(source), program.actions().data());
}

TEST(PolarPass, PositionsAreDistanceAndAngle) {
  PolarProgram program(20.0, 100.0, 37.0);
  program.to(20.0, 20.0).to(-20.0, 20.0).to(-20.0, -20.0);
  const auto moves = moves_of(passed(program.actions()));
  ASSERT_EQ(moves.size(), 3U);
  const double diagonal = 20.0 * std::sqrt(2.0);
  expect_axes(moves[0], 100.0 + diagonal, 37.0 + 45.0);
  expect_axes(moves[1], 100.0 + diagonal, 37.0 + 135.0);
  expect_axes(moves[2], 100.0 + diagonal, 37.0 + 225.0);
  for (const Move& move : moves) EXPECT_EQ(move.polar.form, PolarForm::axes);
  EXPECT_EQ(moves[1].start, moves[0].end);
  EXPECT_EQ(moves[2].commanded, std::get<Move>(program.actions()[2].what).commanded);
}

TEST(PolarPass, TurnsAddUpOverTheContour) {
  PolarProgram program(20.0);
  program.arc(0.0, 0.0, 360.0).arc(0.0, 0.0, 270.0).arc(0.0, 0.0, -90.0);
  const auto moves = moves_of(passed(program.actions()));
  ASSERT_EQ(moves.size(), 3U);
  expect_axes(moves[0], 20.0, 360.0);
  expect_axes(moves[1], 20.0, 630.0);
  expect_axes(moves[2], 20.0, 540.0);
}

TEST(PolarPass, OnTheMinusSideTheWorkLiesHalfATurnAway) {
  // X stays below the centre; (-20, 20) is seen from (-20, 0) a quarter of a right angle clockwise.
  PolarProgram program(-20.0, 5.0);
  program.to(-20.0, 20.0).arc(0.0, 0.0, -90.0);
  const auto moves = moves_of(passed(program.actions()));
  ASSERT_EQ(moves.size(), 2U);
  const double diagonal = 20.0 * std::sqrt(2.0);
  expect_axes(moves[0], 5.0 - diagonal, -45.0);
  expect_axes(moves[1], 5.0 - diagonal, -135.0);
}

TEST(PolarPass, ALineThroughTheCentreTurnsTheAxisThere) {
  PolarProgram program(30.0);
  program.to(-10.0, 0.0);
  const auto actions = passed(program.actions());
  const auto moves = moves_of(actions);
  ASSERT_EQ(moves.size(), 3U);
  expect_axes(moves[0], 0.0, 0.0);
  EXPECT_TRUE(moves[0].exact_stop);
  expect_axes(moves[1], 0.0, 180.0);
  EXPECT_EQ(moves[1].polar.form, PolarForm::none);
  EXPECT_TRUE(moves[1].rotary_feed.at_maximum);
  expect_axes(moves[2], 10.0, 180.0);
  EXPECT_TRUE(moves[2].from_rest);
  for (const Action& action : actions) EXPECT_EQ(action.origin.block, 1U);
}

TEST(PolarPass, AnArcThroughTheCentreGoesOnAlongItsTangent) {
  // A circle of radius 10 about (10, 0): from (20, 0) half around to the centre of rotation, where it runs in
  // -C, and a quarter on to (10, -10), which is seen at -45 degrees. Half a circle turns the axis by 90.
  PolarProgram program(20.0);
  program.arc(10.0, 0.0, 270.0);
  const auto moves = moves_of(passed(program.actions()));
  ASSERT_EQ(moves.size(), 3U);
  expect_axes(moves[0], 0.0, 90.0);
  EXPECT_NEAR(moves[0].arc.sweep, 180.0, 1e-9);
  // +90 or -270 from there: both lie in the direction -90.
  EXPECT_NEAR(std::remainder(moves[1].end[Axis::C] + 90.0, 360.0), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(moves[1].end[Axis::C] - 90.0), 180.0, 1e-9);
  EXPECT_NEAR(moves[2].end[Axis::X], 10.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(moves[2].end[Axis::C] - moves[1].end[Axis::C], 45.0, 1e-9);
  EXPECT_NEAR(moves[2].arc.sweep, 90.0, 1e-9);
}

TEST(PolarPass, FromTheCentreItTurnsTheShortWay) {
  PolarProgram program(0.0);
  program.to(0.0, -10.0).to(0.0, 0.0).to(-10.0, 0.0);
  const auto moves = moves_of(passed(program.actions()));
  ASSERT_EQ(moves.size(), 5U);
  expect_axes(moves[0], 0.0, -90.0);
  expect_axes(moves[1], 10.0, -90.0);
  expect_axes(moves[2], 0.0, -90.0);
  expect_axes(moves[3], 0.0, -180.0);
  expect_axes(moves[4], 10.0, -180.0);
}

TEST(PolarPass, ALineThatTheCompensationHasLedAroundTheOtherSideKeepsTheTurnsOfAnEndlessAxis) {
  // The path goes once around; the program says that C stands at 0 when the mode ends.
  PolarProgram program(20.0);
  program.arc(0.0, 0.0, 360.0);
  Move after;
  after.start[Axis::X] = 20.0;
  after.end = after.start;
  after.end[Axis::C] = 30.0;
  program.action(after);
  program.action(after);
  const auto endless = moves_of(passed(program.actions(), true));
  ASSERT_EQ(endless.size(), 3U);
  EXPECT_NEAR(endless[1].start[Axis::C], 360.0, 1e-9);
  EXPECT_NEAR(endless[1].end[Axis::C], 390.0, 1e-9);
  EXPECT_NEAR(endless[2].end[Axis::C], 390.0, 1e-9);
  // Where turns count, the axis goes to the position that was commanded.
  const auto counting = moves_of(passed(program.actions(), false));
  EXPECT_NEAR(counting[1].start[Axis::C], 360.0, 1e-9);
  EXPECT_NEAR(counting[1].end[Axis::C], 30.0, 1e-9);
}

TEST(PolarPass, AMoveOfTheHeightAxisAloneKeepsTheAngle) {
  PolarProgram program(20.0);
  program.to(20.0, 20.0).to(20.0, 20.0, -5.0);
  const auto moves = moves_of(passed(program.actions()));
  ASSERT_EQ(moves.size(), 2U);
  expect_axes(moves[1], 20.0 * std::sqrt(2.0), 45.0);
  EXPECT_EQ(moves[1].end[Axis::Z], -5.0);
}

TEST(PolarPass, MovesChainWithoutRounding) {
  PolarProgram program(20.3, 100.7, 33.3);
  for (int i = 1; i <= 200; ++i) {
    const double angle = 0.1 * i * i;
    program.to(0.37 * i * std::cos(angle), 0.31 * i * std::sin(angle));
    if (i % 3 == 0) program.arc(program.here().x + 1.7, program.here().y - 0.3, 11.0 * i);
  }
  const auto moves = moves_of(passed(program.actions()));
  ASSERT_GE(moves.size(), 266U);
  EXPECT_EQ(moves.front().start[Axis::X], 121.0);
  EXPECT_EQ(moves.front().start[Axis::C], 33.3);
  for (std::size_t i = 1; i < moves.size(); ++i) ASSERT_EQ(moves[i].start, moves[i - 1].end) << i;
}

TEST(PolarPass, TheMovesBehindChainWithoutRounding) {
  for (const bool endless : {false, true}) {
    PolarProgram program(20.3, 100.7, 33.3);
    program.to(7.1, 13.3).to(-3.7, 9.1);
    const Vec2 at = program.here();
    // The dialect's own figures, a rounding error beside those of the pass.
    Move up;
    up.start[Axis::X] = 100.7 + length(at) * (1.0 + 1e-15);
    up.start[Axis::C] = 33.3 + degrees(std::atan2(at.y, at.x)) + 1e-14;
    up.end = up.start;
    up.end[Axis::Z] = 10.0;
    Move turn = up;
    turn.start[Axis::Z] = 10.0;
    turn.end[Axis::C] = 50.0;
    Move out = turn;
    out.start[Axis::C] = 50.0;
    out.end[Axis::X] = 130.0;
    program.action(up).action(turn).action(out);
    const auto moves = moves_of(passed(program.actions(), endless));
    ASSERT_EQ(moves.size(), 5U);
    for (std::size_t i = 1; i < moves.size(); ++i) EXPECT_EQ(moves[i].start, moves[i - 1].end) << i;
    EXPECT_EQ(moves[4].end[Axis::C], 50.0);
    EXPECT_EQ(moves[4].end[Axis::X], 130.0);
  }
}

TEST(PolarPass, TheModeBeginsAgainWhereItLeftTheAxes) {
  PolarProgram program(20.3, 100.7, 33.3);
  program.to(7.1, 13.3).to(-3.7, 9.1);
  const Vec2 at = program.here();
  Move out;
  out.start[Axis::X] = 100.7 + length(at);
  out.start[Axis::C] = 33.3 + degrees(std::atan2(at.y, at.x)) + 2e-13;
  out.end = out.start;
  out.end[Axis::X] = 104.0;
  program.action(out);
  PolarProgram again(104.0 - 100.7, 100.7, out.end[Axis::C]);
  again.to(2.0, 1.0);
  program.action(again.actions().front().what);
  const auto moves = moves_of(passed(program.actions()));
  ASSERT_EQ(moves.size(), 4U);
  for (std::size_t i = 1; i < moves.size(); ++i) EXPECT_EQ(moves[i].start, moves[i - 1].end) << i;
  expect_axes(moves[3], 100.7 + std::sqrt(5.0), out.end[Axis::C] + degrees(std::atan2(1.0, 2.0)));
}

TEST(PolarPass, BehindAnAlarmTheProgramGoesOnFromAnywhere) {
  static constexpr AlarmKind kind;
  PolarProgram program(20.0);
  program.to(20.0, 20.0).action(Alarm{&kind, {}, {}, {}});
  Move away;
  away.start[Axis::X] = away.end[Axis::X] = 7.0;
  away.end[Axis::C] = 12.0;
  program.action(away);
  PolarProgram again(7.0, 0.0, 12.0);
  again.to(3.0, 4.0);
  program.action(again.actions().front().what);
  const auto actions = passed(program.actions());
  ASSERT_EQ(actions.size(), 4U);
  EXPECT_EQ(std::get<Move>(actions[2].what).start, away.start);
  const auto& last = std::get<Move>(actions[3].what);
  EXPECT_EQ(last.start, away.end);
  expect_axes(last, 5.0, 12.0 + degrees(std::atan2(4.0, 3.0)));
}

// Rounding adds up between the dialect's figures and those of the pass while the axis is not moved by itself.
TEST(PolarPass, FiguresThatDriftApartDoNotBreakTheChain) {
  PolarProgram program(20.0);
  program.to(20.0, 20.0);
  PolarProgram again(20.0 * std::sqrt(2.0), 0.0, 45.0 + 1e-6);
  again.to(1.0, 1.0).to(1.0, 0.0);
  for (const Action& action : again.actions()) program.action(action.what);
  Move up;
  up.start[Axis::X] = up.end[Axis::X] = 20.0 * std::sqrt(2.0);
  up.start[Axis::C] = up.end[Axis::C] = 45.0 + 1e-6;
  up.end[Axis::Z] = 10.0;
  auto actions = program.actions();
  actions.insert(actions.begin() + 1, Action{{}, up});
  for (std::size_t i = 2; i < actions.size(); ++i) {
    auto& move = std::get<Move>(actions[i].what);
    move.start[Axis::Z] = move.end[Axis::Z] = 10.0;
  }
  const auto moves = moves_of(passed(actions));
  ASSERT_EQ(moves.size(), 4U);
  for (std::size_t i = 1; i < moves.size(); ++i) EXPECT_EQ(moves[i].start, moves[i - 1].end) << i;
  expect_axes(moves[2], std::sqrt(2.0), 45.0 + 45.0);
  expect_axes(moves[3], 1.0, 45.0);
}

TEST(PolarPass, OtherActionsPassInOrder) {
  PolarProgram program(20.0);
  program.to(20.0, 20.0).action(Dwell{1.0}).to(20.0, 0.0).action(Auxiliary{8});
  const auto actions = passed(program.actions());
  ASSERT_EQ(actions.size(), 4U);
  EXPECT_TRUE(std::holds_alternative<Dwell>(actions[1].what));
  EXPECT_TRUE(std::holds_alternative<Auxiliary>(actions[3].what));
  expect_axes(std::get<Move>(actions[2].what), 20.0, 0.0);
}

}  // namespace
}  // namespace kerf
