#pragma once
// The short way of the most frequent block: nothing but the next point of a straight line.

#include "dialect/dgshape/rules.hpp"

namespace kerf::dgshape {

/// Executes a block of X, Y and Z words when nothing can be said against it and nothing but the position
/// changes; false: the block was not touched and goes the whole way of BlockRun, which gives the same move,
/// or the alarm. A finishing program is made of such blocks, so this is where the speed of kerf is decided.
bool run_coordinate_block(const Rules& rules, const Block& block, State& state, ActionQueue& queue);

}  // namespace kerf::dgshape
