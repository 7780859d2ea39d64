// Every corner of the tool radius compensation that the DGSHAPE table of statements lists (DGS-328 to
// DGS-369): the expected paths are the numbers of the statements. Each is also run mirrored, turned and in
// the other planes.

#include <gtest/gtest.h>
#include <ostream>

#include "toolpath_compensation_policy.hpp"

namespace kerf {
namespace {

using toolpath_test::compensated;
using toolpath_test::Program;
using toolpath_test::text_of;

struct CornerCase {
  const char* name;
  StartType type;
  Program program;
  const char* expected;
};

void PrintTo(const CornerCase& corner, std::ostream* out) {
  *out << corner.name;
}

Program begin() {
  return Program().left(2);
}

// (0,0) to (10,0), up to (10,10), then a clockwise quarter around (20,10) to (20,20).
Program quarter() {
  return begin().to(10, 0).to(10, 10).cw(20, 20, 20, 10);
}

std::vector<CornerCase> corner_cases() {
  constexpr StartType A = StartType::A;
  constexpr StartType B = StartType::B;
  return {
      {"DGS_328", A, begin().to(10, 0).to(10, 20), "8,0 | 8,20"},
      {"DGS_329", A, begin().to(10, 0).cw(20, 10, 20, 0), "8,0 | cw 20,12 c 20,0 r 12"},
      {"DGS_330", A, begin().to(10, 0).to(20, -10), "11.414,1.414 | 21.414,-8.586"},
      {"DGS_331", B, begin().to(10, 0).to(20, -10), "10.828,2 | 21.414,-8.586"},
      {"DGS_332", A, begin().to(10, 0).cw(0, -10, 0, 0), "12,0 | cw 0,-12 c 0,0 r 12"},
      {"DGS_333", B, begin().to(10, 0).cw(0, -10, 0, 0), "12,2 | 12,0 | cw 0,-12 c 0,0 r 12"},
      {"DGS_334", A, begin().to(10, 0).to(0, -10), "11.414,-1.414 | 1.414,-11.414"},
      {"DGS_335", A, begin().to(10, 0).cw(-10, 0, 0, 10),
       "11.414,-1.414 | cw -11.414,-1.414 c 0,10 r 16.142"},
      {"DGS_336", B, begin().to(10, 0).to(0, -10), "12,2 | 12.828,0 | 1.414,-11.414"},
      {"DGS_337", B, begin().to(10, 0).cw(-10, 0, 0, 10),
       "12,2 | 12.828,0 | 11.414,-1.414 | cw -11.414,-1.414 c 0,10 r 16.142"},
      {"DGS_338", B, begin().to(60, 0).to(0, -0.5), "60.017,-2 | 0.017,-2.5"},
      {"DGS_339", A, begin().to(10, 0).to(30, 0).ccw(40, 10, 30, 10), "10,2 | 30,2 | ccw 38,10 c 30,10 r 8"},
      {"DGS_340", A, begin().to(10, 0).to(30, 0).to(30, 20), "10,2 | 28,2 | 28,20"},
      {"DGS_340_right", A, Program().right(2).to(10, 0).to(30, 0).to(30, -20), "10,-2 | 28,-2 | 28,-20"},
      {"DGS_341", A, begin().to(10, 0).to(30, 0).cw(40, 10, 40, 0), "10,2 | 28.168,2 | cw 40,12 c 40,0 r 12"},
      {"DGS_342", A, quarter().to(20, 40), "8,0 | 8,10 | cw 18,21.832 c 20,10 r 12 | 18,40"},
      {"DGS_343", A, quarter().cw(30, 30, 30, 20),
       "8,0 | 8,10 | cw 18.144,21.856 c 20,10 r 12 | cw 30,32 c 30,20 r 12"},
      {"DGS_344", A, begin().to(10, 0).to(60, 0).to(0, 0.5), "10,2 | 60,2 | 59.983,-2 | -0.017,-1.5"},
      {"DGS_345", A, begin().to(10, 0).to(30, 0).to(40, -10), "10,2 | 30.828,2 | 41.414,-8.586"},
      {"DGS_345_right_angle", A, begin().to(10, 0).to(30, 0).to(30, -20), "10,2 | 32,2 | 32,-20"},
      {"DGS_346", A, begin().to(10, 0).to(30, 0).cw(20, -10, 20, 0),
       "10,2 | 32,2 | 32,0 | cw 20,-12 c 20,0 r 12"},
      {"DGS_347", A, quarter().to(20, 0), "8,0 | 8,10 | cw 20,22 c 20,10 r 12 | 22,22 | 22,0"},
      {"DGS_348", A, quarter().cw(10, 10, 10, 20),
       "8,0 | 8,10 | cw 20,22 c 20,10 r 12 | 22,22 | 22,20 | cw 10,8 c 10,20 r 12"},
      {"DGS_349", A, begin().to(10, 0).to(30, 0).to(20, -10), "10,2 | 32,2 | 32.828,0 | 21.414,-11.414"},
      {"DGS_350", A, quarter().to(10, 10),
       "8,0 | 8,10 | cw 20,22 c 20,10 r 12 | 22,22 | 22.828,20 | 11.414,8.586"},
      {"DGS_351", A, begin().to(10, 0).to(30, 0).cw(10, 0, 20, 10),
       "10,2 | 32,2 | 32.828,0 | 31.414,-1.414 | cw 8.586,-1.414 c 20,10 r 16.142"},
      {"DGS_352", A, quarter().cw(0, 20, 10, 30),
       "8,0 | 8,10 | cw 20,22 c 20,10 r 12 | 22,22 | 22.828,20 | 21.414,18.586 | "
       "cw -1.414,18.586 c 10,30 r 16.142"},
      {"DGS_357", A, begin().to(10, 0).to(30, 0).none().empty_block().to(40, 0), "10,2 | 30,2 | 40,0"},
      {"DGS_358", A, begin().to(10, 0).to(30, 0).none().to(30, 20), "10,2 | 30,2 | 30,20"},
      {"DGS_359", A, quarter().none().to(20, 40), "8,0 | 8,10 | cw 20,22 c 20,10 r 12 | 20,40"},
      {"DGS_360", A, begin().to(10, 0).to(30, 0).none().to(40, -10), "10,2 | 30,2 | 40,-10"},
      {"DGS_361", A, quarter().none().to(20, 0), "8,0 | 8,10 | cw 20,22 c 20,10 r 12 | 20,0"},
      {"DGS_362", B, begin().to(10, 0).to(30, 0).none().to(40, -10), "10,2 | 30.828,2 | 40,-10"},
      {"DGS_363", B, quarter().none().to(20, 0), "8,0 | 8,10 | cw 20,22 c 20,10 r 12 | 22,22 | 20,0"},
      {"DGS_364", A, begin().to(10, 0).to(30, 0).none().to(20, -10), "10,2 | 30,2 | 20,-10"},
      {"DGS_365", B, begin().to(10, 0).to(30, 0).none().to(20, -10), "10,2 | 32,2 | 32.828,0 | 20,-10"},
      {"DGS_366", A, quarter().none().to(10, 10), "8,0 | 8,10 | cw 20,22 c 20,10 r 12 | 10,10"},
      {"DGS_367", B, quarter().none().to(10, 10),
       "8,0 | 8,10 | cw 20,22 c 20,10 r 12 | 22,22 | 22.828,20 | 10,10"},
      {"DGS_368", B, begin().to(10, 0).to(60, 0).none().to(0, -0.5), "10,2 | 60,2 | 0,-0.5"},
      {"DGS_369", A, begin().to(10, 0).to(30, 0).end(), "10,2 | 30,2 | end"},
      // A slot there and back: an exact reversal is the sharpest outer corner.
      {"reversal", A, begin().to(10, 0).to(30, 0).to(10, 0), "10,2 | 32,2 | 32,-2 | 10,-2"},
  };
}

class CompensationCorner : public ::testing::TestWithParam<CornerCase> {};

INSTANTIATE_TEST_SUITE_P(Statements, CompensationCorner, ::testing::ValuesIn(corner_cases()),
                         [](const auto& corner) { return std::string(corner.param.name); });

TEST_P(CompensationCorner, HasThePathOfTheStatement) {
  EXPECT_EQ(text_of(compensated(GetParam().program.actions(), GetParam().type)), GetParam().expected);
}

// Turns every move by an angle around the origin, after reflecting it at the first axis if asked to, and puts
// it into another plane.
std::vector<Action> transformed(std::vector<Action> actions, bool mirror, double angle_deg,
                                const Plane& plane) {
  const auto place = [&](Vec2 p) { return rotated({p.x, mirror ? -p.y : p.y}, angle_deg); };
  const auto place_position = [&](const AxisVector& position) {
    return with_point({}, plane, place(in_plane(position, kPlaneXY)));
  };
  for (Action& action : actions) {
    Move* move = std::get_if<Move>(&action.what);
    if (move == nullptr) continue;
    move->start = place_position(move->start);
    move->end = place_position(move->end);
    move->commanded = place_position(move->commanded);
    move->plane = plane;
    const Vec2 center = place({move->arc.center[0], move->arc.center[1]});
    if (is_arc(move->mode)) move->arc.center = {center.x, center.y};
    if (!mirror) continue;
    move->arc.sweep = -move->arc.sweep;
    if (is_arc(move->mode))
      move->mode = move->mode == MoveMode::clockwise ? MoveMode::counterclockwise : MoveMode::clockwise;
    Side& side = move->compensation.side;
    if (side != Side::none) side = side == Side::left ? Side::right : Side::left;
  }
  return actions;
}

void expect_transforms_alike(const CornerCase& corner, bool mirror, double angle_deg, const Plane& plane) {
  const std::vector<Action>& program = corner.program.actions();
  EXPECT_EQ(text_of(compensated(transformed(program, mirror, angle_deg, plane), corner.type)),
            text_of(transformed(compensated(program, corner.type), mirror, angle_deg, plane)));
}

TEST_P(CompensationCorner, MirrorsWithTheProgram) {
  expect_transforms_alike(GetParam(), true, 0.0, kPlaneXY);
}

TEST_P(CompensationCorner, TurnsWithTheProgram) {
  expect_transforms_alike(GetParam(), false, 33.7, kPlaneXY);
  expect_transforms_alike(GetParam(), true, 211.3, kPlaneXY);
}

TEST_P(CompensationCorner, IsTheSameInTheOtherPlanes) {
  expect_transforms_alike(GetParam(), false, 0.0, kPlaneZX);
  expect_transforms_alike(GetParam(), false, 0.0, kPlaneYZ);
}

TEST_P(CompensationCorner, NegativeAmountOnTheOtherSideIsTheSame) {
  std::vector<Action> program = GetParam().program.actions();
  for (Action& action : program)
    if (Move* move = std::get_if<Move>(&action.what); move && move->compensation.side != Side::none)
      move->compensation = {move->compensation.side == Side::left ? Side::right : Side::left, -2.0};
  EXPECT_EQ(text_of(compensated(program, GetParam().type)), GetParam().expected);
}

}  // namespace
}  // namespace kerf
