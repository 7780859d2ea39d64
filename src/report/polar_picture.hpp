#pragma once
// Polar coordinate interpolation as drawings show it: the Cartesian figure on the work.

#include <optional>

#include "execute/action.hpp"

namespace kerf {

/// The axis of X, Y and Z in whose place a picture shows the second coordinate of a polar plane: the one that
/// is neither its linear axis nor its height axis. Nothing for moves without such a plane, or with axes that
/// no picture shows.
std::optional<Axis> figure_axis(const Move& move);

/// The move as the line or arc that it runs on the work, in the plane of its linear axis and figure_axis(),
/// with the distance across added to where that axis stands. The rotary axis keeps its angles. Other moves
/// stay as they are.
Move as_figure(const Move& move);

}  // namespace kerf
