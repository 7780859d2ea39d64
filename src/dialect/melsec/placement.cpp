#include "dialect/melsec/placement.hpp"

#include "execute/grid.hpp"

namespace kerf::melsec {

AxisSet moving_axes(const Placement& placement, AxisSet named) {
  const PlaneRotation& rotation = placement.rotation;
  if (!rotation.active) return named;
  const Axis first = rotation.plane.first;
  const Axis second = rotation.plane.second;
  if (!named.contains(first) && !named.contains(second)) return named;
  named.insert(first);
  named.insert(second);
  return named;
}

AxisVector machine_position(const Placement& placement, const AxisVector& programmed, AxisSet moving) {
  AxisVector turned_position = programmed;
  const PlaneRotation& rotation = placement.rotation;
  if (rotation.active) {
    const Vec2 point = turned_point(placement, rotation.plane,
                                    {programmed[rotation.plane.first], programmed[rotation.plane.second]});
    turned_position[rotation.plane.first] = on_grid(point.x);
    turned_position[rotation.plane.second] = on_grid(point.y);
  }
  AxisVector machine = placement.machine;
  for (const Axis axis : moving) machine[axis] = on_grid(turned_position[axis] + placement.length[axis]);
  return machine;
}

Vec2 turned_point(const Placement& placement, const Plane& plane, Vec2 programmed) {
  const PlaneRotation& rotation = placement.rotation;
  if (!rotation.active || !(rotation.plane == plane)) return programmed;
  return turned(programmed, rotation.center, rotation.turn);
}

void place_plane_at_machine(const Placement& placement, bool turned, AxisVector& programmed) {
  const PlaneRotation& rotation = placement.rotation;
  const Axis first = rotation.plane.first;
  const Axis second = rotation.plane.second;
  Vec2 point{placement.machine[first] - placement.length_taken[first],
             placement.machine[second] - placement.length_taken[second]};
  if (turned) point = turned_back(point, rotation.center, rotation.turn);
  programmed[first] = on_grid(point.x);
  programmed[second] = on_grid(point.y);
}

}  // namespace kerf::melsec
