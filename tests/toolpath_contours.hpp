#pragma once
// Contours of straight lines and arcs for property tests of the tool radius compensation: how far a point is
// from them, the actions that command them, and the path of the tool centre that comes of it. The geometry
// here is written for the tests: nothing of it is what the compensation itself calculates with.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "toolpath_compensation_policy.hpp"

namespace kerf::toolpath_test {

/// A straight line or an arc. mm, degrees
struct Block {
  Vec2 start;
  Vec2 end;
  bool arc = false;
  Vec2 center;
  double sweep_deg = 0.0;
};

using Contour = std::vector<Block>;

inline Block line(Vec2 start, Vec2 end) {
  return {start, end, false, {}, 0.0};
}

/// The point on the straight line or on the circle, 0 at the start and 1 at the end.
inline Vec2 point_at(const Block& block, double part) {
  if (!block.arc) return block.start + part * (block.end - block.start);
  const double angle = radians(part * block.sweep_deg);
  const Vec2 arm = block.start - block.center;
  return block.center + Vec2{arm.x * std::cos(angle) - arm.y * std::sin(angle),
                             arm.x * std::sin(angle) + arm.y * std::cos(angle)};
}

inline Block arc_around(Vec2 start, Vec2 center, double sweep_deg) {
  Block block{start, start, true, center, sweep_deg};
  block.end = point_at(block, 1.0);
  return block;
}

/// An arc between two points that turns by so much, to the left when positive.
inline Block arc_between(Vec2 start, Vec2 end, double sweep_deg) {
  const Vec2 half = 0.5 * (end - start);
  const Vec2 center = start + half + 1.0 / std::tan(radians(0.5 * sweep_deg)) * left_of(half);
  return {start, end, true, center, sweep_deg};
}

/// Direction of travel.
inline Vec2 direction_of(const Block& block, double part) {
  if (!block.arc) return unit(block.end - block.start);
  const Vec2 arm = unit(point_at(block, part) - block.center);
  return block.sweep_deg < 0.0 ? Vec2{arm.y, -arm.x} : Vec2{-arm.y, arm.x};
}

/// Where the tool's centre is when the tool touches a point of a block from the left (right: negative).
inline Vec2 beside(const Block& block, double part, double left) {
  return point_at(block, part) + left * left_of(direction_of(block, part));
}

inline double length_of(const Block& block) {
  return block.arc ? distance(block.start, block.center) * radians(std::abs(block.sweep_deg))
                   : distance(block.start, block.end);
}

/// The nearest point of a block, 0 at its start and 1 at its end.
inline double nearest_part(const Block& block, Vec2 point) {
  if (!block.arc) {
    const Vec2 way = block.end - block.start;
    const double square = dot(way, way);
    return square > 0.0 ? std::clamp(dot(point - block.start, way) / square, 0.0, 1.0) : 0.0;
  }
  const Vec2 arm = block.start - block.center;
  const Vec2 to = point - block.center;
  double turn = degrees(std::atan2(cross(arm, to), dot(arm, to)));
  if (block.sweep_deg < 0.0) turn = -turn;
  const double sweep = std::abs(block.sweep_deg);
  if (turn < 0.0) turn += 360.0;
  if (turn <= sweep) return turn / sweep;
  return distance(point, block.start) < distance(point, block.end) ? 0.0 : 1.0;
}

inline double distance_from(const Block& block, Vec2 point) {
  const double part = nearest_part(block, point);
  if (part <= 0.0) return distance(point, block.start);
  if (part >= 1.0) return distance(point, block.end);
  if (block.arc) return std::abs(distance(point, block.center) - distance(block.start, block.center));
  return std::abs(cross(unit(block.end - block.start), point - block.start));
}

inline double distance_from(const Contour& contour, Vec2 point) {
  double nearest = HUGE_VAL;
  for (const Block& block : contour) nearest = std::min(nearest, distance_from(block, point));
  return nearest;
}

inline double between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Each power of ten as often as any other.
inline double magnitude_between(std::mt19937& random, double low, double high) {
  return std::pow(10.0, between(random, std::log10(low), std::log10(high)));
}

/// So many contours: few in the daily run, more on demand.
inline int contours(int otherwise) {
  const char* wanted = std::getenv("KERF_CONTOURS");
  return wanted == nullptr ? otherwise : std::atoi(wanted);
}

// ---- the program and the path

inline constexpr AlarmKind kInterference{"T", "interference", "", "", "", Severity::alarm};

/// How a contour is compensated.
struct Cutting {
  Side side = Side::left;
  double tool = 1.0;  ///< mm
  InterferenceCheck check = InterferenceCheck::avoid;
  StartType type = StartType::A;
  Plane plane = kPlaneXY;
  bool dgshape = false;     ///< its rules, which have no check
  bool sees_ahead = false;  ///< the rules of OMRON
};

inline double left_mm(const Cutting& cutting) {
  return cutting.side == Side::left ? cutting.tool : -cutting.tool;
}

/// Its blocks are all seen together.
inline RadiusCompensationPolicy omron_policy(const Cutting& cutting) {
  RadiusCompensationPolicy policy = compensation_policy(StartType::A);
  policy.small_angle_deg = 0.0;
  policy.blocks_without_motion = policy.interference_blocks = 60;
  policy.rounds_acute = true;
  policy.stops_before_fault = true;
  policy.sees_contour_ahead = cutting.check != InterferenceCheck::none;
  policy.interference = cutting.check;
  policy.interference_alarm = &kInterference;
  return policy;
}

/// The rules of MELSEC, or of another controller.
inline RadiusCompensationPolicy policy_of(const Cutting& cutting) {
  if (cutting.sees_ahead) return omron_policy(cutting);
  RadiusCompensationPolicy policy = compensation_policy(cutting.type);
  if (cutting.dgshape) return policy;
  policy.small_angle_deg = 0.0;
  policy.blocks_without_motion = 4;
  policy.type_b_beside = true;
  policy.small_arcs_turn_over = true;
  policy.drops_whole_turns = true;
  policy.stops_before_fault = true;
  policy.joints_belong_to_next = true;
  policy.interference = cutting.check;
  policy.interference_alarm = &kInterference;
  return policy;
}

/// A contour with the points from where the compensation starts and where it ends.
struct Course {
  Contour blocks;
  Vec2 before;
  Vec2 behind;
};

inline Action action_of(const Block& block, const Cutting& cutting, std::uint32_t number) {
  Move move;
  move.mode = !block.arc              ? MoveMode::linear
              : block.sweep_deg < 0.0 ? MoveMode::clockwise
                                      : MoveMode::counterclockwise;
  move.plane = cutting.plane;
  move.compensation = {cutting.side, cutting.tool};
  move.start = with_point({}, cutting.plane, block.start);
  move.end = move.commanded = with_point({}, cutting.plane, block.end);
  move.feed = 600.0;
  if (block.arc)
    move.arc = {{block.center.x, block.center.y}, distance(block.start, block.center), block.sweep_deg};
  Action action{{}, move};
  action.origin.block = action.origin.span.line = number;
  return action;
}

/// Block 1 leads to the contour, block n + 2 is the contour's block n, and the last one leads away.
inline std::vector<Action> actions_of(const Course& course, const Cutting& cutting) {
  std::vector<Action> actions;
  std::uint32_t number = 1;
  actions.push_back(action_of(line(course.before, course.blocks.front().start), cutting, number++));
  for (const Block& block : course.blocks) actions.push_back(action_of(block, cutting, number++));
  Cutting off = cutting;
  off.side = Side::none;
  actions.push_back(action_of(line(course.blocks.back().end, course.behind), off, number));
  return actions;
}

/// A piece of the path of the tool centre.
struct Way {
  Block shape;
  std::size_t block = 0;  ///< of the program, as above
};

struct ToolPath {
  std::vector<Way> ways;
  std::size_t alarm_block = 0;  ///< 0: there is none
  const AlarmKind* alarm = nullptr;
};

inline Block block_of(const Move& move) {
  Block block = line(in_plane(move.start, move.plane), in_plane(move.end, move.plane));
  block.arc = is_arc(move.mode);
  block.center = {move.arc.center[0], move.arc.center[1]};
  block.sweep_deg = move.arc.sweep;
  return block;
}

/// Up to the first alarm.
inline ToolPath tool_path(const Course& course, const Cutting& cutting) {
  RadiusCompensationPass pass(policy_of(cutting));
  const std::vector<Action> actions = actions_of(course, cutting);
  ListSource source(actions);
  ToolPath path;
  while (const Action* action = pass.next(source)) {
    if (const Alarm* alarm = std::get_if<Alarm>(&action->what)) {
      path.alarm = alarm->kind;
      path.alarm_block = action->origin.block;
      break;
    }
    path.ways.push_back({block_of(std::get<Move>(action->what)), action->origin.block});
  }
  return path;
}

/// Whether a piece of the path belongs to the contour, and to which of its blocks.
inline bool is_of_contour(const Way& way, const Course& course) {
  return way.block >= 2 && way.block < course.blocks.size() + 2;
}

/// The deepest cut of a path into the blocks that the check sees together with each of its pieces: the block
/// it belongs to, the one before and the one behind. mm
inline double deepest_cut_seen(const ToolPath& path, const Course& course, double tool) {
  double deepest = 0.0;
  const std::size_t count = course.blocks.size();
  for (const Way& way : path.ways) {
    if (!is_of_contour(way, course)) continue;
    const std::size_t own = way.block - 2;
    for (std::size_t seen = own == 0 ? 0 : own - 1; seen < std::min(own + 2, count); ++seen) {
      for (int i = 0; i <= 24; ++i)
        deepest = std::max(deepest, tool - distance_from(course.blocks[seen], point_at(way.shape, i / 24.0)));
    }
  }
  return deepest;
}

inline double distance_from(const ToolPath& path, Vec2 point) {
  double nearest = HUGE_VAL;
  for (const Way& way : path.ways) nearest = std::min(nearest, distance_from(way.shape, point));
  return nearest;
}

/// How far the points of one path are from another path at most. mm
inline double farthest_from(const ToolPath& other, const ToolPath& path) {
  double farthest = 0.0;
  for (const Way& way : path.ways) {
    for (int i = 0; i <= 12; ++i)
      farthest = std::max(farthest, distance_from(other, point_at(way.shape, i / 12.0)));
  }
  return farthest;
}

/// The same path, into whatever pieces it is divided, when this is 0. mm
inline double difference_between(const ToolPath& a, const ToolPath& b) {
  return std::max(farthest_from(a, b), farthest_from(b, a));
}

/// Any cutting: both sides and types, the three planes.
inline Cutting random_cutting(std::mt19937& random, InterferenceCheck check, double tool) {
  static constexpr Plane kPlanes[] = {kPlaneXY, kPlaneZX, kPlaneYZ};
  Cutting cutting;
  cutting.check = check;
  cutting.tool = tool;
  cutting.side = between(random, 0, 1) < 0.5 ? Side::left : Side::right;
  cutting.type = between(random, 0, 1) < 0.5 ? StartType::A : StartType::B;
  cutting.plane = kPlanes[random() % 3];
  return cutting;
}

/// An open chain of blocks with turns to both sides, many of them shorter than the tool.
inline Course random_chain(std::mt19937& random, double tool) {
  Course course;
  Vec2 at{};
  double heading = between(random, -180, 180);
  const int count = static_cast<int>(between(random, 6, 14));
  for (int i = 0; i < count; ++i) {
    if (i > 0) heading += between(random, -80, 80);
    const bool outermost = i == 0 || i + 1 == count;
    const bool is_long = outermost || between(random, 0, 1) < 0.6;
    const double length = tool * (is_long ? between(random, 4, 12) : between(random, 0.05, 2.0));
    if (outermost || between(random, 0, 1) < 0.6) {
      course.blocks.push_back(line(at, at + length * direction_at(heading)));
    } else {
      const double radius = between(random, 0.3, 6.0) * tool;
      const double side = between(random, 0, 1) < 0.5 ? -1.0 : 1.0;
      const double sweep = side * std::min(45.0, degrees(length / radius));
      course.blocks.push_back(arc_around(at, at + radius * direction_at(heading + side * 90.0), sweep));
      heading += sweep;
    }
    at = course.blocks.back().end;
  }
  course.before = course.blocks[0].start - 5.0 * tool * direction_of(course.blocks[0], 0.0);
  course.behind = at + 5.0 * tool * direction_of(course.blocks.back(), 1.0);
  return course;
}

}  // namespace kerf::toolpath_test
