// Straight blocks that follow each other gently take a short way through the tool radius compensation. It
// must give what the whole way gives, which an action between the blocks makes them take.

#include <gtest/gtest.h>
#include <random>

#include "toolpath/radius_compensation.hpp"
#include "toolpath_compensation_policy.hpp"
#include "toolpath_program.hpp"

namespace kerf {
namespace {

using toolpath_test::ListSource;
using toolpath_test::Program;

std::vector<Move> moves_of(const Program& program, InterferenceCheck check) {
  RadiusCompensationPolicy policy = toolpath_test::compensation_policy();
  policy.interference = check;
  policy.interference_blocks = 4;
  policy.blocks_without_motion = 4;
  RadiusCompensationPass pass(policy);
  ListSource source(program.actions());
  std::vector<Move> moves;
  while (const Action* action = pass.next(source)) {
    if (const Move* move = std::get_if<Move>(&action->what)) moves.push_back(*move);
  }
  return moves;
}

/// Mostly small turns, a sharp one now and then, short blocks among long ones.
void add_contour(Program& program, unsigned seed, bool between) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  double heading = 0.0;
  double x = 30.0;
  double y = 0.0;
  program.left(uniform(0.5, 3.0)).to(20.0, 0.0).to(x, y);
  for (int i = 0; i < 60; ++i) {
    heading += uniform(0.0, 1.0) < 0.1 ? uniform(-100.0, 100.0) : uniform(-12.0, 12.0);
    const double length = uniform(0.0, 1.0) < 0.1 ? uniform(0.2, 2.0) : uniform(4.0, 20.0);
    x += length * std::cos(radians(heading));
    y += length * std::sin(radians(heading));
    program.to(x, y);
    if (between) program.same_block().m(9);
  }
  program.none().to(x, y + 100.0).end();
}

TEST(GentleWay, GivesWhatTheWholeWayGives) {
  std::size_t compared = 0;
  for (const InterferenceCheck check : {InterferenceCheck::alarm, InterferenceCheck::avoid}) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
      Program plain;
      Program held_up;
      add_contour(plain, seed, false);
      add_contour(held_up, seed, true);
      const auto gentle = moves_of(plain, check);
      const auto whole = moves_of(held_up, check);
      ASSERT_EQ(gentle.size(), whole.size()) << seed;
      for (std::size_t i = 0; i < gentle.size(); ++i) {
        ASSERT_EQ(gentle[i].start, whole[i].start) << seed << " " << i;
        ASSERT_EQ(gentle[i].end, whole[i].end) << seed << " " << i;
      }
      compared += gentle.size();
    }
  }
  EXPECT_GT(compared, 10000U);
}

}  // namespace
}  // namespace kerf
