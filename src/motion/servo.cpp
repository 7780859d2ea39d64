#include "motion/servo.hpp"

#include <cmath>

namespace kerf {

ServoModel::ServoModel(const MotionSettings& settings, double cycle_s, const AxisVector& position)
    : command_(position), actual_(position) {
  if (settings.servo_gain > 0.0) {
    decay_ = std::exp(-settings.servo_gain * cycle_s);
    following_ = 1.0 / (settings.servo_gain * cycle_s);
  }
}

const AxisVector& ServoModel::step(const AxisVector& command) {
  // The following error e = command - actual obeys e' = v - gain e with v constant over the cycle.
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const double steady = (command.values[i] - command_.values[i]) * following_;
    const double error = command_.values[i] - actual_.values[i];
    actual_.values[i] = command.values[i] - (steady + (error - steady) * decay_);
  }
  command_ = command;
  return actual_;
}

}  // namespace kerf
