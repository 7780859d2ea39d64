#include "execute/moves.hpp"

namespace kerf {

Move& push_straight(MoveMode mode, const AxisVector& target, Registers& registers,
                    const AxisVector& work_origin, ActionQueue& queue) {
  Move& move = queue.push_unset_move();
  move.mode = mode;
  move.exact_stop = false;
  move.axis_words = true;
  move.plane = kPlaneXY;
  move.compensation = {};
  move.rotary_feed = {};
  move.start = registers.position;
  move.start[Axis::Z] += registers.length_applied;
  move.end = target;
  move.end[Axis::Z] += registers.length_offset;
  move.commanded = target;
  move.commanded -= work_origin;
  move.work_origin = work_origin;
  move.feed = registers.feed;
  move.arc = {};
  registers.position = target;
  registers.length_applied = registers.length_offset;
  return move;
}

}  // namespace kerf
