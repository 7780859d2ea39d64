#include "report/move_geometry.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "execute/polar_plane.hpp"
#include "report/polar_picture.hpp"

namespace kerf {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;
constexpr double kSamePlace_mm = 1e-6;

bool moves_only_z(const Move& move) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (i == index(Axis::Z)) continue;
    if (std::abs(move.end.values[i] - move.start.values[i]) > kSamePlace_mm) return false;
  }
  return !is_arc(move.mode);
}

/// Follows successive moves that go only up and down at one place, until the tool leaves it.
class HoleFinder {
 public:
  explicit HoleFinder(std::vector<Hole>& holes) : holes_(holes) {}

  void follow(const Move& move) {
    if (!moves_only_z(move)) {
      leave();
      return;
    }
    const double start = move.start[Axis::Z];
    const double end = move.end[Axis::Z];
    const bool feeds_down = move.mode == MoveMode::linear && end < start - kSamePlace_mm;
    if (feeds_down && !drilling_) feed_start_ = start;
    drilling_ = drilling_ || feeds_down;
    if (feeds_down) bottom_ = std::min(bottom_, end);
    at_ = {move.end[Axis::X], move.end[Axis::Y]};
    height_ = end;
  }

  void leave() {
    const bool came_back = drilling_ && height_ >= feed_start_ - kSamePlace_mm;
    if (came_back) holes_.push_back({at_, bottom_});
    drilling_ = false;
    bottom_ = std::numeric_limits<double>::infinity();
  }

 private:
  std::vector<Hole>& holes_;
  bool drilling_ = false;    ///< fed downwards since the tool came here
  double feed_start_ = 0.0;  ///< where the first feed downwards began
  double bottom_ = std::numeric_limits<double>::infinity();
  double height_ = 0.0;
  Point2 at_;
};

using Extents = std::array<Extent, kAxisCount>;

Extents extents_of_move(const Move& move) {
  Extents extents;
  // Enough chords that no arc leaves the extent by more than 0.03 % of its radius.
  const int parts = is_arc(move.mode) ? 2 * chord_count(move) : 1;
  for (int part = 0; part <= parts; ++part) {
    const AxisVector position = position_at(move, static_cast<double>(part) / parts);
    for (std::size_t i = 0; i < kAxisCount; ++i) extents[i].include(position.values[i]);
  }
  return extents;
}

/// Where the axes of the machine go.
Extents extents_of_axes(const Move& move) {
  if (move.polar.form == PolarForm::none) return extents_of_move(move);
  Extents extents;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    extents[i].include(move.start.values[i]);
    extents[i].include(move.end.values[i]);
  }
  const PolarReach reach = polar_reach(move);
  extents[index(move.polar.linear)].include({reach.linear_low, reach.linear_high});
  extents[index(move.polar.rotary)].include({reach.rotary_low, reach.rotary_high});
  return extents;
}

void include(Extents& all, const Extents& more) {
  for (std::size_t i = 0; i < kAxisCount; ++i) all[i].include(more[i]);
}

/// What the tool reaches beside a move with these extents.
Extents widened(Extents extents, const Move& move) {
  const double radius = swept_radius(move);
  for (const Axis axis : {move.plane.first, move.plane.second}) {
    extents[index(axis)].low -= radius;
    extents[index(axis)].high += radius;
  }
  return extents;
}

}  // namespace

AxisVector position_at(const Move& move, double fraction) {
  AxisVector position;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    position.values[i] = move.start.values[i] + fraction * (move.end.values[i] - move.start.values[i]);
  }
  // The end itself, not what rounding makes of it.
  if (!is_arc(move.mode) || fraction <= 0.0 || fraction >= 1.0) return position;
  const double first = move.start[move.plane.first] - move.arc.center[0];
  const double second = move.start[move.plane.second] - move.arc.center[1];
  const double end_radius = std::hypot(move.end[move.plane.first] - move.arc.center[0],
                                       move.end[move.plane.second] - move.arc.center[1]);
  const double radius = std::hypot(first, second) * (1.0 - fraction) + end_radius * fraction;
  const double angle = std::atan2(second, first) + fraction * move.arc.sweep * kRadians;
  position[move.plane.first] = move.arc.center[0] + radius * std::cos(angle);
  position[move.plane.second] = move.arc.center[1] + radius * std::sin(angle);
  return position;
}

bool looks_at(View view, const Plane& plane) {
  return (plane.first == view.horizontal && plane.second == view.vertical) ||
         (plane.first == view.vertical && plane.second == view.horizontal);
}

bool appears_round(const Move& move, View view) {
  return is_arc(move.mode) && looks_at(view, move.plane);
}

bool turns_clockwise(const Move& move, View view) {
  const bool mirrored = move.plane.first == view.vertical;
  return (move.arc.sweep < 0.0) != mirrored;
}

double swept_radius(const Move& move) {
  const bool cuts = move.mode != MoveMode::rapid;
  return cuts ? std::abs(move.compensation.amount) : 0.0;
}

Point2 tool_direction(const Move& move, Axis axis, double fraction, View view) {
  const double stands = move.start[axis] + fraction * (move.end[axis] - move.start[axis]);
  const double angle = (stands - move.normal_zero) * kRadians;
  AxisVector direction;
  direction[move.plane.first] = std::cos(angle);
  direction[move.plane.second] = std::sin(angle);
  return project(direction, view);
}

int chord_count(const Move& move) {
  if (!is_arc(move.mode)) return 1;
  constexpr double kDegreesPerChord = 6.0;
  constexpr double kMostChords = 720.0;
  return static_cast<int>(
      std::clamp(std::ceil(std::abs(move.arc.sweep) / kDegreesPerChord), 2.0, kMostChords));
}

bool is_drawable(const Move& move) {
  bool finite = true;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    finite = finite && std::isfinite(move.start.values[i]) && std::isfinite(move.end.values[i]);
  }
  if (is_arc(move.mode)) {
    finite = finite && std::isfinite(move.arc.center[0]) && std::isfinite(move.arc.center[1]) &&
             std::isfinite(move.arc.sweep);
  }
  return finite;
}

const Move* drawn_move(const TimedAction& timed, Move& figure) {
  const auto* move = std::get_if<Move>(&timed.action.what);
  if (move == nullptr || !is_drawable(*move)) return nullptr;
  if (!figure_axis(*move)) return move;
  figure = as_figure(*move);
  return &figure;
}

RunExtents extents_of(const std::vector<TimedAction>& actions, const DrawingExtras& extras) {
  RunExtents extents;
  Move figure;
  for (const TimedAction& timed : actions) {
    const Move* const move = drawn_move(timed, figure);
    if (move == nullptr) continue;
    extents.empty = false;
    if (is_arc(move->mode) || swept_radius(*move) > 0.0 || move->normal_line != Side::none) {
      extents.elevation_shapes = extents.elevation_shapes || looks_at(kElevationView, move->plane);
      extents.side_shapes = extents.side_shapes || looks_at(kSideView, move->plane);
    }
    const Move& of_axes = std::get<Move>(timed.action.what);
    const Extents reached = extents_of_axes(of_axes);
    Extents covered = extents_of_move(*move);
    if (move != &of_axes) {
      covered[index(of_axes.polar.rotary)] = reached[index(of_axes.polar.rotary)];
      extents.across = Across{*figure_axis(of_axes), of_axes.polar.rotary};
    }
    include(extents.all, reached);
    if (move->mode != MoveMode::rapid) {
      include(extents.cutting, reached);
      include(extents.drawn_cutting, covered);
    }
    include(extents.drawn, widened(covered, *move));
  }
  const std::size_t programmed = extras.programmed == nullptr ? 0 : extras.programmed->size();
  for (std::size_t i = 0; i < programmed; ++i) {
    const Extents covered = extents_of_move((*extras.programmed)[i]);
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
      extents.drawn[index(axis)].include(covered[index(axis)]);
  }
  return extents;
}

std::vector<Hole> find_holes(const std::vector<TimedAction>& actions) {
  std::vector<Hole> holes;
  HoleFinder finder(holes);
  Move figure;
  for (const TimedAction& timed : actions) {
    const Move* const move = drawn_move(timed, figure);
    if (move != nullptr) finder.follow(*move);
  }
  finder.leave();
  return holes;
}

}  // namespace kerf
