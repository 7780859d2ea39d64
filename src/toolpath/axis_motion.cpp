#include "toolpath/axis_motion.hpp"

#include <algorithm>
#include <cmath>

#include "execute/axis_speed.hpp"
#include "execute/grid.hpp"

namespace kerf {
namespace {

/// How long each axis of a move needs by itself, in minutes.
AxisVector times_of(const Move& move, const Machine& machine, AxisSet followers) {
  AxisVector times;
  for (const Axis axis : machine.axes) {
    if (followers.contains(axis)) continue;
    double speed = rates_of(machine[axis], move.rates).rapid;
    if (move.feed > 0.0) speed = std::min(speed, move.feed);
    times[axis] = std::abs(move.end[axis] - move.start[axis]) / speed;
  }
  return times;
}

/// The shortest of the times that are longer than `passed`; 0: none is.
double next_arrival(const AxisVector& times, double passed) {
  double next = 0.0;
  for (const double time : times.values) {
    if (time > passed && (next == 0.0 || time < next)) next = time;
  }
  return next;
}

Axis last_of(const AxisVector& times) {
  const auto last = std::max_element(times.values.begin(), times.values.end());
  return static_cast<Axis>(last - times.values.begin());
}

}  // namespace

AxisMotionPass::AxisMotionPass(const Machine& machine)
    : machine_(machine), followers_(machine.followers()), follows_(!followers_.empty()) {}

void AxisMotionPass::push(const Origin& origin, const Move& move) {
  if (move.each_axis && move.mode == MoveMode::rapid) {
    push_legs(origin, move);
  } else {
    add(origin, move);
  }
}

void AxisMotionPass::push_legs(const Origin& origin, const Move& move) {
  const AxisVector times = times_of(move, machine_, followers_);
  Move leg = move;
  leg.last_axis = last_of(times);
  for (double passed = next_arrival(times, 0.0); passed > 0.0;) {
    for (const Axis axis : machine_.axes) {
      const double way = move.end[axis] - move.start[axis];
      leg.end[axis] =
          times[axis] <= passed ? move.end[axis] : on_grid(move.start[axis] + way * (passed / times[axis]));
    }
    passed = next_arrival(times, passed);
    leg.passes_on = passed > 0.0;
    leg.exact_stop = move.exact_stop && !leg.passes_on;
    add(origin, leg);
    leg.start = leg.end;
    leg.from_rest = false;
  }
}

void AxisMotionPass::add(const Origin& origin, const Move& move) {
  Action& action = legs_.push();
  action.origin = origin;
  Move& placed = action.what.emplace<Move>(move);
  place_followers(placed.start);
  place_followers(placed.end);
}

void AxisMotionPass::place_followers(AxisVector& position) const {
  for (const Axis axis : followers_) {
    const Axis master = *machine_[axis].master;
    position[axis] = machine_[axis].start + (position[master] - machine_[master].start);
  }
}

}  // namespace kerf
