// Normal line control as the blocks command it (G40.1, G41.1, G42.1; manual 5.6, 6.6). The axis itself is
// turned in the toolpath (NormalLinePass); what is reckoned here is where the program has it.

#include "dialect/melsec/block_run.hpp"
#include "execute/normal_line.hpp"

namespace kerf::melsec {

/// Under normal line control words for its axis are ignored; it counts among the axes that a block may move.
void BlockRun::take_normal_line_axis() {
  const auto& axis = rules_.settings().normal_line.axis;
  const CodeNumber mode =
      words_.has(Group::normal_line) ? words_[Group::normal_line] : registers.modal[Group::normal_line];
  turns_along_ = axis && mode != code(40, 1);
  if (turns_along_) words_.ignore(*axis);
}

void BlockRun::turn_along(Move& move) {
  turned_.reset();
  if (!turns_along_ || move.each_axis) return;
  Plane plane;
  if (!plane_axes(plane)) return;
  move.plane = plane;
  move.normal_line = registers.modal[Group::normal_line] == code(41, 1) ? Side::left : Side::right;
  const NormalLinePolicy& policy = rules_.settings().normal_line;
  const Axis axis = *policy.axis;
  // The angle counts in the coordinate system of the program.
  move.normal_zero = workpiece_origin(registers, tables_)[axis];
  move.normal_starts = !registers.normal_line_on;
  const NormalTurn turn = normal_turn(move, move.start[axis] - move.normal_zero, move.normal_starts, policy);
  registers.normal_line_on = registers.normal_line_on || has_direction(move);
  turned_ = move.start[axis] + turn.before + turn.during;
}

}  // namespace kerf::melsec
