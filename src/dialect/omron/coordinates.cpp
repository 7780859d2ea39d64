#include "dialect/omron/coordinates.hpp"

#include <cmath>

namespace kerf::omron {
namespace {

AxisVector rotated(const PlaneRotation& rotation, AxisVector position, bool back) {
  if (!rotation.active) return position;
  Vec2 point{position[rotation.plane.first], position[rotation.plane.second]};
  point = back ? turned_back(point, rotation.center, rotation.turn)
               : turned(point, rotation.center, rotation.turn);
  position[rotation.plane.first] = point.x;
  position[rotation.plane.second] = point.y;
  return position;
}

}  // namespace

bool is_transformed(const Placement& placement) {
  return placement.rotation.active || placement.transformation.scaled ||
         !placement.transformation.mirrored.empty();
}

AxisVector transformed(const Placement& placement, AxisVector programmed) {
  const AxisTransformation& change = placement.transformation;
  for (const Axis axis : change.mirrored) programmed[axis] = 2.0 * change.mirrors[axis] - programmed[axis];
  if (change.scaled) {
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
      const double center = change.center[axis];
      programmed[axis] = center + change.magnification[axis] * (programmed[axis] - center);
    }
  }
  return rotated(placement.rotation, programmed, false);
}

AxisVector in_front_of(Change change, const Placement& placement, AxisVector real) {
  const AxisTransformation& own = placement.transformation;
  if (change == Change::rotation) return real;
  real = rotated(placement.rotation, real, true);
  if (change == Change::scaling || !own.scaled) return real;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
    real[axis] = own.center[axis] + (real[axis] - own.center[axis]) / own.magnification[axis];
  return real;
}

AxisVector untransformed(const Placement& placement, AxisVector real) {
  const AxisTransformation& change = placement.transformation;
  real = in_front_of(Change::mirroring, placement, real);
  for (const Axis axis : change.mirrored) real[axis] = 2.0 * change.mirrors[axis] - real[axis];
  return real;
}

ArcChange arc_change(const Placement& placement, const Plane& plane) {
  const AxisTransformation& change = placement.transformation;
  ArcChange arc;
  for (const Axis axis : {plane.first, plane.second}) {
    if (change.mirrored.contains(axis)) arc.turns_over = !arc.turns_over;
    if (change.scaled && change.magnification[axis] < 0.0) arc.turns_over = !arc.turns_over;
  }
  if (!change.scaled) return arc;
  arc.magnification = std::abs(change.magnification[plane.first]);
  arc.is_round = arc.magnification == std::abs(change.magnification[plane.second]);
  return arc;
}

void release_transformations(Registers& registers) {
  registers.placement.transformation = {};
  registers.placement.rotation.active = false;
  registers.modal.set(Group::scaling, code(50));
  registers.modal.set(Group::mirror, code(50, 1));
  registers.modal.set(Group::rotation, code(69));
}

}  // namespace kerf::omron
