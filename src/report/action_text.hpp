#pragma once
// What an action does, in a few words.

#include <string>

#include "execute/action.hpp"

namespace kerf {

/// "rapid", "line", "arc cw", "arc ccw", "dwell 0.5 s", "M100", "spindle cw 8000 rpm", "tool 2", "optional
/// stop", "end", "alarm arc-radius", ...
std::string describe(const ActionVariant& what);

}  // namespace kerf
