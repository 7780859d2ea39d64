#pragma once
// Ticks along the path that show where the tool points under normal line control.

#include <string>

#include "report/svg_path.hpp"
#include "report/svg_view.hpp"

namespace kerf {

/// Collects the ticks of one view: on moves in the plane that the view looks at, from the tool's centre
/// outwards, evenly spaced on the picture, and at both ends of turns at rest.
class DirectionTicks {
 public:
  static constexpr double kLength = 11.0;   ///< of a tick, picture units
  static constexpr double kSpacing = 24.0;  ///< between ticks along the path

  DirectionTicks(const ViewFrame& frame, double tolerance);

  /// The next move of a run that can be drawn; `axis` turns the tool.
  void add(const Move& move, Axis axis);

  /// The data of the ticks. Nothing may be added afterwards.
  const std::string& finish() { return path_.finish(); }

 private:
  void add_turn(const Move& move, Axis axis);
  void tick(const Move& move, Axis axis, double fraction);

  ViewFrame frame_;
  SvgPath path_;
  double since_ = kSpacing;  ///< way along the path since the last tick
};

}  // namespace kerf
