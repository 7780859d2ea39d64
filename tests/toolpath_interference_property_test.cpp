// Random closed contours, many of their blocks shorter than the tool: with the interference check on "avoid"
// the tool never cuts into a block that the check looks at, or there is an alarm; and the result does not
// depend on how the plane is turned or mirrored.

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

#include "geometry/planar_segment.hpp"
#include "toolpath_compensation_policy.hpp"

namespace kerf {
namespace {

using toolpath_test::Program;

constexpr AlarmKind kInterference{"T", "interference", "", "", "", Severity::alarm};

RadiusCompensationPolicy policy_with(InterferenceCheck check) {
  RadiusCompensationPolicy policy = toolpath_test::compensation_policy();
  policy.small_angle_deg = 0.0;
  policy.blocks_without_motion = 4;
  policy.small_arcs_turn_over = true;
  policy.stops_before_fault = true;
  policy.joints_belong_to_next = true;
  policy.interference = check;
  policy.interference_alarm = &kInterference;
  return policy;
}

/// A straight line or an arc.
struct Block {
  Vec2 start;
  Vec2 end;
  bool arc = false;
  Vec2 center;
  double sweep_deg = 0.0;
};

double distance_from(const Block& block, Vec2 point) {
  const double to_ends = std::min(distance(point, block.start), distance(point, block.end));
  if (!block.arc) {
    const Vec2 along = unit(block.end - block.start);
    const double at = dot(point - block.start, along);
    if (at < 0.0 || at > distance(block.start, block.end)) return to_ends;
    return std::abs(cross(along, point - block.start));
  }
  const double turn = ahead_deg(block.start - block.center, point - block.center, block.sweep_deg < 0.0);
  if ((turn < 0.0 ? turn + 360.0 : turn) > std::abs(block.sweep_deg)) return to_ends;
  return std::abs(distance(point, block.center) - distance(block.start, block.center));
}

/// Blocks with turns to both sides, some of them short.
std::vector<Block> random_blocks(std::mt19937& random, double tool) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<Block> blocks;
  Vec2 at{};
  double heading = between(-180, 180);
  const int count = static_cast<int>(between(6, 14));
  for (int i = 0; i < count; ++i) {
    if (i > 0) heading += between(-80, 80);
    const bool first = i == 0 || i + 1 == count;
    const double length = first || between(0, 1) < 0.6 ? between(4, 12) * tool : between(0.05, 2.0) * tool;
    Block block;
    block.start = at;
    if (first || between(0, 1) < 0.6) {
      block.end = at + length * direction_at(heading);
    } else {
      const double radius = between(0.3, 6.0) * tool;
      const bool clockwise = between(0, 1) < 0.5;
      block.arc = true;
      block.sweep_deg = (clockwise ? -1.0 : 1.0) * std::min(45.0, degrees(length / radius));
      const Vec2 to_center = radius * direction_at(heading + (clockwise ? -90.0 : 90.0));
      block.center = at + to_center;
      block.end = block.center - rotated(to_center, block.sweep_deg);
      heading += block.sweep_deg;
    }
    at = block.end;
    blocks.push_back(block);
  }
  return blocks;
}

Program program_of(const std::vector<Block>& blocks, Side side, double tool) {
  Program program;
  const Vec2 before = blocks[0].start - 5.0 * tool * unit(blocks[0].end - blocks[0].start);
  program.from(before.x, before.y).side(side, tool).to(blocks[0].start.x, blocks[0].start.y);
  for (const Block& block : blocks) {
    if (!block.arc)
      program.to(block.end.x, block.end.y);
    else if (block.sweep_deg < 0.0)
      program.cw(block.end.x, block.end.y, block.center.x, block.center.y);
    else
      program.ccw(block.end.x, block.end.y, block.center.x, block.center.y);
  }
  const Block& last = blocks.back();
  const Vec2 behind = last.end + 5.0 * tool * unit(last.end - last.start);
  return program.none().to(behind.x, behind.y);
}

std::vector<Action> run(const Program& program, InterferenceCheck check) {
  RadiusCompensationPass pass(policy_with(check));
  return toolpath_test::run_through(pass, program.actions());
}

bool has_alarm(const std::vector<Action>& actions) {
  return std::any_of(actions.begin(), actions.end(),
                     [](const Action& action) { return std::holds_alternative<Alarm>(action.what); });
}

Vec2 point_at(const Move& move, double part) {
  const Vec2 start = in_plane(move.start, kPlaneXY);
  if (!is_arc(move.mode)) return start + part * (in_plane(move.end, kPlaneXY) - start);
  const Vec2 center{move.arc.center[0], move.arc.center[1]};
  return center + rotated(start - center, part * move.arc.sweep);
}

/// The deepest cut of a path into the blocks that the check sees together with each of its moves. mm
double deepest_cut(const std::vector<Action>& path, const std::vector<Block>& blocks, double tool) {
  double deepest = 0.0;
  for (const Action& action : path) {
    const Move& move = std::get<Move>(action.what);
    // Block 1 of the program leads to the start, so block n + 2 is blocks[n].
    const std::size_t own = action.origin.block < 2 ? 0 : action.origin.block - 2;
    if (action.origin.block < 2 || own >= blocks.size()) continue;
    for (std::size_t seen = own == 0 ? 0 : own - 1; seen < std::min(own + 2, blocks.size()); ++seen) {
      for (int i = 0; i <= 24; ++i) {
        deepest = std::max(deepest, tool - distance_from(blocks[seen], point_at(move, i / 24.0)));
      }
    }
  }
  return deepest;
}

int contours() {
  const char* wanted = std::getenv("KERF_CONTOURS");
  return wanted == nullptr ? 2000 : std::atoi(wanted);
}

TEST(InterferenceProperty, AvoidingRarelyCutsIntoWhatTheCheckSees) {
  std::mt19937 random(1913);
  int passed = 0;
  int cutting = 0;
  int worst_of = -1;
  double worst = 0.0;
  for (int i = 0; i < contours(); ++i) {
    const double tool = std::pow(10.0, std::uniform_real_distribution<double>(-1.0, 2.0)(random));
    const auto blocks = random_blocks(random, tool);
    const Side side = i % 2 == 0 ? Side::left : Side::right;
    const auto path = run(program_of(blocks, side, tool), InterferenceCheck::avoid);
    if (has_alarm(path)) continue;
    ++passed;
    const double cut = deepest_cut(path, blocks, tool);
    if (cut > worst) {
      worst = cut;
      worst_of = i;
    }
    cutting += cut > 0.001 ? 1 : 0;
  }
  // The check looks at the points of two corners, as the controller does: now and then a block is so short
  // that the tool reaches past them.
  EXPECT_LE(cutting, passed / 500) << "deepest cut " << worst << " mm, contour " << worst_of;
  EXPECT_GT(passed, contours() / 10) << "too many contours give an alarm to prove anything";
  std::printf("%d of %d contours without an alarm, %d cut; deepest %.3g mm (contour %d)\n", passed,
              contours(), cutting, worst, worst_of);
}

}  // namespace
}  // namespace kerf
