#include "dialect/dgshape/coordinate_block.hpp"

#include "dialect/dgshape/numbers.hpp"
#include "execute/grid.hpp"
#include "execute/moves.hpp"

namespace kerf::dgshape {
namespace {

/// A straight move is in force that neither an offset, nor scaling, nor a check of F and spindle touches.
bool straight_in_force(const Registers& registers) {
  const ModalState& modal = registers.modal;
  const CodeNumber motion = modal[Group::motion];
  if (motion > code(1) || modal[Group::fixed_cycle] != code(80)) return false;
  if (modal[Group::radius_compensation] != code(40) || registers.offset_return_pending) return false;
  if (modal[Group::scaling] != code(50) || registers.length_offset != registers.length_applied) return false;
  return motion == code(0) || (registers.feed_given && registers.spindle_on);
}

/// A coordinate in steps of 0.001 mm from an origin of 0 is on the grid as it is.
double grid_destination(double base, double value, bool fine) {
  return fine && base == 0.0 ? value : on_grid(base + value);
}

/// Writes the destinations of the words into `targets`; false when a word needs the whole way.
bool read_targets(const NumberReader& reader, const Block& block, const Registers& registers,
                  const AxisVector& origin, AxisTargets& targets) {
  const bool incremental = registers.modal[Group::distance] == code(91);
  const bool fine = registers.modal[Group::unit] == code(21) && !incremental;
  for (const Word& word : block.words) {
    if (word.address < 'X' || word.address > 'Z') return false;
    const auto axis = static_cast<Axis>(word.address - 'X');
    const NumberResult number = reader.distance(word);
    if (number.fault != NumberFault::none || targets.axes.contains(axis)) return false;
    targets.values[axis] =
        grid_destination(incremental ? registers.position[axis] : origin[axis], number.value, fine);
    targets.axes.insert(axis);
  }
  return true;
}

int moving_axes(const AxisVector& from, const AxisTargets& to) {
  int moving = 0;
  for (const Axis axis : to.axes) moving += from[axis] != to.values[axis] ? 1 : 0;
  return moving;
}

/// Axes that stay where they are cannot leave their travel.
bool inside_travel(const Travel& travel, const AxisTargets& targets, double length_offset) {
  bool inside = true;
  for (const Axis axis : targets.axes) {
    inside &= travel.contains(axis, targets.values[axis] + (axis == Axis::Z ? length_offset : 0.0));
  }
  return inside;
}

}  // namespace

bool run_coordinate_block(const Rules& rules, const Block& block, State& state, ActionQueue& queue) {
  Registers& registers = state.registers;
  const ControllerSettings& settings = rules.settings();
  if (settings.clip_over_travel || !straight_in_force(registers)) return false;
  const AxisVector origin = workpiece_origin(registers, state.tables);
  const NumberReader reader(settings, registers.modal[Group::unit] == code(20));
  AxisTargets targets;
  if (!read_targets(reader, block, registers, origin, targets) || targets.axes.empty()) return false;
  const int moving = moving_axes(registers.position, targets);
  if (moving == 0) return true;
  const bool rapid = registers.modal[Group::motion] == code(0);
  if (rapid && moving > settings.rapid_axes) return false;
  if (!inside_travel(rules.travel(), targets, registers.length_offset)) return false;
  Move& move = push_straight(rapid ? MoveMode::rapid : MoveMode::linear, targets, registers, origin, queue);
  move.axis_words = targets.axes.contains(Axis::X) || targets.axes.contains(Axis::Y);
  registers.unit_locked = true;
  return true;
}

}  // namespace kerf::dgshape
