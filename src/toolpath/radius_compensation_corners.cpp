// Where compensated moves meet, and what is wrong when they do not.

#include <cmath>

#include "toolpath/compensated_move.hpp"
#include "toolpath/radius_compensation.hpp"

namespace kerf {

Corner RadiusCompensationPass::corner_to(const OffsetSegment& next) const {
  if (held().led) return *held().led;
  const RadiusCompensation& own = held_move().compensation;
  if (own.rule != VectorRule::computed) {
    Corner corner = corner_at(held().segment.programmed.end + vector_of(own, left_mm_));
    corner.fixed = true;
    return corner;
  }
  if (state_ == State::starting)
    return start_corner(held().segment.ends, next, policy_.start_type, rules(), policy_.type_b_beside);
  return crossover_corner(held().segment, next, rules());
}

// The move held back learns that an inner corner between cutting moves ends it.
void RadiusCompensationPass::note_inner_corner(const Move& move, const OffsetSegment& next) {
  Move& first = std::get<Move>(held().action.what);
  if (first.path_mode != PathMode::corner_override) return;
  const bool cutting = move.mode != MoveMode::rapid && first.mode != MoveMode::rapid;
  if (!cutting || state_ != State::running || first.compensation.rule != VectorRule::computed) return;
  const double angle = workpiece_angle_deg(held().segment.ends, next.begins, left_mm_);
  if (is_inner(angle)) first.inner_corner_deg = 360.0 - angle;
  // An arc put into the corner: its angle is not asked for (5.6 G62).
  if (move.rounds_corner && offset_radius(next.programmed, left_mm_) < next.programmed.radius)
    first.inner_corner_deg = kRoundedInnerCorner;
}

Corner RadiusCompensationPass::corner_to_end(const Move& move) const {
  if (held_move().compensation.rule != VectorRule::computed) return corner_to({});
  const Vec2 imagined{move.compensation.direction[0], move.compensation.direction[1]};
  if (imagined != Vec2{} && state_ != State::starting) return imagined_corner(held().segment, imagined);
  const Vec2 direction = plane_direction(plane_, move);
  if (direction == Vec2{}) return corner_at(held().segment.offset.end);
  // Started and ended without a compensated move between: the tool comes to the point beside the start of the
  // last.
  if (state_ == State::starting)
    return corner_at(held().segment.programmed.end + left_mm_ * left_of(direction));
  return end_corner(held().segment, direction, policy_.start_type, rules(), policy_.type_b_beside);
}

// From the programmed end of a move to the tool.
Vec2 RadiusCompensationPass::vector_of(const RadiusCompensation& compensation, double left_mm) const {
  const Vec2 direction = unit(Vec2{compensation.direction[0], compensation.direction[1]});
  switch (compensation.rule) {
    case VectorRule::at_right_angles:
      return left_mm * left_of(direction);
    case VectorRule::along:
      return std::abs(left_mm) * direction;
    case VectorRule::kept:
      return held().segment.offset.start - held().segment.programmed.start;
    case VectorRule::computed:
      break;
  }
  return {};
}

// The direction to which the tool stands at right angles at the end of the move held back: that of its end,
// or one that a vector of the program gives it.
Vec2 RadiusCompensationPass::facing() const {
  const Vec2 vector = vector_of(held_move().compensation, left_mm_);
  const bool stands_so = std::abs(length(vector) - std::abs(left_mm_)) <= kNoLength && vector != Vec2{};
  return stands_so ? -left_of(vector / left_mm_) : held().segment.ends;
}

// The tool stands, or will stand, as far from the end of the move held back as the amount says: not where a
// vector of another length was given, or none.
bool RadiusCompensationPass::stands_beside_end() const {
  double away = std::abs(left_mm_);
  if (state_ == State::settled)
    away = distance(point(), held().segment.programmed.end);
  else if (held_move().compensation.rule != VectorRule::computed)
    away = length(vector_of(held_move().compensation, left_mm_));
  return std::abs(away - std::abs(left_mm_)) <= kNoLength;
}

// The turn of a corner arc to a direction; none when the corner is an inner one or there is nothing to turn.
std::optional<RadiusCompensationPass::CornerTurn> RadiusCompensationPass::corner_turn(Vec2 direction) const {
  if (direction == Vec2{} || !stands_beside_end()) return std::nullopt;
  const double angle =
      workpiece_angle_deg(state_ == State::settled ? facing_ : facing(), direction, left_mm_);
  const double turn_angle = 180.0 - angle;
  if ((is_inner(angle) && !policy_.corner_arc_inside) ||
      std::abs(left_mm_ * radians(turn_angle)) <= kNoLength)
    return std::nullopt;
  return CornerTurn{left_mm_ < 0.0 ? turn_angle : -turn_angle,
                    held().segment.programmed.end + left_mm_ * left_of(direction)};
}

// Blocks strictly between the held move and the next action; a block may give several actions, so the
// action's own block does not count.
bool RadiusCompensationPass::look_ahead_fails(const Origin& next) const {
  if (state_ == State::settled || next.block <= held().action.origin.block) return false;
  std::uint32_t between = next.block - held().action.origin.block - 1;
  if (corner_arc_block_ < next.block && corner_arc_block_ > held().action.origin.block) --between;
  return between >= policy_.blocks_without_motion;
}

// ---- alarms

void RadiusCompensationPass::raise(const AlarmKind* kind, const Origin& origin,
                                   const FixedText<200>& message) {
  if (sees_together(origin) && !before_keeps_clear(nullptr)) return static_cast<void>(refuse_before());
  if (state_ != State::off) settle();
  drop_corner_arc();
  out_.add({origin, Alarm{kind, origin.span, message, {}}});
  turn_off(true);
  after_alarm_ = true;
  overcuts_.restart();
}

void RadiusCompensationPass::raise_corner_fault(const Corner& corner, const Origin& next) {
  const AxisVector at = held_move().commanded;
  const FixedText<64> place =
      FixedText<64>::format("at {}{:.3f} {}{:.3f} with an offset of {:.3f} mm", letter(plane_.first),
                            at[plane_.first], letter(plane_.second), at[plane_.second], std::abs(left_mm_));
  if (sees_together(next) && !before_keeps_clear(nullptr)) return static_cast<void>(refuse_before());
  if (policy_.stops_before_fault && state_ == State::running) leave_before_and_stop();
  if (corner.fault == CornerFault::apart)
    return raise(policy_.no_crossover, next,
                 FixedText<200>::format("The offset paths miss each other by {:.3f} mm {}", corner.gap_mm,
                                        place.view()));
  if (corner.fault == CornerFault::second_used_up)
    return raise(policy_.no_crossover, next,
                 FixedText<200>::format("Nothing is left of the arc behind the corner {}", place.view()));
  // The move before the corner cannot be made at all.
  state_ = State::settled;
  raise(policy_.no_crossover, held().action.origin,
        FixedText<200>::format("Nothing is left of the arc before the corner {}", place.view()));
}

}  // namespace kerf
