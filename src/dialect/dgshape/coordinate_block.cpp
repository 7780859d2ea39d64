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

/// Writes the destinations of the words into `target`; the axes named, none when a word needs the whole way.
AxisSet read_target(const NumberReader& reader, const Block& block, const Registers& registers,
                    const AxisVector& origin, AxisVector& target) {
  const bool incremental = registers.modal[Group::distance] == code(91);
  const bool fine = registers.modal[Group::unit] == code(21) && !incremental;
  AxisSet named;
  for (const Word& word : block.words) {
    if (word.address < 'X' || word.address > 'Z') return {};
    const auto axis = static_cast<Axis>(word.address - 'X');
    const NumberResult number = reader.distance(word);
    if (number.fault != NumberFault::none || named.contains(axis)) return {};
    target[axis] =
        grid_destination(incremental ? registers.position[axis] : origin[axis], number.value, fine);
    named.insert(axis);
  }
  return named;
}

int moving_axes(const AxisVector& from, const AxisVector& to) {
  return (from[Axis::X] != to[Axis::X]) + (from[Axis::Y] != to[Axis::Y]) + (from[Axis::Z] != to[Axis::Z]);
}

}  // namespace

bool run_coordinate_block(const Rules& rules, const Block& block, State& state, ActionQueue& queue) {
  Registers& registers = state.registers;
  const ControllerSettings& settings = rules.settings();
  if (settings.clip_over_travel || !straight_in_force(registers)) return false;
  const AxisVector origin = workpiece_origin(registers, state.tables);
  const NumberReader reader(settings, registers.modal[Group::unit] == code(20));
  AxisVector target = registers.position;
  const AxisSet named = read_target(reader, block, registers, origin, target);
  if (named.empty()) return false;
  const int moving = moving_axes(registers.position, target);
  if (moving == 0) return true;
  const bool rapid = registers.modal[Group::motion] == code(0);
  if (rapid && moving > settings.rapid_axes) return false;
  AxisVector end = target;
  end[Axis::Z] += registers.length_offset;
  if (!rules.travel().contains(end)) return false;
  Move& move = push_straight(rapid ? MoveMode::rapid : MoveMode::linear, target, registers, origin, queue);
  move.axis_words = named.contains(Axis::X) || named.contains(Axis::Y);
  registers.unit_locked = true;
  return true;
}

}  // namespace kerf::dgshape
