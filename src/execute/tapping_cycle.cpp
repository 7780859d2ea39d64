#include "execute/tapping_cycle.hpp"

#include <cmath>

#include "execute/moves.hpp"

namespace kerf {
namespace {

SpindleDirection reverse_of(SpindleDirection direction) {
  return direction == SpindleDirection::clockwise ? SpindleDirection::counterclockwise
                                                  : SpindleDirection::clockwise;
}

}  // namespace

void TappingCycle::start(const TappingPlan& plan, const Origin& origin) {
  plan_ = plan;
  origin_ = origin;
  at_ = plan.start;
  hole_ = plan.first_hole;
  done_ = 0;
  const double turns = plan.feed > 0.0 ? std::abs(plan.r_level - plan.bottom) * plan.rpm / plan.feed : 0.0;
  turns_ = plan.cuts == SpindleDirection::clockwise ? turns : -turns;
  phase_ = plan.repetitions > 0 ? Phase::begin : Phase::done;
}

AxisVector TappingCycle::at_level(double z) const {
  AxisVector target = at_;
  target[Axis::Z] = z;
  return target;
}

/// Left out when there is no distance to go.
void TappingCycle::go(MoveMode mode, const AxisVector& target, ActionQueue& queue, double turns) {
  if (target == at_) return;
  const bool rapid = mode == MoveMode::rapid;
  Move& move = push_pathless(mode, rapid ? 0.0 : plan_.feed, queue);
  move.start = at_;
  move.end = at_ = target;
  move.commanded = target - plan_.origin;
  move.each_axis = rapid;
  move.rates = plan_.rates;
  move.exact_stop = true;
  move.spindle_turns = turns;
}

void TappingCycle::spindle(SpindleDirection direction, ActionQueue& queue) const {
  Spindle& spindle = queue.push<Spindle>();
  spindle.direction = direction;
  if (direction == SpindleDirection::orient) {
    spindle.rpm = plan_.orient_rpm;
    spindle.angle = plan_.orient_angle;
  } else if (direction != SpindleDirection::off)
    spindle.rpm = plan_.rpm;
}

void TappingCycle::next_hole() {
  hole_[Axis::X] += plan_.step[Axis::X];
  hole_[Axis::Y] += plan_.step[Axis::Y];
  if (++done_ < plan_.repetitions)
    phase_ = Phase::position;
  else
    phase_ = plan_.has_spindle_axis ? Phase::end : Phase::done;
}

void TappingCycle::step(ActionQueue& queue) {
  queue.begin(origin_);
  const bool told = !plan_.has_spindle_axis;  // the machine turns the spindle
  switch (phase_) {
    case Phase::begin:
      if (!told) spindle(SpindleDirection::orient, queue);
      phase_ = Phase::position;
      break;
    case Phase::position: {
      AxisVector target = hole_;
      target[Axis::Z] = at_[Axis::Z];
      go(MoveMode::rapid, target, queue);
      phase_ = Phase::approach;
      break;
    }
    case Phase::approach:
      go(MoveMode::rapid, at_level(plan_.r_level), queue);
      phase_ = Phase::cut;
      break;
    case Phase::cut:
      if (told) spindle(SpindleDirection::orient, queue);
      if (told) spindle(plan_.cuts, queue);
      go(MoveMode::linear, at_level(plan_.bottom), queue, told ? 0.0 : turns_);
      if (plan_.dwell_s > 0.0) queue.push<Dwell>().seconds = plan_.dwell_s;
      phase_ = Phase::withdraw;
      break;
    case Phase::withdraw:
      if (told) spindle(reverse_of(plan_.cuts), queue);
      go(MoveMode::linear, at_level(plan_.r_level), queue, told ? 0.0 : -turns_);
      if (told) spindle(plan_.cuts, queue);
      phase_ = Phase::leave;
      break;
    case Phase::leave:
      go(told ? MoveMode::linear : MoveMode::rapid, at_level(plan_.return_level), queue);
      next_hole();
      break;
    case Phase::end:
      spindle(SpindleDirection::off, queue);
      phase_ = Phase::done;
      break;
    case Phase::done:
      break;
  }
}

}  // namespace kerf
