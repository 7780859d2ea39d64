#pragma once
// What the strokes of a plot mean.

#include <cstddef>
#include <string>
#include <vector>

#include "report/move_geometry.hpp"

namespace kerf {

/// What a plot shows.
struct Legend {
  bool rapid = false;
  bool line = false;
  bool arc = false;
  bool programmed = false;
  bool swept = false;
  bool direction = false;
  std::size_t holes = 0;
};

/// What a plot of the actions shows in views of X-Y, X-Z and Y-Z.
Legend legend_of(const std::vector<TimedAction>& actions, const DrawingExtras& extras, std::size_t holes);

/// From the middle of the first row to that of the last, picture units.
double legend_height(const Legend& legend);

/// Appends the legend with the left end of its first row at a place; nothing when nothing moves.
void append_legend(std::string& out, const Legend& legend, Point2 at);

}  // namespace kerf
