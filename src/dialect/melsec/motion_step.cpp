// G00 to G03 and G53.

#include <cmath>

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/block_run.hpp"
#include "execute/grid.hpp"
#include "execute/moves.hpp"
#include "geometry/arc_construction.hpp"

namespace kerf::melsec {
bool BlockRun::targets(AxisVector& target) {
  const AxisVector origin = workpiece_origin(registers, tables_);
  for (const Axis axis : words_.axes()) {
    const AxisWord& word = words_.axis(axis);
    double value = 0.0;
    if (!accept(*word.word, position_of(*word.word), value)) return false;
    target[axis] = on_grid((word.incremental ? registers.position[axis] : origin[axis]) + value);
  }
  return true;
}

bool BlockRun::cutting_feed() {
  return registers.feed_given || refuse("0311H", block_.span);
}

bool BlockRun::push(MoveMode mode, const AxisVector& target, const Plane& plane, const Arc& arc) {
  Move& move = push_straight(mode, target, registers, workpiece_origin(registers, tables_), queue_);
  move.plane = plane;
  move.arc = arc;
  if (words_.has(kMachineMove)) move.commanded = move.end;  // written in machine coordinates
  move.exact_stop = words_.has(kExactStop) || registers.modal[Group::path_mode] == code(61);
  const Travel& travel = rules_.travel();
  if (travel.contains(move) || !travel.contains(move.start)) return true;
  const Excess excess = travel.excess_of(move).value_or(Excess{});
  return refuse("0221H", words_.axes().contains(excess.axis) ? span(excess.axis) : block_.span,
                travel.message_for(excess));
}

bool BlockRun::motion() {
  const CodeNumber mode = registers.modal[Group::motion];
  if (mode >= code(2)) {
    const bool arc_words = !words_.axes().empty() || words_.find('I') != nullptr ||
                           words_.find('J') != nullptr || words_.find('K') != nullptr ||
                           words_.find('R') != nullptr;
    return !arc_words || arc();
  }
  if (words_.axes().empty()) return true;
  AxisVector target = registers.position;
  if (!targets(target)) return false;
  return straight(mode == code(0) ? MoveMode::rapid : MoveMode::linear, target);
}

bool BlockRun::straight(MoveMode mode, const AxisVector& target) {
  if (mode != MoveMode::rapid && !cutting_feed()) return false;
  return target == registers.position || push(mode, target);
}

bool BlockRun::machine_move() {
  AxisVector target = registers.position;
  for (const Axis axis : words_.axes()) {
    const AxisWord& word = words_.axis(axis);
    double value = 0.0;
    if (!accept(*word.word, position_of(*word.word), value)) return false;
    // In G91 the value is an increment like any other.
    target[axis] = word.incremental ? on_grid(registers.position[axis] + value) : value;
  }
  const bool rapid = registers.modal[Group::motion] == code(0);
  return words_.axes().empty() || straight(rapid ? MoveMode::rapid : MoveMode::linear, target);
}

bool BlockRun::arc_axes(Plane& plane) {
  const auto& base = rules_.settings().base;
  const CodeNumber number = registers.modal[Group::plane];
  const std::size_t first = number == code(17) ? 0 : number == code(18) ? 2 : 1;
  const auto a = base[first];
  const auto b = base[(first + 1) % 3];
  if (!a || !b) return refuse("0317H", block_.span);
  plane = {*a, *b, base[(first + 2) % 3].value_or(Axis::Z)};
  for (const Axis axis : words_.axes()) {
    if (axis != plane.first && axis != plane.second) return refuse("030AH", span(axis));
  }
  return true;
}

char BlockRun::center_address(Axis axis) const {
  const auto& base = rules_.settings().base;
  for (std::size_t i = 0; i < base.size(); ++i) {
    if (base[i] == axis) return static_cast<char>('I' + static_cast<int>(i));
  }
  return 'I';
}

bool BlockRun::arc_center(const Plane& plane, Vec2 start, Vec2& center) {
  center = start;
  for (const Axis axis : {plane.first, plane.second}) {
    const Word* word = words_.find(center_address(axis));
    if (word == nullptr) continue;
    double distance = 0.0;
    if (!accept(*word, position_of(*word), distance)) return false;
    (axis == plane.first ? center.x : center.y) += distance;
  }
  return true;
}

bool BlockRun::arc_by_center(const Plane& plane, const AxisVector& target, bool clockwise, Arc& out) {
  const Vec2 start{registers.position[plane.first], registers.position[plane.second]};
  const Vec2 end{target[plane.first], target[plane.second]};
  const bool none = words_.find(center_address(plane.first)) == nullptr &&
                    words_.find(center_address(plane.second)) == nullptr;
  if (none)
    return refuse("0306H", block_.span, "The block gives neither the centre nor the radius of the arc.");
  Vec2 center;
  if (!arc_center(plane, start, center)) return false;
  const ArcResult result =
      arc_from_center(start, end, center, clockwise, rules_.settings().arc_deviation + 1e-9);
  if (result.fault != ArcFault::none) {
    return refuse("0313H", block_.span,
                  FixedText<200>::format("The radius at the start and at the end of the arc differ by {:.4f} "
                                         "mm; {} mm is allowed.",
                                         result.difference_mm, rules_.settings().arc_deviation));
  }
  out = {{result.arc.center.x, result.arc.center.y}, result.arc.radius, result.arc.sweep_deg};
  return true;
}

bool BlockRun::arc_by_radius(const Plane& plane, const AxisVector& target, bool clockwise, Arc& out,
                             bool& nothing) {
  const Vec2 start{registers.position[plane.first], registers.position[plane.second]};
  const Vec2 end{target[plane.first], target[plane.second]};
  const Word& word = *words_.find('R');
  double radius = 0.0;
  if (!accept(word, radius_of(word), radius)) return false;
  const ControllerSettings& settings = rules_.settings();
  const double chord = std::hypot(end.x - start.x, end.y - start.y);
  nothing = chord < 1e-9;
  if (nothing) return true;
  if (radius == 0.0) return refuse("0314H", span(word));
  // A chord that is nearly the diameter makes a half circle about its middle (arc centre deviation).
  const double permissible = settings.arc_center_compensation < 0.0    ? 0.0
                             : settings.arc_center_compensation == 0.0 ? 0.0002
                                                                       : settings.arc_center_compensation;
  if (std::abs(chord - 2.0 * std::abs(radius)) <= permissible + 1e-9)
    radius = std::copysign(chord / 2.0, radius);
  const ArcResult result = arc_from_radius(start, end, radius, clockwise, settings.arc_deviation + 1e-9);
  if (result.fault != ArcFault::none) {
    return refuse("0313H", span(word),
                  FixedText<200>::format("The radius is {:.4f} mm too small to reach the end point.",
                                         result.difference_mm));
  }
  out = {{result.arc.center.x, result.arc.center.y}, result.arc.radius, result.arc.sweep_deg};
  return true;
}

bool BlockRun::arc() {
  Plane plane;
  if (!arc_axes(plane)) return false;
  AxisVector target = registers.position;
  if (!targets(target)) return false;
  const bool clockwise = registers.modal[Group::motion] == code(2);
  Arc geometry;
  bool nothing = false;
  const bool made = words_.find('R') != nullptr ? arc_by_radius(plane, target, clockwise, geometry, nothing)
                                                : arc_by_center(plane, target, clockwise, geometry);
  if (!made || nothing) return made;
  const MoveMode mode = clockwise ? MoveMode::clockwise : MoveMode::counterclockwise;
  return cutting_feed() && push(mode, target, plane, geometry);
}

}  // namespace kerf::melsec
