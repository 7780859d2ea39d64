#pragma once
// Where moves run, seen from a side: projections, extents and drilled holes, for the drawn reports.

#include <algorithm>
#include <limits>
#include <vector>

#include "execute/action.hpp"
#include "motion/run_record.hpp"

namespace kerf {

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
};

/// The position after a fraction (0 to 1) of a move. The radius goes evenly from that of the start to that of
/// the end, as an arc within the tolerance of the controller may need.
AxisVector position_at(const Move& move, double fraction);

/// True when the view looks straight at the plane of the arc, so that it appears as a circle.
bool appears_round(const Move& move, View view);

/// True when the move turns clockwise on a picture of the view. Only for an arc that appears round.
bool turns_clockwise(const Move& move, View view);

/// A number of equal parts of a move (1 for a straight one) so that chords stay true to an arc in a picture.
int chord_count(const Move& move);

/// False for a move with a coordinate that is not finite, which no picture can show.
bool is_drawable(const Move& move);

/// What a run covers.
struct RunExtents {
  std::array<Extent, kAxisCount> all;      ///< every move
  std::array<Extent, kAxisCount> cutting;  ///< moves at feed
  bool empty = true;                       ///< nothing moves
};

RunExtents extents_of(const std::vector<TimedAction>& actions);

/// A hole that was drilled straight down: a feed in -Z and the way back to where the feed began, X and Y at
/// rest.
struct Hole {
  Point2 at;            ///< X, Y
  double bottom = 0.0;  ///< Z
};

/// All holes in order of execution; pecks into one hole count once.
std::vector<Hole> find_holes(const std::vector<TimedAction>& actions);

}  // namespace kerf
