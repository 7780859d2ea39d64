#include "dialect/omron/coordinate_block.hpp"

#include <array>

#include "dialect/omron/coordinates.hpp"
#include "execute/grid.hpp"
#include "execute/moves.hpp"

namespace kerf::omron {
namespace {

bool straight_in_force(const Registers& registers) {
  const ModalState& modal = registers.modal;
  const Placement& placement = registers.placement;
  if (modal[Group::fixed_cycle] != code(80) || modal[Group::radius_compensation] != code(40)) return false;
  if (registers.offset_return_pending || placement.rest_wanted || is_transformed(placement)) return false;
  const CodeNumber motion = modal[Group::motion];
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
  constexpr double kFarthest = 1'000'000.0;
  const bool incremental = registers.modal[Group::distance] == code(91);
  const double unit = millimetres_of(registers.modal[Group::unit]);
  for (const Word& word : block.words) {
    if (word.address < 'X' || word.address > 'Z') return false;
    const auto axis = static_cast<Axis>(word.address - 'X');
    if (!rules.machine().axes.contains(axis) || ends.axes.contains(axis)) return false;
    if (rules.machine()[axis].type == AxisType::rotary) return false;
    if (!(word.computed >= -kFarthest && word.computed <= kFarthest)) return false;
    const double from = incremental ? registers.position[axis] : origin[axis];
    const std::size_t i = index(axis);
    ends.programmed[i] = on_grid(from + word.computed * unit);
    ends.machine[i] = ends.programmed[i] + registers.placement.length[axis];
    if (!rules.travel().contains(axis, ends.machine[i])) return false;
    ends.axes.insert(axis);
  }
  return !ends.axes.empty();
}

/// The named axes go somewhere, and the others stand where the whole way has them stay.
bool only_named_move(const Rules& rules, const Registers& registers, const Ends& ends) {
  const Placement& placement = registers.placement;
  bool moves = false;
  bool others_stay = true;
  for (const Axis axis : rules.machine().axes) {
    if (ends.axes.contains(axis))
      moves |= ends.machine[index(axis)] != placement.machine[axis];
    else
      others_stay &=
          on_grid(registers.position[axis]) + placement.length_taken[axis] == placement.machine[axis];
  }
  return moves && others_stay;
}

}  // namespace

bool run_coordinate_block(const Rules& rules, const Block& block, State& state, ActionQueue& queue) {
  Registers& registers = state.registers;
  constexpr std::size_t kMostWords = 3;
  if (block.words.size() > kMostWords || !straight_in_force(registers)) return false;
  if (block.skip_number > 0 && rules.settings().skips.test(block.skip_number)) return false;
  const AxisVector origin = workpiece_origin(registers, state.tables);
  Ends ends;
  if (!read_ends(rules, block, registers, origin, ends)) return false;
  if (!only_named_move(rules, registers, ends)) return false;
  const bool rapid = registers.modal[Group::motion] == code(0);
  Placement& placement = registers.placement;
  Move& move = push_pathless(rapid ? MoveMode::rapid : MoveMode::linear,
                             rapid ? 0.0 : limited_feed(registers, rules.settings()), queue);
  move.start = placement.machine;
  move.end = placement.machine;
  move.commanded = registers.position;
  move.commanded -= origin;
  for (const Axis axis : ends.axes) {
    move.end[axis] = ends.machine[index(axis)];
    move.commanded[axis] = ends.programmed[index(axis)] - origin[axis];
    registers.position[axis] = ends.programmed[index(axis)];
    placement.machine[axis] = ends.machine[index(axis)];
    placement.length_taken[axis] = placement.length[axis];
  }
  move.each_axis = rapid;
  move.rates = registers.rates;
  move.path_mode = registers.modal[Group::path_mode] == code(61) ? PathMode::exact_stop : PathMode::cutting;
  move.exact_stop = move.path_mode == PathMode::exact_stop;
  return true;
}

}  // namespace kerf::omron
