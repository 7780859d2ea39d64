#include "execute/moves.hpp"

namespace kerf {

Move& push_straight(MoveMode mode, const AxisVector& target, Registers& registers,
                    const AxisVector& work_origin, ActionQueue& queue) {
  Move& move = queue.push<Move>();
  move.mode = mode;
  move.start = with_length(registers.position, registers.length_applied);
  move.end = with_length(target, registers.length_offset);
  move.commanded = target - work_origin;
  move.work_origin = work_origin;
  move.feed = registers.feed;
  registers.position = target;
  registers.length_applied = registers.length_offset;
  return move;
}

}  // namespace kerf
