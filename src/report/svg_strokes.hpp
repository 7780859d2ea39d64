#pragma once
// What is drawn of the moves of a run in one framed view: their strokes, and where tool radius compensation
// or normal line control acts in the plane that the view looks at, what these do.

#include <cstddef>
#include <string>
#include <vector>

#include "report/svg_view.hpp"

namespace kerf {

/// A stroke as wide as the tool, as data of an SVG path. Picture units with the scale of the horizontal axis
/// in both directions.
struct SweptBand {
  double width = 0.0;
  std::string data;
};

/// The strokes of the moves, as data of SVG paths.
struct ViewStrokes {
  std::string rapid;
  std::string line;
  std::string arc;
  std::string programmed;        ///< the programmed path of compensated moves
  std::string direction;         ///< ticks to where the tool points under normal line control
  std::vector<SweptBand> swept;  ///< the tool's path in compensated cutting moves, by width

  std::size_t size() const;
};

/// Collects the strokes of one view. Doubles the tolerance, starting below what a screen can show, until the
/// data is no larger than `most_bytes`, or no tolerance helps.
ViewStrokes strokes_of(const std::vector<TimedAction>& actions, const DrawingExtras& extras,
                       const ViewFrame& frame, std::size_t most_bytes);

/// Appends the strokes, clipped to the frame; from below: what the tool sweeps, the programmed path, rapids,
/// lines, arcs, directions.
void append_strokes(std::string& out, const ViewFrame& frame, const ViewStrokes& strokes);

}  // namespace kerf
