// The course of a tool radius compensation: sample programs, blocks without motion, corner arcs, alarms,
// hand-through.

#include <gtest/gtest.h>

#include "toolpath_compensation_policy.hpp"

namespace kerf {
namespace {

using toolpath_test::compensated;
using toolpath_test::compensated_path;
using toolpath_test::compensation_policy;
using toolpath_test::ListSource;
using toolpath_test::Program;

Program left2() {
  return Program().left(2);
}

const Alarm* first_alarm(const std::vector<Action>& actions) {
  for (const Action& action : actions)
    if (const Alarm* alarm = std::get_if<Alarm>(&action.what)) return alarm;
  return nullptr;
}

// DGS-146 to 149: section 1-6 of the DGSHAPE manual.
TEST(Compensation, SampleProgramOfTheManual) {
  Program program;
  program.left(3).rapid(8, 8).z(-7).to(8, 43).to(53, 43).ccw(68, 28, 68, 43).to(68, 8).to(8, 8).z(0);
  program.none().rapid(0, 0).end();
  const std::vector<Action> out = compensated(program.actions());
  EXPECT_EQ(toolpath_test::text_of(out),
            "rapid 5,8 | 5,8 z -7 | 5,46 | 56,46 | 56,43 | ccw 68,31 c 68,43 r 12 | 71,31 | 71,5 | 8,5 | "
            "8,5 z 0 | rapid 0,0 | end");
  // DGS-148: 202.850 mm of feed in the plane: 38 + 51 + 3 + 18.850 + 3 + 26 + 63.
  double feed_mm = 0.0;
  for (const Action& action : out)
    if (const Move* move = std::get_if<Move>(&action.what); move && move->mode != MoveMode::rapid)
      feed_mm += is_arc(move->mode)
                     ? move->arc.radius * radians(std::abs(move->arc.sweep))
                     : distance(in_plane(move->start, kPlaneXY), in_plane(move->end, kPlaneXY));
  EXPECT_NEAR(feed_mm, 202.850, 0.001);
}

// DGS-153 and DGS-152: start as rapid; DGS-281, 323.
TEST(Compensation, RapidStart) {
  EXPECT_EQ(compensated_path(left2().rapid(10, 0).to(20, 0)), "rapid 10,2 | 20,2");
}

// DGS-284, 321, 319.
TEST(Compensation, SidesAndAmounts) {
  EXPECT_EQ(compensated_path(Program().left(2).to(10, 0).to(20, 0)), "10,2 | 20,2");
  EXPECT_EQ(compensated_path(Program().right(2).to(10, 0).to(20, 0)), "10,-2 | 20,-2");
  EXPECT_EQ(compensated_path(Program().left(-2).to(10, 0).to(20, 0)), "10,-2 | 20,-2");
  EXPECT_EQ(compensated_path(Program().left(0).to(10, 0).to(20, 0).cw(20, 10, 20, 5)),
            "10,0 | 20,0 | cw 20,10 c 20,5 r 5");
}

// DGS-324: the code alone moves nothing.
TEST(Compensation, StartsWithTheFirstMotion) {
  EXPECT_EQ(compensated_path(left2().empty_block().m(12).z(-1).to(10, 0).to(20, 0)),
            "m 12 | 0,0 z -1 | 10,2 | 20,2");
}

// DGS-286: other axes ride along.
TEST(Compensation, OtherAxesRideAlong) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(20, 0, -5).to(20, 20, -6)),
            "10,2 | 18,2 z -5 | 18,20 z -6");
}

// DGS-303: cancel and start again with another amount; DGS-322: on the other side.
TEST(Compensation, StartsAgainAfterItsEnd) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(20, 0).none().to(30, 0).left(4).to(40, 0).to(50, 0)),
            "10,2 | 20,2 | 30,0 | 40,4 | 50,4");
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(20, 0).none().to(30, 0).right(2).to(40, 0).to(50, 0)),
            "10,2 | 20,2 | 30,0 | 40,-2 | 50,-2");
}

TEST(Compensation, ZeroLengthEndReturnsToTheProgrammedPoint) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).none().to(30, 0).to(40, 0)),
            "10,2 | 30,2 | 30,0 | 40,0");
}

TEST(Compensation, MoveOfAnotherAxisDoesNotEndIt) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).none().z(-1).to(40, 0)),
            "10,2 | 30,2 | 30,2 z -1 | 40,0");
}

TEST(Compensation, EndsRightAfterTheStart) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).none().to(20, 0)), "10,2 | 20,0");
}

TEST(Compensation, EndOfActionsFinishesTheStart) {
  EXPECT_EQ(compensated_path(left2().to(10, 0)), "10,2");
}

// DGS-299, restriction 5.
TEST(Compensation, OneBlockWithoutMotionKeepsTheLookAhead) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).dwell().to(30, 20)), "10,2 | 28,2 | dwell | 28,20");
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).z(-1).to(30, 20)),
            "10,2 | 28,2 | 28,2 z -1 | 28,20");
}

TEST(Compensation, TwoBlocksWithoutMotionEndTheLookAhead) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).dwell().dwell().to(30, 20)),
            "10,2 | 30,2 | dwell | dwell | 28,0 | 28,20");
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).empty_block().dwell().to(30, 20)),
            "10,2 | 30,2 | dwell | 28,0 | 28,20");
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).z(-1).z(-2).to(30, 20)),
            "10,2 | 30,2 | 30,2 z -1 | 30,2 z -2 | 28,0 | 28,20");
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).dwell().dwell().dwell().none().to(30, 20)),
            "10,2 | 30,2 | dwell | dwell | dwell | 30,20");
}

TEST(Compensation, ActionsOfTheNextBlockAreNoBlockOfTheirOwn) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).dwell().m(3).same_block().to(30, 20)),
            "10,2 | 28,2 | dwell | m 3 | 28,20");
}

TEST(Compensation, LookAheadFailsAfterTheStart) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).dwell().dwell().to(10, 20)),
            "10,2 | dwell | dwell | 8,0 | 8,20");
}

TEST(Compensation, LookAheadIsBounded) {
  Program program;
  program.left(2).to(10, 0).to(30, 0);
  for (int i = 0; i < 100; ++i) program.m(i).same_block();
  program.empty_block().to(30, 20);
  const std::vector<Action> out = compensated(program.actions());
  ASSERT_EQ(out.size(), 104U);
  EXPECT_EQ(in_plane(std::get<Move>(out[1].what).end, kPlaneXY), (Vec2{30, 2}));
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(std::get<Auxiliary>(out[static_cast<std::size_t>(i) + 2].what).code, i);
  EXPECT_EQ(in_plane(std::get<Move>(out[102].what).end, kPlaneXY), (Vec2{28, 0}));
}

TEST(Compensation, JointsCarryTheMoveBefore) {
  Program program;
  program.left(2).rapid(10, 0).rapid(30, 0).to(20, -10);
  const std::vector<Action> out = compensated(program.actions());
  ASSERT_EQ(out.size(), 4U);
  const Move& joint = std::get<Move>(out[2].what);
  EXPECT_EQ(joint.mode, MoveMode::rapid);
  EXPECT_EQ(out[2].origin.block, 2U);
  EXPECT_EQ(in_plane(joint.commanded, kPlaneXY), (Vec2{30, 0}));
  const Move& last = std::get<Move>(out[3].what);
  EXPECT_EQ(last.mode, MoveMode::linear);
  EXPECT_EQ(out[3].origin.block, 3U);
  EXPECT_EQ(in_plane(last.commanded, kPlaneXY), (Vec2{20, -10}));
}

// DGS-300: no interference check; the tool cuts its way to the next corner backwards.
// Drawings show what the tool sweeps on its way back to the programmed path.
TEST(Compensation, TheMoveThatEndsItKnowsTheAmount) {
  const Program program =
      Program().to(0, 10).right(2).to(10, 10).to(20, 10).none().to(30, 10).to(40, 10).end();
  std::vector<double> amounts;
  for (const Action& action : compensated(program.actions())) {
    if (const auto* move = std::get_if<Move>(&action.what)) amounts.push_back(move->compensation.amount);
  }
  EXPECT_EQ(amounts, (std::vector<double>{0.0, 2.0, 2.0, 2.0, 0.0}));
}

TEST(Compensation, SlotNarrowerThanTheToolIsExecuted) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).to(30, 1).to(10, 1)), "10,2 | 28,2 | 28,-1 | 10,-1");
}

// DGS-302.
TEST(Compensation, InnerArcOfTheOffsetShrinksToAPoint) {
  const auto arc = [](double offset) {
    return Program().left(offset).to(10, 0).to(20, 0).ccw(25, 5, 20, 5).to(25, 20);
  };
  EXPECT_EQ(compensated_path(arc(4)), "10,4 | 20,4 | ccw 21,5 c 20,5 r 1 | 21,20");
  EXPECT_EQ(compensated_path(arc(5)), "10,5 | 20,5 | 20,20");
}

TEST(Compensation, HelixThatShrinksToAPointStillPlunges) {
  Program program;
  program.left(5).to(10, 0).to(20, 0).ccw(25, 5, 20, 5);
  std::vector<Action> actions = program.actions();
  std::get<Move>(actions.back().what).end[Axis::Z] = -3.0;
  EXPECT_EQ(toolpath_test::text_of(compensated(actions)), "10,5 | 20,5 | 20,5 z -3");
}

TEST(Compensation, FullCircleAndMoreThanOneTurn) {
  Program program;
  program.left(2).to(10, 0).to(20, 0).ccw(20, 0, 20, 10).none().to(30, 0);
  EXPECT_EQ(compensated_path(program), "10,2 | 20,2 | ccw 20,2 c 20,10 r 8 | 30,0");
  std::vector<Action> actions = program.actions();
  std::get<Move>(actions[2].what).arc.sweep = 720.0;
  const std::vector<Action> out = compensated(actions);
  ASSERT_EQ(out.size(), 4U);
  EXPECT_DOUBLE_EQ(std::get<Move>(out[2].what).arc.sweep, 720.0);
}

// A joint meant to be tangent, rounded to 0.001 mm: the arc's start lies 0.001 mm from the line, so that line
// and offset circle miss each other (centre too high) or meet 0.13 mm beside the joint (centre too low).
TEST(Compensation, RoundedTangentJointsRaiseNoAlarm) {
  for (const double error : {-0.001, 0.001}) {
    const double angle = degrees(std::asin(error / 10.0));
    Program program;
    const Vec2 center = Vec2{30, 0} + rotated(Vec2{0, 10}, angle);
    program.left(2).to(10, 0).to(30, 0).ccw(center.x, center.y + 10, center.x, center.y);
    const std::vector<Action> out = compensated(program.actions());
    EXPECT_EQ(first_alarm(out), nullptr);
    const Move& line = std::get<Move>(out[1].what);
    EXPECT_NEAR(line.end[Axis::X], 30.0, 0.01);
    EXPECT_NEAR(line.end[Axis::Y], 2.0, 1e-9);
    EXPECT_TRUE(is_arc(std::get<Move>(out.back().what).mode));
  }
}

TEST(Compensation, AlmostTangentShortArcIsNotUsedUp) {
  // A fillet of 0.5 degrees between lines, its centre rounded by 0.001 mm.
  const Vec2 center{30.001, 10.0};
  const double radius = distance(center, {30, 0});
  const Vec2 end = center + radius * direction_at(angle_of_deg(Vec2{30, 0} - center) + 0.5);
  Program program;
  program.left(2).to(10, 0).to(30, 0).ccw(end.x, end.y, center.x, center.y).to(end.x + 20, end.y + 0.1745);
  EXPECT_EQ(first_alarm(compensated(program.actions())), nullptr);
}

// Circles of radius 7.998 around (0,0) and (16,0) miss each other by 0.004 mm, far from the corner at (8,6).
TEST(Compensation, ArcsThatJustMissEachOtherAreJoinedStraight) {
  Program program;
  program.from(-20, -10).left(2.002).to(-10, -10).to(0, -10).ccw(8, 6, 0, 0).ccw(16, -10, 16, 0).to(30, -10);
  EXPECT_EQ(compensated_path(program),
            "-10,-7.998 | 0,-7.998 | ccw 7.998,0 c 0,0 r 7.998 | 8.002,0 | ccw 16,-7.998 c 16,0 r 7.998 | "
            "30,-7.998");
}

// ---- corner arcs (G39)

// DGS-268, 272, 273.
TEST(CornerArcs, TurnAroundTheCorner) {
  EXPECT_EQ(compensated_path(left2().to(0, 10).to(10, 10).corner_arc(0, -10).to(10, 0)),
            "0,12 | 10,12 | cw 12,10 c 10,10 r 2 | 12,0");
  EXPECT_EQ(compensated_path(Program().right(2).to(0, -10).to(10, -10).corner_arc(0, 10).to(10, 0)),
            "0,-12 | 10,-12 | ccw 12,-10 c 10,-10 r 2 | 12,0");
}

// DGS-271 and 276: the words give only a direction; the next move starts beside its own start.
TEST(CornerArcs, DirectionOtherThanTheNextMove) {
  EXPECT_EQ(compensated_path(left2().to(0, 10).to(10, 10).corner_arc(0, -510).to(10, 0)),
            "0,12 | 10,12 | cw 12,10 c 10,10 r 2 | 12,0");
  EXPECT_EQ(compensated_path(left2().to(0, 10).to(10, 10).corner_arc(0, -1).to(0, 0)),
            "0,12 | 10,12 | cw 12,10 c 10,10 r 2 | 11.414,8.586 | 1.414,-1.414");
}

// DGS-274 and 275: the example of the manual, without and with the arc. G40 X30 Y7.5 ends the path.
TEST(CornerArcs, ExampleOfTheManual) {
  EXPECT_EQ(compensated_path(left2().rapid(1, 1).to(1, 14).to(17, 14).to(18, 7.5).none().rapid(30, 7.5)),
            "rapid -1,1 | -1,16 | 18.716,16 | 19.977,7.804 | rapid 30,7.5");
  EXPECT_EQ(
      compensated_path(
          left2().rapid(1, 1).to(1, 14).to(17, 14).corner_arc(1, -6.5).to(18, 7.5).none().rapid(30, 7.5)),
      "rapid -1,1 | -1,16 | 17,16 | cw 18.977,14.304 c 17,14 r 2 | 19.977,7.804 | rapid 30,7.5");
}

// DGS-277: one corner only. DGS-279: no direction, inner corner.
TEST(CornerArcs, OnceAndOnlyAtOuterCorners) {
  EXPECT_EQ(compensated_path(left2().to(0, 10).to(10, 10).corner_arc().to(10, 0).to(5, 0)),
            "0,12 | 10,12 | cw 12,10 c 10,10 r 2 | 12,-2 | 5,-2");
  EXPECT_EQ(compensated_path(left2().to(0, 10).to(10, 10).corner_arc(0, 10).to(10, 20)),
            "0,12 | 8,12 | 8,20");
}

TEST(CornerArcs, BesideOtherBlocks) {
  EXPECT_EQ(compensated_path(left2().to(0, 10).to(10, 10).corner_arc().z(-1).to(10, 0)),
            "0,12 | 10,12 | cw 12,10 c 10,10 r 2 | 12,10 z -1 | 12,0");
  EXPECT_EQ(compensated_path(left2().to(0, 10).to(10, 10).dwell().dwell().corner_arc().to(10, 0)),
            "0,12 | 10,12 | dwell | dwell | cw 12,10 c 10,10 r 2 | 12,0");
}

TEST(CornerArcs, BeforeTheEnd) {
  EXPECT_EQ(compensated_path(left2().to(0, 10).to(10, 10).corner_arc().none().to(10, 0)),
            "0,12 | 10,12 | cw 12,10 c 10,10 r 2 | 10,0");
  EXPECT_EQ(compensated_path(left2().to(0, 10).to(10, 10).corner_arc(0, -1).end()),
            "0,12 | 10,12 | cw 12,10 c 10,10 r 2 | end");
  EXPECT_EQ(compensated_path(left2().to(0, 10).to(10, 10).corner_arc().end()), "0,12 | 10,12 | end");
}

TEST(CornerArcs, HalfTurnAtAReversal) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(30, 0).corner_arc().to(10, 0)),
            "10,2 | 30,2 | cw 30,-2 c 30,0 r 2 | 10,-2");
}

TEST(CornerArcs, HaveTheirOwnFeedAndOrigin) {
  Program program;
  program.left(2).to(0, 10).rapid(10, 10).add(CornerArc{{0, -1}, 250.0}).to(10, 0);
  const std::vector<Action> out = compensated(program.actions());
  ASSERT_EQ(out.size(), 4U);
  EXPECT_EQ(std::get<Move>(out[1].what).mode, MoveMode::rapid);
  EXPECT_EQ(std::get<Move>(out[2].what).mode, MoveMode::clockwise);
  EXPECT_DOUBLE_EQ(std::get<Move>(out[2].what).feed, 250.0);
  EXPECT_EQ(out[2].origin.block, 3U);
}

// DGS-269.
TEST(CornerArcs, OnlyWhileInForce) {
  EXPECT_EQ(compensated_path(Program().to(10, 0).corner_arc(0, 10).to(20, 0)),
            "10,0 | alarm corner-arc-outside | 20,0");
}

// ---- alarms

std::string message_of_first(const Program& program) {
  const std::vector<Action> out = compensated(program.actions());
  const Alarm* alarm = first_alarm(out);
  return alarm == nullptr ? "" : std::string(message_of(*alarm));
}

// DGS-287.
TEST(CompensationAlarms, StartWithArc) {
  const Program program = Program().to(10, 0).left(2).cw(20, -10, 10, -10).to(20, -30).to(30, -30);
  EXPECT_EQ(compensated_path(program), "10,0 | alarm start-arc | 20,-28 | 30,-28");
  EXPECT_EQ(message_of_first(program), "The compensation starts with an arc of radius 10.000 mm");
  EXPECT_EQ(first_alarm(compensated(program.actions()))->span.line, 2U);
}

// DGS-288, 356.
TEST(CompensationAlarms, EndWithArc) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).ccw(20, 10, 10, 10).none().ccw(30, 20, 20, 20).to(40, 20)),
            "10,2 | ccw 18,10 c 10,10 r 8 | alarm end-arc | 40,20");
  EXPECT_EQ(compensated_path(left2().to(10, 0).ccw(20, 10, 10, 10).none().to(20, 20)),
            "10,2 | ccw 18,10 c 10,10 r 8 | 20,20");
}

// DGS-301: at the arc's block, nothing of it is executed.
TEST(CompensationAlarms, InnerArcSmallerThanTheOffset) {
  const Program program = Program().left(6).to(10, 0).to(20, 0).ccw(25, 5, 20, 5);
  EXPECT_EQ(compensated_path(program), "10,6 | 20,6 | alarm inner-radius");
  EXPECT_EQ(message_of_first(program), "The offset 6.0000 mm is larger than the radius 5.0000 mm of the arc");
  EXPECT_EQ(first_alarm(compensated(program.actions()))->span.line, 3U);
}

Program two_lobes(double offset) {
  return Program()
      .from(10, -30)
      .left(offset)
      .to(10, -20)
      .to(10, 0)
      .ccw(8, 6, 0, 0)
      .ccw(6, 0, 16, 0)
      .to(6, -20);
}

// DGS-354: circles of radius 7 around (0,0) and (16,0) miss each other by 2 mm. DGS-355: those of radius 9
// meet.
TEST(CompensationAlarms, NoCrossover) {
  // The last line starts the compensation again and ends 3 mm left of its own end.
  EXPECT_EQ(compensated_path(two_lobes(3)),
            "7,-20 | 7,0 | ccw 5.6,4.2 c 0,0 r 7 | alarm no-crossover | 9,-19.95");
  EXPECT_EQ(message_of_first(two_lobes(3)),
            "The offset paths miss each other by 2.000 mm at X8.000 Y6.000 with an offset of 3.000 mm");
  EXPECT_EQ(first_alarm(compensated(two_lobes(1).actions())), nullptr);
  EXPECT_NE(compensated_path(two_lobes(1)).find("ccw 8,4.123 c 0,0 r 9 | ccw"), std::string::npos);
}

// The parallels of line and circle meet at 28.168; of the first degree of the arc nothing is left behind it.
TEST(CompensationAlarms, ArcUsedUpByTheCornerBeforeIt) {
  const Vec2 end = Vec2{40, 0} + 10.0 * direction_at(176.0);
  const Program program = left2().to(10, 0).to(30, 0).cw(end.x, end.y, 40, 0);
  EXPECT_EQ(compensated_path(program), "10,2 | 30,2 | alarm no-crossover");
  EXPECT_EQ(message_of_first(program),
            "Nothing is left of the arc behind the corner at X30.000 Y0.000 with an offset of 2.000 mm");
  EXPECT_EQ(first_alarm(compensated(program.actions()))->span.line, 3U);
}

TEST(CompensationAlarms, ArcUsedUpByTheCornerBehindIt) {
  // The same corner, run through from the other side: the arc ends at (30,0), a line leaves along -X.
  const Vec2 start = Vec2{40, 0} + 10.0 * direction_at(176.0);
  const Program program = Program()
                              .right(2)
                              .from(start.x + 1, start.y + 20)
                              .to(start.x, start.y)
                              .ccw(30, 0, 40, 0)
                              .to(10, 0)
                              .to(10, -10);
  const std::vector<Action> out = compensated(program.actions());
  ASSERT_NE(first_alarm(out), nullptr);
  EXPECT_EQ(first_alarm(out)->span.line, 2U);
  EXPECT_EQ(message_of(*first_alarm(out)),
            "Nothing is left of the arc before the corner at X30.000 Y0.000 with an offset of 2.000 mm");
}

// DGS-304, 322.
TEST(CompensationAlarms, ChangeOfSideOrAmount) {
  EXPECT_EQ(compensated_path(left2().to(10, 0).right(2).to(20, 0)), "10,2 | alarm side-change");
  EXPECT_EQ(compensated_path(left2().to(10, 0).to(20, 0).left(4).to(30, 0)),
            "10,2 | 20,2 | alarm side-change");
  EXPECT_EQ(message_of_first(left2().to(10, 0).to(20, 0).right(4).to(30, 0)),
            "The offset changes from 2.000 mm left to 4.000 mm right");
  EXPECT_EQ(compensated_path(left2().to(10, 0).right(-2).to(20, 0)), "10,2 | 20,2");
}

TEST(CompensationAlarms, ChangeOfPlane) {
  std::vector<Action> actions = left2().to(10, 0).to(20, 0).to(30, 0).actions();
  std::get<Move>(actions.back().what).plane = kPlaneZX;
  const std::vector<Action> out = compensated(actions);
  EXPECT_EQ(toolpath_test::text_of(out), "10,2 | 20,2 | alarm side-change");
  EXPECT_EQ(message_of(*first_alarm(out)), "The plane of the compensation changes from XY to ZX");
}

TEST(CompensationAlarms, TheNextMovesGoOnFromTheTool) {
  // The arc is dropped; the following line starts again from where the tool is, arcs before it run as
  // programmed.
  EXPECT_EQ(compensated_path(
                Program().left(6).to(10, 0).to(20, 0).ccw(25, 5, 20, 5).to(25, 20).to(0, 20).none().to(0, 0)),
            "10,6 | 20,6 | alarm inner-radius | 25,14 | 0,14 | 0,0");
  EXPECT_EQ(compensated_path(
                Program().left(6).to(10, 0).to(20, 0).ccw(25, 5, 20, 5).cw(30, 10, 30, 5).none().to(30, 40)),
            "10,6 | 20,6 | alarm inner-radius | 25,5 | cw 30,10 c 30,5 r 5 | 30,40");
}

TEST(CompensationAlarms, AlarmsOfTheInterpreterKeepTheirPlace) {
  Program program;
  program.left(2).to(10, 0).to(30, 0).add(Alarm{&toolpath_test::kNoCrossover, {}, {}, {}});
  EXPECT_EQ(compensated_path(program), "10,2 | 30,2 | alarm no-crossover");
}

// ---- hand-through

TEST(Compensation, HandsActionsThroughWithoutACopyWhileOff) {
  const Program program = Program().to(10, 0).dwell().cw(20, 10, 20, 0).left(2).z(1).end();
  RadiusCompensationPass pass(compensation_policy());
  ListSource source(program.actions());
  for (const Action& action : program.actions()) EXPECT_EQ(pass.next(source), &action);
  EXPECT_EQ(pass.next(source), nullptr);
  EXPECT_EQ(pass.next(source), nullptr);
}

TEST(Compensation, HandsActionsThroughAgainAfterItsEnd) {
  const Program program = left2().to(10, 0).to(20, 0).none().to(30, 0).to(40, 0);
  RadiusCompensationPass pass(compensation_policy());
  ListSource source(program.actions());
  for (int i = 0; i < 3; ++i) EXPECT_NE(pass.next(source), nullptr);
  EXPECT_EQ(pass.next(source), &program.actions().back());
}

TEST(Compensation, ResetForgetsTheProgram) {
  const Program program = left2().to(10, 0).to(20, 0);
  RadiusCompensationPass pass(compensation_policy());
  ListSource source(program.actions());
  for (int i = 0; i < 2; ++i) pass.next(source);
  pass.reset();
  EXPECT_EQ(toolpath_test::text_of(toolpath_test::run_through(pass, program.actions())), "10,2 | 20,2");
}

}  // namespace
}  // namespace kerf
