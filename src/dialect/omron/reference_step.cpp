// G28, G30, G52 and G53 (manual chapter 2).

#include "dialect/omron/block_run.hpp"
#include "execute/grid.hpp"

namespace kerf::omron {

/// The program has its position where the axes stand.
void BlockRun::stand_at(const AxisVector& machine) {
  Placement& placement = registers.placement;
  placement.machine = machine;
  const AxisVector real = machine - placement.length_taken;
  registers.position = is_transformed(placement) ? untransformed(placement, real) : real;
}

/// Replaces the offset of the axes named, or of all without a word; moves nothing.
bool BlockRun::local_system() {
  AxisVector local = registers.shift;
  if (words_.axes().empty()) local = {};
  for (const Axis axis : words_.axes()) {
    if (!axis_value(axis, local[axis])) return false;
  }
  registers.shift = local;
  release_transformations(registers);
  stand_at(registers.placement.machine);
  return true;
}

bool BlockRun::offsets_are_off() {
  const bool off = registers.modal[Group::length_compensation] == code(49) && !is_compensating();
  return off || refuse("offset-active", span(words_.word(Group::one_shot)));
}

/// Absolute machine coordinates, at rapid; the local coordinate system ends for good.
bool BlockRun::machine_move() {
  if (!offsets_are_off()) return false;
  AxisVector end = registers.placement.machine;
  for (const Axis axis : words_.axes()) {
    if (!axis_value(axis, end[axis])) return false;
    end[axis] = on_grid(end[axis]);
  }
  release_transformations(registers);
  registers.shift = {};
  if (end != registers.placement.machine && !push(MoveMode::rapid, end, end)) return false;
  for (const Axis axis : words_.axes()) registers.placement.length_taken[axis] = 0.0;
  stand_at(end);
  return true;
}

/// By way of the middle point to the reference point, both at rapid; without words all axes go straight to
/// it.
bool BlockRun::reference_return() {
  if (!offsets_are_off()) return false;
  const bool first = words_[Group::one_shot] == code(28);
  std::int32_t point = 2;
  if (!first) {
    const Word* word = take('P');
    if (word != nullptr && !(word->computed == 2.0 || word->computed == 3.0 || word->computed == 4.0))
      return refuse("reference-point", span(*word));
    if (word != nullptr) point = static_cast<std::int32_t>(word->computed);
  }
  AxisVector middle = registers.position;
  if (!targets(middle)) return false;
  if (!straight(MoveMode::rapid, middle)) return false;
  release_transformations(registers);
  const AxisSet moving = words_.axes().empty() ? rules_.machine().axes : words_.axes();
  AxisVector end = registers.placement.machine;
  for (const Axis axis : moving) {
    end[axis] =
        first ? rules_.machine()[axis].home : settings_.references[static_cast<std::size_t>(point) - 2][axis];
    registers.placement.length_taken[axis] = 0.0;
  }
  if (end != registers.placement.machine && !push(MoveMode::rapid, end, end)) return false;
  stand_at(end);
  return true;
}

}  // namespace kerf::omron
