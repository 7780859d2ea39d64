// G00 to G03 and G53.

#include <cmath>
#include <utility>

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/block_run.hpp"
#include "dialect/melsec/placement.hpp"
#include "dialect/melsec/radius.hpp"
#include "execute/grid.hpp"
#include "execute/moves.hpp"
#include "geometry/arc_construction.hpp"

namespace kerf::melsec {
namespace {

constexpr double kLongestWay = 214748.3648;  // mm: 2^31 increments

double length_of(const Move& move) {
  if (is_arc(move.mode)) return move.arc.radius * std::abs(radians(move.arc.sweep));
  double sum = 0.0;
  for (const double way : (move.end - move.start).values) sum += way * way;
  return std::sqrt(sum);
}

}  // namespace

/// An absolute value of a rotation axis of type 0 leaves out whole turns, one of type 1 takes the shorter way
/// (4.2, rotation axis type). Positions run on over the turns, but the way is the one from the position that
/// is shown, from 0 to 359.9999 degrees; `shown` is the origin of the coordinate system it is shown in, and
/// `local` lies between that and the one the value is meant in (5.6 G52: a local position is the one shown
/// less the local offset).
double BlockRun::absolute_target(Axis axis, double from, double shown, double local, double value) const {
  const ControllerSettings& settings = rules_.settings();
  if (!settings.endless.contains(axis)) return on_grid(shown + local + value);
  double here = std::fmod(on_grid(from - shown), 360.0);
  if (here < 0.0) here += 360.0;
  double way = std::fmod(on_grid(value + local - here), 360.0);
  if (settings.shortest.contains(axis)) {
    if (way > 180.0) way -= 360.0;
    if (way <= -180.0) way += 360.0;
  }
  return on_grid(from + way);
}

bool BlockRun::targets(AxisVector& target) {
  const std::size_t system = work_system(registers);
  const AxisVector& origin = tables_.work_offsets[system];
  const AxisVector& local = tables_.local_offsets[system];
  for (const Axis axis : words_.axes()) {
    const AxisWord& word = words_.axis(axis);
    double value = 0.0;
    if (!accept(*word.word, position_of(*word.word), value)) return false;
    const bool direct = registers.placement.polar.on;  // all words are mm of the plane
    target[axis] = word.incremental ? on_grid(registers.position[axis] + value)
                   : direct
                       ? on_grid(origin[axis] + local[axis] + value)
                       : absolute_target(axis, registers.position[axis], origin[axis], local[axis], value);
  }
  return true;
}

/// A move that is none needs no feed: the manual's examples go to where they stand before the first F.
bool BlockRun::feed_given_for(MoveMode mode) {
  return mode == MoveMode::rapid || registers.feed_given || refuse("0311H", block_.span);
}

/// The first move behind G68 and G69 must say where to go.
bool BlockRun::absolute_first() {
  if (!registers.placement.absolute_wanted) return true;
  for (const Axis axis : words_.axes()) {
    if (words_.axis(axis).incremental) return refuse("0327H", span(axis));
  }
  registers.placement.absolute_wanted = false;
  return true;
}

bool BlockRun::push(MoveMode mode, const AxisVector& end, const AxisVector& commanded, const Plane& plane,
                    const Arc& arc) {
  if (taking_over_) return true;
  Placement& placement = registers.placement;
  Move& move = push_pathless(mode, mode == MoveMode::rapid ? rapid_feed_ : registers.feed, queue_);
  move.start = placement.machine;
  move.end = end;
  move.commanded = commanded;
  move.plane = plane;
  move.arc = arc;
  move.from_rest = std::exchange(placement.rest_wanted, false) || words_.has(kMachineMove);
  move.path_mode = path_mode_of(registers.modal[Group::path_mode]);
  move.rates = rate_set_of(move.path_mode);
  move.exact_stop = words_.has(kExactStop) || move.path_mode == PathMode::exact_stop;
  move.each_axis = mode == MoveMode::rapid && rules_.settings().each_axis;
  if (length_of(move) > kLongestWay) {
    return refuse("0310H", block_.span,
                  FixedText<200>::format("The path of the block is {:.4f} mm long.", length_of(move)));
  }
  if (!compensate(move)) return false;
  turn_along(move);
  into_polar_plane(move);
  // Where radius compensation and a polar plane move the axes only the toolpath knows, and it checks the
  // travel.
  if (move.compensation.side != Side::none || placement.polar.on) return true;
  const Travel& travel = rules_.travel();
  if (travel.contains(move)) return true;
  const auto excess = travel.leaving(move);
  if (!excess) return true;
  return refuse("0221H", words_.axes().contains(excess->axis) ? span(excess->axis) : block_.span,
                travel.message_for(*excess));
}

void BlockRun::arrive(const AxisVector& programmed, AxisSet named) {
  Placement& placement = registers.placement;
  const AxisSet moving = moving_axes(placement, named);
  registers.position = programmed;
  placement.machine = machine_position(placement, programmed, moving);
  for (const Axis axis : moving) placement.length_taken[axis] = placement.length[axis];
  arrive_turned();
}

/// The program's position of the normal line axis follows it (6.6, cautions).
void BlockRun::arrive_turned() {
  if (!turned_) return;
  const Axis axis = *rules_.settings().normal_line.axis;
  registers.position[axis] = registers.placement.machine[axis] = *turned_;
}

bool BlockRun::motion() {
  const CodeNumber mode = registers.modal[Group::motion];
  // G49 moves straight even while an arc code is in force.
  const bool cancels_length = words_[Group::length_compensation] == code(49);
  if (mode >= code(2) && !cancels_length) {
    const bool arc_words = !words_.axes().empty() || words_.find('I') != nullptr ||
                           words_.find('J') != nullptr || words_.find('K') != nullptr ||
                           words_.find('R') != nullptr;
    if (arc_words && !arc()) return false;
    corner_arc();
    return true;
  }
  if (words_.axes().empty()) return compensation_at_rest();
  AxisVector target = registers.position;
  if (!targets(target)) return false;
  if (!straight(mode == code(0) ? MoveMode::rapid : MoveMode::linear, target)) return false;
  corner_arc();
  return true;
}

bool BlockRun::straight(MoveMode mode, const AxisVector& target) {
  if (!absolute_first()) return false;
  const Placement& placement = registers.placement;
  const AxisVector end = machine_position(placement, target, moving_axes(placement, words_.axes()));
  if (end != placement.machine) {
    const AxisVector commanded = target - workpiece_origin(registers, tables_);
    if (!feed_given_for(mode) || !push(mode, end, commanded)) return false;
  } else if (!compensation_at_rest()) {
    return false;
  }
  arrive(target, words_.axes());
  return true;
}

/// G53 leaves tool length and rotation out of account for its block.
bool BlockRun::machine_move() {
  if (words_.axes().empty()) return true;
  Placement& placement = registers.placement;
  AxisVector end = placement.machine;
  for (const Axis axis : words_.axes()) {
    const AxisWord& word = words_.axis(axis);
    double value = 0.0;
    if (!accept(*word.word, position_of(*word.word), value)) return false;
    // In G91 the value is an increment like any other.
    end[axis] = word.incremental ? on_grid(end[axis] - placement.length_taken[axis] + value)
                                 : absolute_target(axis, end[axis], 0.0, 0.0, value);
  }
  if (!absolute_first()) return false;
  const MoveMode mode = registers.modal[Group::motion] == code(0) ? MoveMode::rapid : MoveMode::linear;
  if (end != placement.machine && !(feed_given_for(mode) && push(mode, end, end))) return false;
  arrive_at_machine(end);
  return true;
}

void BlockRun::arrive_at_machine(const AxisVector& machine) {
  Placement& placement = registers.placement;
  placement.machine = machine;
  for (const Axis axis : words_.axes()) {
    placement.length_taken[axis] = 0.0;
    placement.length_left_out.insert(axis);
    registers.position[axis] = machine[axis];
  }
  arrive_turned();
  const PlaneRotation& rotation = placement.rotation;
  if (!rotation.active) return;
  if (!words_.axes().contains(rotation.plane.first) && !words_.axes().contains(rotation.plane.second)) return;
  place_plane_at_machine(placement, !rules_.settings().rotation_takes_start, registers.position);
}

bool BlockRun::plane_axes(Plane& plane) {
  if (registers.placement.polar.on) {
    plane = polar_plane(rules_.settings());
    return true;
  }
  const std::optional<Plane> selected = plane_of(registers.modal[Group::plane], rules_.settings());
  if (!selected) return refuse("0317H", block_.span);
  plane = *selected;
  return true;
}

bool BlockRun::arc_axes(Plane& plane) {
  if (!plane_axes(plane)) return false;
  const Machine& machine = rules_.machine();
  if (!registers.placement.polar.on && machine[plane.first].type != machine[plane.second].type) {
    return refuse("030EH", block_.span,
                  FixedText<200>::format("{} is in mm and {} in degrees, or the other way round.",
                                         letter(plane.first), letter(plane.second)));
  }
  for (const Axis axis : words_.axes()) {
    if (axis != plane.first && axis != plane.second)
      return refuse(
          "030AH", span(axis),
          FixedText<200>::format("An arc code is in force, and {} is no axis of its plane.", letter(axis)),
          "Write G00 or G01 for a straight move, or select the plane you mean with G17, G18 or G19.");
  }
  return true;
}

char BlockRun::center_address(Axis axis) const {
  if (registers.placement.polar.on) return polar_center_address(axis, rules_.settings());
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
      spiral_from_center(start, end, center, clockwise, rules_.settings().arc_deviation + 1e-9);
  if (result.fault == ArcFault::zero_radius) {
    return refuse("0313H", block_.span, "The centre of the arc is its own start or end: it has no radius.");
  }
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

/// An arc begins where the program has the tool; behind G68 of type 1 or a change of its length it may not
/// yet be there.
bool BlockRun::stands_on_arc(const Plane& plane) {
  constexpr double kSamePlace = 5e-6;  // a few steps of the grid that turned positions lie on
  const Placement& placement = registers.placement;
  const AxisVector there =
      machine_position(placement, registers.position, AxisSet{plane.first, plane.second});
  for (const Axis axis : {plane.first, plane.second}) {
    if (std::abs(there[axis] - placement.machine[axis]) <= kSamePlace) continue;
    return refuse("0313H", block_.span,
                  "The tool does not stand where the arc begins: a straight move must come first.");
  }
  return true;
}

bool BlockRun::arc() {
  Plane plane;
  if (!arc_axes(plane) || !absolute_first()) return false;
  AxisVector target = registers.position;
  if (!targets(target) || !stands_on_arc(plane)) return false;
  const bool clockwise = registers.modal[Group::motion] == code(2);
  Arc geometry;
  bool nothing = false;
  const bool made = words_.find('R') != nullptr ? arc_by_radius(plane, target, clockwise, geometry, nothing)
                                                : arc_by_center(plane, target, clockwise, geometry);
  if (!made || nothing) return made;
  const MoveMode mode = clockwise ? MoveMode::clockwise : MoveMode::counterclockwise;
  if (!feed_given_for(mode)) return false;
  Placement& placement = registers.placement;
  const Vec2 center = turned_point(placement, plane, {geometry.center[0], geometry.center[1]});
  geometry.center = {center.x + placement.length[plane.first], center.y + placement.length[plane.second]};
  const AxisVector end = machine_position(placement, target, AxisSet{plane.first, plane.second});
  if (!push(mode, end, target - workpiece_origin(registers, tables_), plane, geometry)) return false;
  arrive(target, AxisSet{plane.first, plane.second});
  return true;
}

}  // namespace kerf::melsec
