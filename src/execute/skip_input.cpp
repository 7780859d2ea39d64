#include "execute/skip_input.hpp"

#include <algorithm>
#include <cmath>

#include "execute/axis_speed.hpp"
#include "execute/grid.hpp"

namespace kerf {
namespace {

constexpr double kSecondsPerMinute = 60.0;

/// When the signal comes at an input that has a source of its own.
std::optional<double> time_of(const SkipInput& input, const RestToRest& movement) {
  switch (input.source) {
    case SkipInput::Source::position:
      return movement.time_at(input.position);
    case SkipInput::Source::time:
      return input.seconds;
    default:
      return std::nullopt;
  }
}

}  // namespace

RestToRest::RestToRest(double start, double end, double speed, double acceleration)
    : start_(start),
      way_(std::abs(end - start)),
      sign_(end < start ? -1.0 : 1.0),
      acceleration_(acceleration) {
  top_ = std::min(speed / kSecondsPerMinute, std::sqrt(acceleration * way_));
  ramp_ = top_ / acceleration;
  cruise_ = top_ > 0.0 ? std::max(way_ / top_ - ramp_, 0.0) : 0.0;
}

double RestToRest::position(double time) const {
  const double left = seconds() - time;
  double way = 0.5 * acceleration_ * time * time;
  if (time > ramp_) way = top_ * (time - 0.5 * ramp_);
  if (left < ramp_) way = way_ - 0.5 * acceleration_ * left * left;
  return start_ + sign_ * way;
}

double RestToRest::speed(double time) const {
  return std::min({top_, acceleration_ * time, acceleration_ * std::max(seconds() - time, 0.0)});
}

std::optional<double> RestToRest::time_at(double position) const {
  const double way = sign_ * (position - start_);
  if (!(way > 0.0 && way <= way_)) return std::nullopt;
  const double ramp_way = 0.5 * top_ * ramp_;
  if (way <= ramp_way) return std::sqrt(2.0 * way / acceleration_);
  if (way <= way_ - ramp_way) return ramp_ + (way - ramp_way) / top_;
  return seconds() - std::sqrt(2.0 * (way_ - way) / acceleration_);
}

double RestToRest::braked_from(double time) const {
  const double now = speed(time);
  return position(time) + sign_ * 0.5 * now * now / acceleration_;
}

SkipStop skip_stop(const AxisVector& start, const AxisVector& end, const Machine& machine, RateSet rates,
                   const SkipInputs& inputs) {
  const auto movement = [&](Axis axis) {
    const AxisRates own = rates_of(machine[axis], rates);
    return RestToRest(start[axis], end[axis], own.rapid, own.rapid_acceleration);
  };
  SkipStop stop{end, end};
  for (const Axis axis : machine.axes) {
    const SkipInput& input = inputs[index(axis)];
    const Axis from = input.source == SkipInput::Source::shared ? input.axis : axis;
    const RestToRest moving = movement(axis);
    const std::optional<double> time = time_of(inputs[index(from)], movement(from));
    if (!time || !(*time < moving.seconds())) continue;
    stop.captured[axis] = on_grid(moving.position(*time));
    stop.braked[axis] = on_grid(moving.braked_from(*time));
  }
  return stop;
}

}  // namespace kerf
