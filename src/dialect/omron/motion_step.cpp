// G00 to G03.

#include <algorithm>
#include <cmath>

#include "dialect/omron/block_run.hpp"
#include "execute/grid.hpp"
#include "execute/moves.hpp"
#include "geometry/arc_construction.hpp"
#include "geometry/spiral.hpp"

namespace kerf::omron {
namespace {

constexpr AxisSet kSpace{Axis::X, Axis::Y, Axis::Z};
constexpr double kSpiral = 1e9;        // mm; start and end radius may differ as they like
constexpr double kHalfChord = 0.0001;  // mm; so much a radius may be too short

char center_address(Axis axis) {
  return static_cast<char>('I' + index(axis));
}

Vec2 point_of(const Plane& plane, const AxisVector& position) {
  return {position[plane.first], position[plane.second]};
}

double length_of(const AxisVector& way, AxisSet axes) {
  double sum = 0.0;
  for (const Axis axis : axes) sum += way[axis] * way[axis];
  return std::sqrt(sum);
}

}  // namespace

bool BlockRun::motion() {
  switch (registers.modal[Group::motion]) {
    case code(2):
      return arc(true);
    case code(3):
      return arc(false);
    default:
      break;
  }
  if (words_.axes().empty()) return true;
  AxisVector target = registers.position;
  if (!targets(target)) return false;
  return straight(registers.modal[Group::motion] == code(0) ? MoveMode::rapid : MoveMode::linear, target);
}

bool BlockRun::targets(AxisVector& target) {
  const AxisVector origin = workpiece_origin(registers, tables_);
  for (const Axis axis : words_.axes()) {
    double value = 0.0;
    if (!axis_value(axis, value)) return false;
    target[axis] = on_grid((incremental() ? registers.position[axis] : origin[axis]) + value);
  }
  return true;
}

/// Machine position of a programmed one: tool offset moves an axis only when the block names it.
AxisVector BlockRun::real_position(const AxisVector& programmed, AxisSet named) const {
  const Placement& placement = registers.placement;
  AxisVector real = is_transformed(placement) ? transformed(placement, programmed) : programmed;
  for (const Axis axis : rules_.machine().axes) {
    real[axis] =
        on_grid(real[axis]) + (named.contains(axis) ? placement.length[axis] : placement.length_taken[axis]);
  }
  return real;
}

void BlockRun::arrive(const AxisVector& programmed, AxisSet named) {
  Placement& placement = registers.placement;
  placement.machine = real_position(programmed, named);
  for (const Axis axis : named) placement.length_taken[axis] = placement.length[axis];
  registers.position = programmed;
}

bool BlockRun::straight(MoveMode mode, const AxisVector& target) {
  const AxisVector end = real_position(target, words_.axes());
  const AxisVector commanded = target - workpiece_origin(registers, tables_);
  if (end != registers.placement.machine && !push(mode, end, commanded)) return false;
  arrive(target, words_.axes());
  return true;
}

bool BlockRun::push(MoveMode mode, const AxisVector& end, const AxisVector& commanded, const Plane& plane,
                    const Arc& arc) {
  if (taking_over_) return true;
  const bool rapid = mode == MoveMode::rapid;
  if (!rapid && !registers.feed_given) return refuse("missing-feed", block_.span);
  Placement& placement = registers.placement;
  Move& move = push_pathless(mode, 0.0, queue_);
  move.start = placement.machine;
  move.end = end;
  move.commanded = commanded;
  move.plane = plane;
  move.arc = arc;
  move.each_axis = rapid;
  move.rates = registers.rates;
  move.feed_in_space = true;
  // The manual's text has G09 stop at the end of its block, its example also in front of it (OMR-184).
  const bool rest_wanted = std::exchange(placement.rest_wanted, false);
  move.from_rest = rest_wanted || (words_.has_exact_stop() && words_.exact_stop_leads());
  moved_ = true;
  move.path_mode = registers.modal[Group::path_mode] == code(61) ? PathMode::exact_stop : PathMode::cutting;
  move.exact_stop = words_.has_exact_stop() || move.path_mode == PathMode::exact_stop;
  if (!rapid) move.feed = effective_feed(move);
  if (!compensate(move)) return false;
  if (move.compensation.side != Side::none)
    return true;  // the toolpath knows where the tool goes, and checks it
  const Travel& travel = rules_.travel();
  if (travel.contains(move)) return true;
  const auto excess = travel.leaving(move);
  if (!excess) return true;
  return refuse("over-travel",
                words_.axes().contains(excess->axis) ? span(words_.axis(excess->axis)) : block_.span,
                travel.message_for(*excess));
}

/// The feed with which the move takes as long as F along X, Y and Z asks for, or as the rotary axes need at
/// their own velocity, if that is longer. It counts along X, Y and Z, and along all axes when only rotary
/// ones move.
double BlockRun::effective_feed(const Move& move) const {
  const AxisVector way = move.end - move.start;
  double turn = 0.0;
  for (const Axis axis : rules_.machine().axes) {
    if (rules_.machine()[axis].type == AxisType::rotary) turn = std::max(turn, std::abs(way[axis]));
  }
  double length = length_of(way, kSpace);
  if (is_arc(move.mode)) {
    const double end_radius =
        kerf::distance(point_of(move.plane, move.end), {move.arc.center[0], move.arc.center[1]});
    const double in_plane = way_of_arc(move.arc.radius, end_radius, radians(std::abs(move.arc.sweep)));
    length = std::hypot(in_plane, way[move.plane.third]);
  }
  const double feed = limited_feed(registers, settings_);
  const double turning_minutes = turn / settings_.operation(registers.rates).rotary_velocity;
  if (!(turning_minutes > length / feed)) return feed;
  return (length > 0.0 ? length : length_of(way, rules_.machine().axes)) / turning_minutes;
}

bool BlockRun::arc(bool clockwise) {
  const Plane plane = plane_in_force();
  const bool radius = words_.find('R') != nullptr;
  const bool center =
      words_.find('I') != nullptr || words_.find('J') != nullptr || words_.find('K') != nullptr;
  if (words_.axes().empty() && !radius && !center) return true;
  if (!radius && !center) return refuse("arc-words", block_.span);
  for (const Axis axis : {plane.first, plane.second}) {
    if (!rules_.machine().axes.contains(axis)) return refuse("no-axis", block_.span);
  }
  AxisVector target = registers.position;
  if (!targets(target)) return false;
  const Vec2 start = point_of(plane, registers.position);
  const Vec2 end = point_of(plane, target);
  Arc out;
  bool is_line = false;
  if (radius ? !arc_by_radius(start, end, clockwise, out, is_line)
             : !arc_by_center(plane, start, end, clockwise, out))
    return false;
  if (is_line) return straight(MoveMode::linear, target);

  const ArcChange change = arc_change(registers.placement, plane);
  if (!change.is_round) return refuse("arc-scaling", block_.span);
  if (change.turns_over) out.sweep = -out.sweep;
  out.radius *= change.magnification;
  AxisVector middle = registers.position;
  middle[plane.first] = out.center[0];
  middle[plane.second] = out.center[1];
  middle = transformed(registers.placement, middle);
  const AxisVector& taken = registers.placement.length_taken;
  out.center = {middle[plane.first] + taken[plane.first], middle[plane.second] + taken[plane.second]};
  const AxisVector commanded = target - workpiece_origin(registers, tables_);
  const MoveMode mode = out.sweep < 0.0 ? MoveMode::clockwise : MoveMode::counterclockwise;
  if (!push(mode, real_position(target, words_.axes()), commanded, plane, out)) return false;
  arrive(target, words_.axes());
  return true;
}

/// With a radius of 0 the block is a straight line; an arc to where it begins is none.
bool BlockRun::arc_by_radius(Vec2 start, Vec2 end, bool clockwise, Arc& out, bool& is_line) {
  const Word& word = *take('R');
  for (const char address : {'I', 'J', 'K'}) use(address);  // R has priority
  double radius = 0.0;
  if (!distance(word, radius)) return false;
  is_line = radius == 0.0 || kerf::distance(start, end) == 0.0;
  if (is_line) return true;
  const ArcResult result = arc_from_radius(start, end, radius, clockwise, kHalfChord);
  if (result.fault != ArcFault::none)
    return refuse("arc-radius", span(word),
                  FixedText<200>::format("The radius is {:.4f} mm too short for a chord of {:.4f} mm.",
                                         result.difference_mm, kerf::distance(start, end)));
  out = {{result.arc.center.x, result.arc.center.y}, result.arc.radius, result.arc.sweep_deg};
  return true;
}

/// The centre counts from the start; where the radii differ the arc is a spiral.
bool BlockRun::arc_by_center(const Plane& plane, Vec2 start, Vec2 end, bool clockwise, Arc& out) {
  Vec2 center = start;
  if (const Word* stray = words_.find(center_address(plane.third)))
    return refuse("arc-words", span(*stray), "This word gives no centre in the plane in force.");
  const std::array<Axis, 2> axes{plane.first, plane.second};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Word* word = take(center_address(axes[i]));
    double offset = 0.0;
    if (word != nullptr && !distance(*word, offset)) return false;
    (i == 0 ? center.x : center.y) += offset;
  }
  const ArcResult result = spiral_from_center(start, end, center, clockwise, kSpiral);
  if (result.fault != ArcFault::none) return refuse("arc-radius", block_.span);
  out = {{result.arc.center.x, result.arc.center.y}, result.arc.radius, result.arc.sweep_deg};
  return true;
}

}  // namespace kerf::omron
