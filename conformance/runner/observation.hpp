#pragma once
// Actions of the controller as events of a case.

#include <optional>

#include "conformance/runner/case.hpp"
#include "execute/action.hpp"
#include "execute/feed_policy.hpp"

namespace kerf::conformance {

/// The event of an action with everything a case may ask for. None for a move of no length.
std::optional<Entry> event_of(const Action& action, AxisSet axes, const FeedPolicy& policy);

}  // namespace kerf::conformance
