#pragma once
// Times and positions of a program on the simulated machine.

#include <optional>
#include <vector>

#include "conformance/runner/case.hpp"
#include "conformance/runner/rig.hpp"

namespace kerf::conformance {

struct PlannedRun {
  double time_s = 0.0;
  double motion_s = 0.0;  ///< the part of it in which axes move
  /// Machine coordinates at the times asked for; none: the run is over before.
  std::vector<std::optional<AxisVector>> positions;
};

/// Plans and plays the actions, changing overrides on the way. `times_s` in any order.
PlannedRun plan(const std::vector<Action>& actions, const Controller& controller,
                const std::vector<OverrideChange>& changes, const std::vector<double>& times_s);

}  // namespace kerf::conformance
