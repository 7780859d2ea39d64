#pragma once
// Actions of the controller as events of a case.

#include <optional>

#include "conformance/runner/case.hpp"
#include "execute/action.hpp"
#include "execute/feed_policy.hpp"

namespace kerf::conformance {

/// What an event needs to know besides the action.
struct Surroundings {
  AxisSet axes;
  FeedPolicy policy;
  AxisVector work_origin;  ///< machine coordinates of the workpiece origin that the block was written in
};

/// The event of an action with everything a case may ask for. None for a move of no length.
std::optional<Entry> event_of(const Action& action, const Surroundings& surroundings);

}  // namespace kerf::conformance
