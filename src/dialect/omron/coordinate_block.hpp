#pragma once
// The short way for the blocks that most programs consist of: nothing but coordinates of a straight move.

#include "dialect/omron/rules.hpp"

namespace kerf::omron {

/// Executes the block and returns true when it holds nothing but X, Y and Z, each once, moves, and a straight
/// move is in force that no transformation, compensation, cycle and no other state touches. Otherwise, and
/// for everything that could be an alarm, it changes nothing and returns false: the block takes the whole
/// way, which gives the same.
bool run_coordinate_block(const Rules& rules, const Block& block, State& state, ActionQueue& queue);

}  // namespace kerf::omron
