#include "toolpath/normal_line_pass.hpp"

#include <algorithm>
#include <numbers>

#include "execute/axis_speed.hpp"
#include "execute/normal_line.hpp"

namespace kerf {

NormalLinePass::NormalLinePass(const Machine& machine, const NormalLinePolicy& policy)
    : policy_(policy), machine_(machine) {}

void NormalLinePass::reset() {
  known_ = on_ = false;
  out_.clear();
}

void NormalLinePass::add(const Origin& origin, const Move& move) {
  Action& action = out_.push();
  action.origin = origin;
  action.what = move;
}

void NormalLinePass::push(const Origin& origin, Move move) {
  const Axis axis = *policy_.axis;
  if (!known_) angle_ = move.start[axis];
  known_ = true;
  if (move.normal_line == Side::none) {
    on_ = false;
    const bool commanded = move.end[axis] != move.start[axis];
    move.start[axis] = angle_;
    if (commanded) angle_ = move.end[axis];
    move.end[axis] = angle_;
    return add(origin, move);
  }
  const NormalTurn turn = normal_turn(move, angle_ - move.normal_zero, !on_ || move.normal_starts, policy_);
  if (turn.wrong_way) {
    Action& action = out_.push();
    action.origin = origin;
    action.what = Alarm{policy_.wrong_way, origin.span, {}, {}};
    return;
  }
  on_ = on_ || has_direction(move);
  if (turn.before != 0.0) turn_at_rest(origin, move, turn.before);
  move.start[axis] = angle_;
  angle_ += turn.during;
  move.end[axis] = angle_;
  if (turn.before != 0.0) move.from_rest = true;
  if (policy_.one_way && is_arc(move.mode) && policy_.tool_radius_mm > 0.0) {
    const bool inwards = (move.arc.sweep > 0.0) == (move.normal_line == Side::left);
    const double tip = move.arc.radius + (inwards ? -policy_.tool_radius_mm : policy_.tool_radius_mm);
    if (tip > 0.0) move.feed *= move.arc.radius / tip;
  }
  add(origin, move);
}

void NormalLinePass::turn_at_rest(const Origin& origin, const Move& move, double by) {
  const Axis axis = *policy_.axis;
  Move turn = move;
  turn.mode = move.mode == MoveMode::rapid ? MoveMode::rapid : MoveMode::linear;
  turn.arc = {};
  turn.each_axis = turn.passes_on = false;
  turn.from_rest = turn.exact_stop = true;
  turn.end = move.start;
  turn.start[axis] = angle_;
  angle_ += by;
  turn.end[axis] = angle_;
  turn.feed = turning_speed(move);
  add(origin, turn);
}

/// Degrees a minute; of a rapid move 0: as fast as the axis can.
double NormalLinePass::turning_speed(const Move& move) const {
  const bool rapid = move.mode == MoveMode::rapid;
  if (!policy_.one_way) return rapid ? 0.0 : policy_.turning_speed;
  const double per_mm =
      policy_.tool_radius_mm > 0.0 ? 180.0 / (std::numbers::pi * policy_.tool_radius_mm) : 1.0;
  if (!rapid) return move.feed * per_mm;
  const double speed = std::min(rates_of(machine_[move.plane.first], move.rates).rapid,
                                rates_of(machine_[move.plane.second], move.rates).rapid);
  return speed * per_mm;
}

}  // namespace kerf
