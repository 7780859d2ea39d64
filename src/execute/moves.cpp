#include "execute/moves.hpp"

namespace kerf {

Move& push_pathless(MoveMode mode, double feed, ActionQueue& queue) {
  Move& move = queue.push_unset_move();
  move.mode = mode;
  move.path_mode = PathMode::cutting;
  move.from_rest = false;
  move.exact_stop = false;
  move.axis_words = true;
  move.each_axis = false;
  move.passes_on = false;
  move.rates = 0;
  move.normal_line = Side::none;
  move.normal_starts = false;
  move.rounds_corner = false;
  move.feed_in_space = false;
  move.inner_corner_deg = 0.0;
  move.normal_zero = 0.0;
  move.spindle_turns = 0.0;
  move.last_axis = Axis::X;
  move.plane = kPlaneXY;
  move.compensation = {};
  move.rotary_feed = {};
  move.polar = {};
  move.feed = feed;
  move.arc = {};
  return move;
}

Move& push_straight(MoveMode mode, const AxisTargets& targets, Registers& registers,
                    const AxisVector& work_origin, ActionQueue& queue) {
  Move& move = push_pathless(mode, mode == MoveMode::rapid ? 0.0 : registers.feed, queue);
  move.start = registers.position;
  move.end = registers.position;
  move.commanded = registers.position;
  move.commanded -= work_origin;
  for (const Axis axis : targets.axes) {
    const double target = targets.values[axis];
    registers.position[axis] = target;
    move.end[axis] = target;
    move.commanded[axis] = target - work_origin[axis];
  }
  move.start[Axis::Z] += registers.length_applied;
  move.end[Axis::Z] += registers.length_offset;
  registers.length_applied = registers.length_offset;
  return move;
}

Move& push_straight(MoveMode mode, const AxisVector& target, Registers& registers,
                    const AxisVector& work_origin, ActionQueue& queue) {
  Move& move = push_pathless(mode, mode == MoveMode::rapid ? 0.0 : registers.feed, queue);
  move.start = registers.position;
  move.start[Axis::Z] += registers.length_applied;
  move.end = target;
  move.end[Axis::Z] += registers.length_offset;
  move.commanded = target;
  move.commanded -= work_origin;
  registers.position = target;
  registers.length_applied = registers.length_offset;
  return move;
}

}  // namespace kerf
