#include "toolpath/corner_override.hpp"

#include <cmath>

#include "toolpath/compensated_move.hpp"

namespace kerf {
namespace {

constexpr double kRoundingDeg = 1e-6;

/// Length of the path in the plane, mm.
double way_of(const Move& move) {
  return length_of(segment_of(move, move.plane));
}

/// The first `part` of a move and the rest of it.
std::pair<Move, Move> cut(const Move& move, double part) {
  Move first = move;
  Move rest = move;
  AxisVector at = move.end - move.start;
  at *= part;
  at += move.start;
  if (is_arc(move.mode)) {
    const Vec2 center{move.arc.center[0], move.arc.center[1]};
    const Vec2 from = in_plane(move.start, move.plane) - center;
    const double to = distance(in_plane(move.end, move.plane), center);
    const double radius = length(from) + (to - length(from)) * part;
    first.arc.sweep = move.arc.sweep * part;
    rest.arc.sweep = move.arc.sweep - first.arc.sweep;
    rest.arc.radius = radius;
    at = with_point(at, move.plane, center + radius * rotated(unit(from), first.arc.sweep));
  }
  first.end = rest.start = at;
  first.exact_stop = rest.from_rest = false;
  first.inner_corner_deg = 0.0;
  return {first, rest};
}

/// An arc put into a corner, with the tool on its inside.
bool is_rounded_inner_corner(const Move& move) {
  const Side side = move.compensation.side;
  const bool left = (side == Side::left) == (move.compensation.amount > 0.0);
  return move.rounds_corner && is_arc(move.mode) && side != Side::none &&
         left == (move.mode == MoveMode::counterclockwise);
}

}  // namespace

bool CornerOverridePass::is_slowed(const Move& move) const {
  if (move.path_mode == PathMode::corner_override && is_rounded_inner_corner(move)) return true;
  return move.path_mode == PathMode::corner_override && move.inner_corner_deg > 0.0 &&
         move.inner_corner_deg <= policy_.widest_deg + kRoundingDeg;
}

void CornerOverridePass::add(const Origin& origin, const Move& move) {
  Action& action = out_.push();
  action.origin = origin;
  action.what = move;
}

void CornerOverridePass::push(const Origin& origin, const Move& move) {
  const double slower = policy_.percent / 100.0;
  const double way = way_of(move);
  Move slow = move;
  if (way > policy_.length_mm && !is_rounded_inner_corner(move)) {
    const auto [first, rest] = cut(move, 1.0 - policy_.length_mm / way);
    add(origin, first);
    slow = rest;
  }
  slow.feed *= slower;
  add(origin, slow);
}

}  // namespace kerf
