// Polar coordinate interpolation as the blocks command it (G12.1, G13.1; manual 5.6). While it is on, the
// program's position of the rotary axis is the second coordinate of the plane; where the axes really go is
// the business of the toolpath (PolarPass).

#include <cmath>

#include "dialect/melsec/block_run.hpp"
#include "execute/polar_plane.hpp"
#include "geometry/polar.hpp"

namespace kerf::melsec {
namespace {

constexpr CodeNumber kOn = code(12, 1);

/// Place of an axis among the base axes I, J, K.
std::size_t place_of(Axis axis, const ControllerSettings& settings) {
  std::size_t i = 0;
  while (i + 1 < settings.base.size() && settings.base[i] != axis) ++i;
  return i;
}

/// Tool length offset stays as it is while the mode is on. An axis that has not moved by it yet counts as if
/// it had, unless G53 left it out for now.
void hold_length(Placement& placement, AxisVector& position, AxisSet axes) {
  placement.polar.length = placement.length;
  for (const Axis axis : axes) {
    const bool left_out = placement.length_left_out.contains(axis) && placement.length_taken[axis] == 0.0;
    if (left_out) placement.length[axis] = 0.0;
    placement.length_taken[axis] = placement.length[axis];
    position[axis] = placement.machine[axis] - placement.length[axis];
  }
}

}  // namespace

Plane polar_plane(const ControllerSettings& settings) {
  const std::size_t first = place_of(*settings.polar_linear, settings);
  return {*settings.polar_linear, *settings.polar_rotary, settings.base[(first + 2) % 3].value_or(Axis::Z)};
}

/// The centre of the virtual axis is named by the address of the base axis that it stands for.
char polar_center_address(Axis axis, const ControllerSettings& settings) {
  const std::size_t first = place_of(*settings.polar_linear, settings);
  return static_cast<char>('I' + (axis == *settings.polar_linear ? first : (first + 1) % 3));
}

bool BlockRun::polar() {
  if (!words_.has(Group::polar)) return polar_axes();
  const bool was_on = registers.modal[Group::polar] == kOn;
  registers.modal.set(Group::polar, words_[Group::polar]);
  const bool is_on = registers.modal[Group::polar] == kOn;
  if (is_on && !was_on) enter_polar();
  if (was_on && !is_on) leave_polar(registers, rules_.settings(), workpiece_origin(registers, tables_));
  return true;
}

void BlockRun::enter_polar() {
  const ControllerSettings& settings = rules_.settings();
  if (!settings.polar_linear || !settings.polar_rotary) return;
  const Axis linear = *settings.polar_linear;
  const Axis rotary = *settings.polar_rotary;
  Placement& placement = registers.placement;
  hold_length(placement, registers.position, rules_.machine().axes);
  const AxisVector origin = workpiece_origin(registers, tables_);
  PolarMode& mode = placement.polar;
  mode.on = true;
  mode.plane = registers.modal[Group::plane];
  mode.center = origin[linear] + placement.length_taken[linear];
  mode.zero = placement.machine[rotary];
  mode.angle = 0.0;
  mode.minus = placement.machine[linear] - mode.center < -kThroughOrigin;
  constexpr std::array<CodeNumber, 3> kPlanes{code(17), code(19), code(18)};
  registers.modal.set(Group::plane, kPlanes[place_of(linear, settings)]);
  registers.position[rotary] = placement.machine[rotary] = origin[rotary];
  placement.rest_wanted = true;
}

void leave_polar(Registers& registers, const ControllerSettings& settings, const AxisVector& origin) {
  Placement& placement = registers.placement;
  PolarMode& mode = placement.polar;
  if (!mode.on) return;
  const Axis linear = *settings.polar_linear;
  const Axis rotary = *settings.polar_rotary;
  const double side = mode.minus ? -1.0 : 1.0;
  const Vec2 point =
      side * Vec2{placement.machine[linear] - mode.center, placement.machine[rotary] - origin[rotary]};
  if (length(point) > kThroughOrigin) mode.angle += shortest_turn_deg(angle_of_deg(point) - mode.angle);
  placement.machine[linear] = mode.center + side * length(point);
  placement.machine[rotary] = mode.zero + mode.angle;
  placement.length = mode.length;
  for (const Axis axis : {linear, rotary})
    registers.position[axis] = placement.machine[axis] - placement.length_taken[axis];
  registers.modal.set(Group::plane, mode.plane);
  placement.rest_wanted = true;
  mode.on = false;
}

/// Only the axes of the plane and the one at right angles to it may be named.
bool BlockRun::polar_axes() {
  if (!registers.placement.polar.on) return true;
  const Plane plane = polar_plane(rules_.settings());
  for (const Axis axis : words_.axes()) {
    if (axis != plane.first && axis != plane.second && axis != plane.third)
      return refuse("0323H", span(axis));
  }
  return true;
}

/// A move that is planned in the coordinates of the program becomes one of the polar plane.
void BlockRun::into_polar_plane(Move& move) {
  PolarMode& mode = registers.placement.polar;
  if (!mode.on) return;
  const ControllerSettings& settings = rules_.settings();
  move.plane = polar_plane(settings);
  move.polar = {PolarForm::plane, mode.minus, move.plane.first, move.plane.second, mode.center, mode.zero};
  const double zero = workpiece_origin(registers, tables_)[move.plane.second];
  move.start[move.plane.second] -= zero;
  move.end[move.plane.second] -= zero;
  if (is_arc(move.mode)) move.arc.center[1] -= zero;
  move.each_axis = false;
  mode.angle += turn_around_origin_deg(polar_contour(move));
}

}  // namespace kerf::melsec
