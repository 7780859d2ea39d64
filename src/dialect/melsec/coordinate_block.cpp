#include "dialect/melsec/coordinate_block.hpp"

#include <cmath>

#include "dialect/melsec/numbers.hpp"
#include "dialect/melsec/radius.hpp"
#include "execute/grid.hpp"
#include "execute/moves.hpp"

namespace kerf::melsec {
namespace {

bool straight_in_force(const Registers& registers) {
  const Placement& placement = registers.placement;
  if (registers.modal[Group::normal_line] != code(40, 1)) return false;
  if (placement.rotation.active || placement.absolute_wanted || placement.rest_wanted || placement.polar.on)
    return false;
  const CodeNumber motion = registers.modal[Group::motion];
  return motion == code(0) || (motion == code(1) && registers.feed_given);
}

/// Where the named axes go: programmed, and in machine coordinates with the tool length.
struct Ends {
  AxisSet axes;
  std::array<double, kAxisCount> programmed;
  std::array<double, kAxisCount> machine;
};

/// False when a word needs the whole way.
bool read_ends(const Rules& rules, const Block& block, const Registers& registers, const AxisVector& origin,
               Ends& ends) {
  const bool incremental = registers.modal[Group::distance] == code(91);
  for (const Word& word : block.words) {
    const auto axis = axis_from_letter(word.address);
    if (!axis || word.comma || ends.axes.contains(*axis)) return false;
    if (!rules.line().all.contains(*axis) || rules.line().followers.contains(*axis)) return false;
    if (rules.settings().endless.contains(*axis)) return false;
    const NumberResult number = position_of(word);
    if (number.fault != NumberFault::none) return false;
    const std::size_t i = index(*axis);
    ends.programmed[i] =
        on_grid((incremental ? registers.position.values[i] : origin.values[i]) + number.value);
    ends.machine[i] = on_grid(ends.programmed[i] + registers.placement.length.values[i]);
    if (!rules.travel().contains(*axis, ends.machine[i])) return false;
    constexpr double kLongWay = 50'000.0;  // mm: four of them may be too long for the controller to count
    if (std::abs(ends.machine[i] - registers.placement.machine.values[i]) > kLongWay) return false;
    ends.axes.insert(*axis);
  }
  return !ends.axes.empty();
}

bool moves(const Ends& ends, const AxisVector& machine) {
  bool any = false;
  for (const Axis axis : ends.axes) any |= ends.machine[index(axis)] != machine[axis];
  return any;
}

void arrive(const Ends& ends, Registers& registers) {
  Placement& placement = registers.placement;
  for (const Axis axis : ends.axes) {
    registers.position[axis] = ends.programmed[index(axis)];
    placement.machine[axis] = ends.machine[index(axis)];
    placement.length_taken[axis] = placement.length[axis];
  }
}

}  // namespace

bool run_coordinate_block(const Rules& rules, const Block& block, State& state, ActionQueue& queue) {
  Registers& registers = state.registers;
  if (block.words.size() > static_cast<std::size_t>(kContouringAxes) || !straight_in_force(registers))
    return false;
  const bool compensated = is_compensated(registers);
  const std::optional<Plane> plane =
      compensated ? plane_of(registers.modal[Group::plane], rules.settings()) : kPlaneXY;
  if (!plane) return false;
  const AxisVector origin = workpiece_origin(registers, state.tables);
  Ends ends;
  if (!read_ends(rules, block, registers, origin, ends)) return false;
  if (compensated)
    registers.radius_amount = state.tables.radius[static_cast<std::size_t>(registers.radius_number)];
  const AxisVector& machine = registers.placement.machine;
  if (moves(ends, machine)) {
    const bool rapid = registers.modal[Group::motion] == code(0);
    Move& move =
        push_pathless(rapid ? MoveMode::rapid : MoveMode::linear, rapid ? 0.0 : registers.feed, queue);
    // Whole vectors are read as they were before this block, then the named axes are written: a vector that
    // was written axis by axis just before would have to be waited for.
    move.start = machine;
    move.end = machine;
    move.commanded = registers.position;
    move.commanded -= origin;
    for (const Axis axis : ends.axes) {
      move.end[axis] = ends.machine[index(axis)];
      move.commanded[axis] = ends.programmed[index(axis)] - origin[axis];
    }
    move.plane = *plane;
    if (compensated) move.compensation = compensation_in_force(registers);
    move.path_mode = path_mode_of(registers.modal[Group::path_mode]);
    move.rates = rate_set_of(move.path_mode);
    move.exact_stop = move.path_mode == PathMode::exact_stop;
    move.each_axis = rapid && rules.settings().each_axis;
  }
  arrive(ends, registers);
  return true;
}

}  // namespace kerf::melsec
