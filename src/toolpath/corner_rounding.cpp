#include "toolpath/corner_rounding.hpp"

#include <cmath>

namespace kerf {
namespace {

constexpr double kStraightOn = 1e-6;  // degrees

double way_of(const Move& move) {
  return distance(in_plane(move.start, move.plane), in_plane(move.end, move.plane));
}

Vec2 direction_of(const Move& move) {
  return unit(in_plane(move.end, move.plane) - in_plane(move.start, move.plane));
}

/// What a block may give in front of its move. Nothing is looked at across a stop.
bool comes_before_the_move(const Action& action) {
  return std::holds_alternative<Auxiliary>(action.what) || std::holds_alternative<Spindle>(action.what) ||
         std::holds_alternative<ToolChange>(action.what);
}

/// The position after a part of a straight move.
AxisVector position_at(const Move& move, double part) {
  AxisVector position = move.end - move.start;
  position *= part;
  position += move.start;
  return position;
}

}  // namespace

CornerRounding::CornerRounding(const NormalLinePolicy& policy)
    : radius_(policy.axis && !policy.one_way ? policy.insert_radius_mm : 0.0) {}

void CornerRounding::reset() {
  held_.reset();
  waiting_.clear();
  out_.clear();
}

bool CornerRounding::may_round(const Action& action) const {
  const Move* move = std::get_if<Move>(&action.what);
  return move != nullptr && move->mode == MoveMode::linear && move->normal_line != Side::none &&
         way_of(*move) >= radius_;
}

void CornerRounding::push(const Action& action) {
  Action next = action;
  const bool may = may_round(next);
  const bool behind_held = held_ && next.origin.block == held_->origin.block + 1;
  if (behind_held && comes_before_the_move(next) && !waiting_.full()) return waiting_.push(next);
  if (behind_held && may) round(next);
  release();
  if (may) {
    held_ = next;
  } else {
    out_.push(next);
  }
}

void CornerRounding::release() {
  if (held_) out_.push(*held_);
  held_.reset();
  while (!waiting_.empty()) out_.push(waiting_.pop());
}

void CornerRounding::round(Action& next) {
  Move& first = std::get<Move>(held_->what);
  Move& second = std::get<Move>(next.what);
  if (first.plane != second.plane || first.normal_line != second.normal_line) return;
  // A vector that the program gives holds at the corner itself.
  if (first.compensation.rule != VectorRule::computed || first.compensation.suspended) return;
  const Vec2 in = direction_of(first);
  const double turn = turn_deg(in, direction_of(second));
  if (std::abs(turn) < kStraightOn || std::abs(turn) > 180.0 - kStraightOn) return;
  const double cut = radius_ * std::tan(radians(0.5 * std::abs(turn)));
  if (cut > way_of(first) || cut > way_of(second)) return;

  const double way_of_held = way_of(first);
  Move arc = first;
  arc.start = position_at(first, 1.0 - cut / way_of(first));
  arc.end = position_at(second, cut / way_of(second));
  arc.mode = turn > 0.0 ? MoveMode::counterclockwise : MoveMode::clockwise;
  const Vec2 center = in_plane(arc.start, arc.plane) + (turn > 0.0 ? radius_ : -radius_) * left_of(in);
  arc.rounds_corner = true;
  arc.arc = {{center.x, center.y}, radius_, turn};
  first.end = arc.start;
  first.exact_stop = false;
  second.start = arc.end;
  if (cut < way_of_held) out_.push(*held_);
  held_->what = arc;
}

}  // namespace kerf
