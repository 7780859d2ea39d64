#pragma once
// Straight and circular moves out of registers: the one place where a Move is filled in.

#include "execute/action_queue.hpp"
#include "execute/state.hpp"

namespace kerf {

/// Machine position of the tool reference point for a programmed position.
inline AxisVector with_length(AxisVector position, double length_offset) {
  position[Axis::Z] += length_offset;
  return position;
}

/// Pushes a move with everything but its way filled in: start, end, commanded.
Move& push_pathless(MoveMode mode, double feed, ActionQueue& queue);

/// Where some of the axes go, machine coordinates without length offset.
struct AxisTargets {
  AxisSet axes;
  AxisVector values;  ///< only those of `axes` count
};

/// Pushes a straight move to `targets`, which the other axes do not take part in, and makes it the position.
/// Faster than the next one, which reads a whole vector that was written axis by axis just before.
Move& push_straight(MoveMode mode, const AxisTargets& targets, Registers& registers,
                    const AxisVector& work_origin, ActionQueue& queue);

/// Pushes a straight move to `target` (machine coordinates without length offset) and makes it the position.
Move& push_straight(MoveMode mode, const AxisVector& target, Registers& registers,
                    const AxisVector& work_origin, ActionQueue& queue);

}  // namespace kerf
