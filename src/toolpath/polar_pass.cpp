#include "toolpath/polar_pass.hpp"

#include <cmath>

#include "execute/polar_plane.hpp"
#include "geometry/polar.hpp"

namespace kerf {
namespace {

constexpr double kNoTurn = 1e-9;  // degrees

/// The direction in which the segment begins, seen from the origin.
double start_angle_deg(const PlanarSegment& segment) {
  const bool at_center = length(segment.start) < kThroughOrigin;
  return angle_of_deg(at_center ? start_tangent(segment) : segment.start);
}

bool has_length(const PlanarSegment& segment) {
  return distance(segment.start, segment.end) > 0.0 || (segment.is_arc && segment.sweep_deg != 0.0);
}

/// Where the axis already stands, not what rounding makes of it.
double chained(double stands, double begins) {
  constexpr double kRounding = 1e-9;  // mm, degrees
  return std::abs(begins - stands) <= kRounding ? stands : begins;
}

}  // namespace

void PolarPass::reset() {
  on_ = false;
  turned_ = shift_ = 0.0;
  elsewhere_ = {};
  out_.clear();
}

void PolarPass::add(const Origin& origin, const Move& move) {
  Action& action = out_.push();
  action.origin = origin;
  action.what = move;
}

void PolarPass::push(const Origin& origin, const Move& move) {
  if (move.polar.form == PolarForm::none) return leave(origin, move);
  if (!on_) enter(move);
  Move flat = move;
  flat.polar.zero += turned_ + shift_;
  linear_ = move.polar.linear;
  const double part = part_before_origin(polar_contour(flat));
  if (part > 0.0) add_part(origin, flat, 0.0, part);
  add_part(origin, flat, part, 1.0);
}

/// Axes that have not moved since the mode was left stand where it left them, and the angle counts from
/// there.
void PolarPass::enter(const Move& move) {
  const Axis rotary = move.polar.rotary;
  AxisVector stands = move.start;
  stands[rotary] = move.polar.zero + turned_;
  for (const Axis axis : elsewhere_) stands[axis] = position_[axis];
  shift_ = stands[rotary] - (move.polar.zero + turned_);
  position_ = stands;
  on_ = true;
}

/// One part of the move that does not run through the centre.
void PolarPass::add_part(const Origin& origin, const Move& flat, double from, double to) {
  PlanarSegment contour = part_of(polar_contour(flat), from, to);
  if (from > 0.0) contour.start = {};
  if (to < 1.0) contour.end = {};
  const PolarPlane& polar = flat.polar;
  const double side = polar.minus ? -1.0 : 1.0;
  const double angle = position_[polar.rotary] - polar.zero;
  const bool from_center = length(contour.start) < kThroughOrigin;
  const bool stays = from_center && !has_length(contour);
  const double turn = stays ? 0.0 : shortest_turn_deg(start_angle_deg(contour) - angle);
  const bool turns = std::abs(turn) > kNoTurn && from_center;
  if (turns) turn_at_center(origin, flat, turn);
  Move move = flat;
  move.polar.form = PolarForm::axes;
  move.start = between(flat.start, flat.end, from);
  move.end = between(flat.start, flat.end, to);
  move.start[polar.linear] = chained(position_[polar.linear], polar.center + side * length(contour.start));
  move.start[polar.rotary] = chained(position_[polar.rotary], polar.zero + angle + turn);
  move.end[polar.linear] = polar.center + side * length(contour.end);
  move.end[polar.rotary] = move.start[polar.rotary] + turn_around_origin_deg(contour);
  if (is_arc(move.mode)) move.arc.sweep = contour.sweep_deg;
  move.from_rest = (flat.from_rest && from <= 0.0) || turns;
  move.exact_stop = flat.exact_stop || to < 1.0;
  add(origin, move);
  position_ = move.end;
}

void PolarPass::turn_at_center(const Origin& origin, const Move& like, double by) {
  const Axis rotary = like.polar.rotary;
  Move turn = like;
  turn.mode = like.mode == MoveMode::rapid ? MoveMode::rapid : MoveMode::linear;
  turn.arc = {};
  turn.polar.form = PolarForm::none;
  turn.rotary_feed = {true, true, rotary, 0.0};
  turn.from_rest = turn.exact_stop = true;
  turn.start = turn.end = position_;
  turn.end[rotary] += by;
  position_ = turn.end;
  add(origin, turn);
}

/// The first moves behind the mode chain with what it left: exactly, and over the turns that the program does
/// not know of.
void PolarPass::leave(const Origin& origin, Move move) {
  const Axis rotary = *policy_.rotary;
  if (on_) {
    const double ahead = position_[rotary] - turned_ - move.start[rotary];
    if (policy_.endless) turned_ += 360.0 * std::round(ahead / 360.0);
    on_ = false;
    elsewhere_ = {linear_, rotary};
  }
  move.start[rotary] += turned_;
  move.end[rotary] += turned_;
  for (const Axis axis : elsewhere_) {
    const bool stays = move.end[axis] == move.start[axis];
    if (!stays || move.start[axis] == position_[axis]) elsewhere_.erase(axis);
    move.start[axis] = position_[axis];
    if (stays) move.end[axis] = position_[axis];
  }
  add(origin, move);
}

}  // namespace kerf
