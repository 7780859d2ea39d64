#include "execute/normal_line.hpp"

#include <cmath>

#include "geometry/vec2.hpp"

namespace kerf {
namespace {

constexpr double kNoWay = 1e-6;        // mm
constexpr double kRoundingDeg = 1e-7;  // degrees
constexpr double kLeastTurn = 1e-4;    // degrees; the least increment of the axis: less is no turn

Vec2 plane_point(const AxisVector& position, const Plane& plane) {
  return {position[plane.first], position[plane.second]};
}

Vec2 start_direction(const Move& move) {
  const Vec2 start = plane_point(move.start, move.plane);
  if (!is_arc(move.mode)) return plane_point(move.end, move.plane) - start;
  const Vec2 outward = start - Vec2{move.arc.center[0], move.arc.center[1]};
  return move.arc.sweep < 0.0 ? -left_of(outward) : left_of(outward);
}

double way_of(const Move& move) {
  if (is_arc(move.mode)) return 2.0 * move.arc.radius;
  return distance(plane_point(move.start, move.plane), plane_point(move.end, move.plane));
}

/// Whether the tool points to the centre of the arc.
bool points_inwards(const Move& move) {
  return (move.arc.sweep > 0.0) == (move.normal_line == Side::left);
}

/// The way a joint is turned; `turn` is the shorter way, from above -180 to 180.
NormalTurn turn_one_way(double turn, Side side, double least) {
  const double ahead = turn < 0.0 ? turn + 360.0 : turn;  // counterclockwise
  const double behind = 360.0 - ahead;                    // clockwise
  const bool left = side == Side::left;
  const double wanted = left ? behind : ahead;
  if (wanted > 180.0 + least + kRoundingDeg) return {0.0, 0.0, true};
  return {left ? -wanted : wanted, 0.0, false};
}

}  // namespace

bool has_direction(const Move& move) {
  return is_arc(move.mode) || way_of(move) > kNoWay;
}

NormalTurn normal_turn(const Move& move, double angle_deg, bool first, const NormalLinePolicy& policy) {
  if (!has_direction(move) || way_of(move) < policy.least_way_mm - kNoWay) return {};
  const double square = move.normal_line == Side::left ? 90.0 : -90.0;
  double turn = std::remainder(angle_of_deg(start_direction(move)) + square - angle_deg, 360.0);
  if (turn <= -180.0 + kRoundingDeg) turn += 360.0;
  NormalTurn result;
  if (first) {
    result.before = turn;
  } else if (std::abs(turn) >= policy.least_angle_deg - kRoundingDeg && std::abs(turn) >= kLeastTurn) {
    result = policy.one_way ? turn_one_way(turn, move.normal_line, policy.least_angle_deg)
                            : NormalTurn{turn, 0.0, false};
  }
  if (!is_arc(move.mode)) return result;
  result.during = move.arc.sweep;
  if (policy.one_way && points_inwards(move) && move.arc.radius < policy.tool_radius_mm)
    result.wrong_way = true;
  return result;
}

}  // namespace kerf
