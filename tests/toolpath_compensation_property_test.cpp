// Random contours of lines and arcs: the compensated path keeps its distance from what was programmed.

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "geometry/planar_segment.hpp"
#include "toolpath_compensation_policy.hpp"

namespace kerf {
namespace {

using toolpath_test::compensated;
using toolpath_test::Program;

constexpr double kOffset = 2.0;

PlanarSegment segment_of(const Move& move) {
  const Vec2 start = in_plane(move.start, kPlaneXY);
  const Vec2 end = in_plane(move.end, kPlaneXY);
  if (!is_arc(move.mode)) return straight(start, end);
  return curved(start, end, {move.arc.center[0], move.arc.center[1]}, move.arc.radius, move.arc.sweep);
}

Vec2 point_at(const PlanarSegment& segment, double part) {
  if (!segment.is_arc) return segment.start + part * (segment.end - segment.start);
  return segment.center + rotated(segment.start - segment.center, part * segment.sweep_deg);
}

// Distance from the endless line or the whole circle, positive to the left of travel.
double left_distance(const PlanarSegment& segment, Vec2 point) {
  if (!segment.is_arc) return cross(unit(segment.end - segment.start), point - segment.start);
  const double outward = distance(point, segment.center) - segment.radius;
  return segment.sweep_deg < 0.0 ? outward : -outward;
}

// Distance from the segment with its ends.
double distance_from(const PlanarSegment& segment, Vec2 point) {
  const double to_ends = std::min(distance(point, segment.start), distance(point, segment.end));
  if (!segment.is_arc) {
    const Vec2 along = unit(segment.end - segment.start);
    const double at = dot(point - segment.start, along);
    if (at < 0.0 || at > length_of(segment)) return to_ends;
  } else {
    const double turn =
        ahead_deg(segment.start - segment.center, point - segment.center, segment.sweep_deg < 0.0);
    if ((turn < 0.0 ? turn + 360.0 : turn) > std::abs(segment.sweep_deg)) return to_ends;
  }
  return std::abs(left_distance(segment, point));
}

// A start, eight lines and arcs much longer than the offset with turns of up to 120 degrees, and an end.
// Neighbours turn by less than 180 degrees in all, so that they meet at their corner only.
Program random_contour(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Program program;
  program.side(between(0, 1) < 0.5 ? Side::left : Side::right, kOffset);
  double heading = between(-180, 180);
  Vec2 at = between(15, 30) * direction_at(heading);
  program.to(at.x, at.y);
  for (int i = 0; i < 8; ++i) {
    heading += between(-120, 120);
    if (between(0, 1) < 0.5) {
      at += between(20, 40) * direction_at(heading);
      program.to(at.x, at.y);
      continue;
    }
    const bool clockwise = between(0, 1) < 0.5;
    const double turn = (clockwise ? -1.0 : 1.0) * between(15, 28);
    const Vec2 to_center = between(50, 80) * direction_at(heading + (clockwise ? -90.0 : 90.0));
    const Vec2 center = at + to_center;
    at = center - rotated(to_center, turn);
    heading += turn;
    if (clockwise)
      program.cw(at.x, at.y, center.x, center.y);
    else
      program.ccw(at.x, at.y, center.x, center.y);
  }
  at += 20.0 * direction_at(heading + between(-120, 120));
  return program.none().to(at.x, at.y);
}

TEST(CompensationProperty, PathsKeepTheirDistance) {
  std::mt19937 random(41);
  int joints = 0;
  int arcs = 0;
  for (int i = 0; i < 1000; ++i) {
    const Program program = random_contour(random);
    const std::vector<Action>& given = program.actions();
    const std::vector<Action> out = compensated(given, i % 2 == 0 ? StartType::A : StartType::B);
    const double left = std::get<Move>(given[0].what).compensation.side == Side::left ? kOffset : -kOffset;
    std::uint32_t last_block = 0;
    for (const Action& action : out) {
      ASSERT_TRUE(std::holds_alternative<Move>(action.what)) << toolpath_test::text_of(out);
      const std::uint32_t block = action.origin.block;
      const bool is_own = block != last_block;
      last_block = block;
      if (block == 1 || block == given.size()) continue;  // start and end approach and leave
      const PlanarSegment path = segment_of(std::get<Move>(action.what));
      const PlanarSegment programmed = segment_of(std::get<Move>(given[block - 1].what));
      const PlanarSegment next = segment_of(std::get<Move>(given[block].what));
      joints += is_own ? 0 : 1;
      arcs += path.is_arc ? 1 : 0;
      for (double part = 0.0; part <= 1.0; part += 0.125) {
        const Vec2 point = point_at(path, part);
        if (is_own) {
          EXPECT_NEAR(left_distance(programmed, point), left, 1e-6);
        }
        EXPECT_GE(distance_from(programmed, point), kOffset - 1e-6);
        if (block + 1 < given.size()) {
          EXPECT_GE(distance_from(next, point), kOffset - 1e-6);
        }
      }
    }
  }
  EXPECT_GT(joints, 1000);
  EXPECT_GT(arcs, 3000);
}

// Without corners that need anything but points, each block gives one move.
TEST(CompensationProperty, EveryBlockOfAGentleContourGivesOneMove) {
  Program program;
  program.left(kOffset).to(20, 0);
  for (int i = 1; i <= 36; ++i) {
    const Vec2 point = Vec2{20, 0} + 100.0 * (direction_at(10.0 * i) - Vec2{1, 0});
    program.to(point.x, point.y);
  }
  EXPECT_EQ(compensated(program.actions()).size(), program.actions().size());
}

}  // namespace
}  // namespace kerf
