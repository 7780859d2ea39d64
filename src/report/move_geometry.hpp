#pragma once
// Where moves run, seen from a side: projections, extents and drilled holes, for the drawn reports.

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "execute/action.hpp"
#include "motion/run_record.hpp"
#include "report/programmed_path.hpp"

namespace kerf {

/// What the drawings show beside the moves of a record. The programmed path outlives it.
struct DrawingExtras {
  const ProgrammedPath* programmed = nullptr;  ///< null: not shown
  std::optional<Axis> normal_axis;             ///< the rotary axis of normal line control; none: not shown
};

struct Point2 {
  double x = 0.0;
  double y = 0.0;
};

/// A picture of two axes: the first to the right, the second upwards.
struct View {
  Axis horizontal = Axis::X;
  Axis vertical = Axis::Y;
};

inline constexpr View kPlanView{Axis::X, Axis::Y};
inline constexpr View kElevationView{Axis::X, Axis::Z};
inline constexpr View kSideView{Axis::Y, Axis::Z};

constexpr Point2 project(const AxisVector& position, View view) {
  return {position[view.horizontal], position[view.vertical]};
}

/// A stretch of one axis; empty until something is included.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return low > high; }
  double length() const { return empty() ? 0.0 : high - low; }
  double middle() const { return empty() ? 0.0 : 0.5 * (low + high); }
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void include(const Extent& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

/// The position after a fraction (0 to 1) of a move. The radius goes evenly from that of the start to that of
/// the end, as an arc within the tolerance of the controller may need.
AxisVector position_at(const Move& move, double fraction);

/// True when the view looks straight at the plane, from either side.
bool looks_at(View view, const Plane& plane);

/// True when the view looks straight at the plane of the arc, so that it appears as a circle.
bool appears_round(const Move& move, View view);

/// True when the move turns clockwise on a picture of the view. Only for an arc that appears round.
bool turns_clockwise(const Move& move, View view);

/// How far the tool reaches to either side of its path in the plane of a cutting move with tool radius
/// compensation in force, or of the one that ends it, mm: the amount without its sign. Of any other move 0:
/// its tool's radius is not known.
double swept_radius(const Move& move);

/// Where the tool points after a fraction (0 to 1) of a move under normal line control: a vector of length 1
/// on a picture of the view, y upwards. The axis stands at Move::normal_zero where the tool points along the
/// first axis of the plane. Only for a view that looks at the plane.
Point2 tool_direction(const Move& move, Axis axis, double fraction, View view);

/// A number of equal parts of a move (1 for a straight one) so that chords stay true to an arc in a picture.
int chord_count(const Move& move);

/// False for a move with a coordinate that is not finite, which no picture can show.
bool is_drawable(const Move& move);

/// The move of an action as drawings show it, kept in `figure` where it is another than that of the action;
/// null: there is none, or one with a coordinate that is not finite.
const Move* drawn_move(const TimedAction& timed, Move& figure);

/// Of figures on the work: which axis a picture shows them along, and which rotary axis makes them.
struct Across {
  Axis shown = Axis::Y;
  Axis rotary = Axis::C;
};

/// What a run covers.
struct RunExtents {
  std::array<Extent, kAxisCount> all;            ///< where the axes go, every move
  std::array<Extent, kAxisCount> cutting;        ///< likewise, moves at feed
  std::array<Extent, kAxisCount> drawn;          ///< pictures of every move, what the tool sweeps, and the
                                                 ///< programmed path
  std::array<Extent, kAxisCount> drawn_cutting;  ///< pictures of moves at feed
  std::optional<Across> across;                  ///< figures of a polar plane are among the pictures
  bool elevation_shapes = false;  ///< figures lie in the plane of the elevation, which must not
                                  ///< be stretched then: arcs, swept bands, directions
  bool side_shapes = false;       ///< likewise in the plane of the view from the side
  bool empty = true;              ///< nothing moves
};

RunExtents extents_of(const std::vector<TimedAction>& actions, const DrawingExtras& extras = {});

/// A hole that was drilled straight down: a feed in -Z and the way back to where the feed began, X and Y at
/// rest.
struct Hole {
  Point2 at;            ///< X, Y
  double bottom = 0.0;  ///< Z
};

/// All holes in order of execution; pecks into one hole count once.
std::vector<Hole> find_holes(const std::vector<TimedAction>& actions);

}  // namespace kerf
