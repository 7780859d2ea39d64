#pragma once
// The simulated drives.

#include "machine/machine.hpp"

namespace kerf {

/// Position loops: actual' = gain (command - actual), a lag of the first order, so that the following error
/// at a constant velocity v is v / gain. Exact for commands that are linear between cycles. A gain of 0 or
/// less is an ideal drive.
class ServoModel {
 public:
  /// `position` is where the axes stand.
  ServoModel(const MotionSettings& settings, double cycle_s, const AxisVector& position);

  /// The next cycle's command; returns the actual position.
  const AxisVector& step(const AxisVector& command);

 private:
  double decay_ = 0.0;      ///< exp(-gain cycle)
  double following_ = 0.0;  ///< 1 / (gain cycle): cycles of command that the actual position lags behind
  AxisVector command_;
  AxisVector actual_;
};

}  // namespace kerf
