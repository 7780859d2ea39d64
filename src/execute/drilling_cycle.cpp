#include "execute/drilling_cycle.hpp"

#include <algorithm>

#include "execute/moves.hpp"

namespace kerf {
namespace {

constexpr double kSameDepth = 5e-5;  // mm, half the machine's least increment: no step is thinner

AxisVector at_level(AxisVector position, double z) {
  position[Axis::Z] = z;
  return position;
}

/// A straight move, left out when there is no distance to go.
void go(MoveMode mode, const AxisVector& target, Registers& registers, const AxisVector& work_origin,
        ActionQueue& queue) {
  if (target == registers.position) return;
  push_straight(mode, target, registers, work_origin, queue);
}

}  // namespace

void DrillingCycle::start(const DrillingPlan& plan, const Origin& origin) {
  plan_ = plan;
  origin_ = origin;
  hole_ = plan.first_hole;
  done_ = 0;
  phase_ = plan.repetitions > 0 ? Phase::position : Phase::done;
}

void DrillingCycle::next_hole() {
  hole_[Axis::X] += plan_.step[Axis::X];
  hole_[Axis::Y] += plan_.step[Axis::Y];
  phase_ = ++done_ < plan_.repetitions ? Phase::position : Phase::done;
}

void DrillingCycle::feed_down(Registers& registers, const AxisVector& work_origin, ActionQueue& queue) {
  const bool last = plan_.peck <= 0.0 || depth_ - plan_.peck <= plan_.bottom + kSameDepth;
  depth_ = last ? plan_.bottom : depth_ - plan_.peck;
  go(MoveMode::linear, at_level(registers.position, depth_), registers, work_origin, queue);
  if (last && plan_.dwell_s > 0.0) queue.push<Dwell>().seconds = plan_.dwell_s;
  phase_ = last ? Phase::leave : Phase::retract;
}

void DrillingCycle::leave(Registers& registers, const AxisVector& work_origin, ActionQueue& queue) {
  if (plan_.spindle_stop) queue.push<Spindle>();
  if (plan_.feed_out) {
    go(MoveMode::linear, at_level(registers.position, plan_.r_level), registers, work_origin, queue);
  }
  go(MoveMode::rapid, at_level(registers.position, plan_.return_level), registers, work_origin, queue);
  if (plan_.spindle_stop) {
    queue.push<Spindle>() = {SpindleDirection::clockwise, plan_.spindle_rpm, plan_.spindle_wait_s};
  }
  next_hole();
}

void DrillingCycle::step(Registers& registers, const AxisVector& work_origin, ActionQueue& queue) {
  queue.begin(origin_);
  switch (phase_) {
    case Phase::position:
      go(MoveMode::rapid, at_level(hole_, registers.position[Axis::Z]), registers, work_origin, queue);
      if (plan_.drills) {
        phase_ = Phase::approach;
      } else {
        next_hole();
      }
      break;
    case Phase::approach:
      go(MoveMode::rapid, at_level(registers.position, plan_.r_level), registers, work_origin, queue);
      depth_ = plan_.r_level;
      phase_ = Phase::feed;
      break;
    case Phase::feed:
      feed_down(registers, work_origin, queue);
      break;
    case Phase::retract:
      go(MoveMode::rapid, at_level(registers.position, plan_.r_level), registers, work_origin, queue);
      phase_ = Phase::reapproach;
      break;
    case Phase::reapproach:
      // A step smaller than the clearance would lead above R; the tool is already there.
      go(MoveMode::rapid, at_level(registers.position, std::min(depth_ + plan_.clearance, plan_.r_level)),
         registers, work_origin, queue);
      phase_ = Phase::feed;
      break;
    case Phase::leave:
      leave(registers, work_origin, queue);
      break;
    case Phase::done:
      break;
  }
}

}  // namespace kerf
