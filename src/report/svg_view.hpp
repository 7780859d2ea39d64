#pragma once
// One framed view of the moves of a run, as SVG.

#include <string>
#include <string_view>
#include <vector>

#include "report/move_geometry.hpp"

namespace kerf {

/// Where a view stands on the picture and which part of the machine it shows.
struct ViewFrame {
  View view;
  double left = 0.0;  ///< picture units
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;
  double x_low = 0.0;    ///< machine coordinate at the left edge
  double y_low = 0.0;    ///< machine coordinate at the lower edge
  double x_scale = 1.0;  ///< picture units per mm (or degree) of the horizontal axis
  double y_scale = 1.0;
  bool has_scale_bar = false;
  std::string x_title;
  std::string y_title;

  Point2 place(Point2 machine) const {
    return {left + (machine.x - x_low) * x_scale, top + height - (machine.y - y_low) * y_scale};
  }
};

/// Appends the frame with its grid, ticks and titles.
void append_frame(std::string& out, const ViewFrame& frame);

/// Appends the rectangle that the cutting moves cover, when there are any.
void append_bounds(std::string& out, const ViewFrame& frame, const RunExtents& extents);

/// Appends a bar of a round length in the lower right corner of the frame.
void append_scale_bar(std::string& out, const ViewFrame& frame);

/// Appends a circle (start) and a square (end); they can stand at one place.
void append_start_and_end(std::string& out, const ViewFrame& frame, const AxisVector& start,
                          const AxisVector& end);

/// Appends a crossed circle for each hole; only sensible in a plan view.
void append_holes(std::string& out, const ViewFrame& frame, const std::vector<Hole>& holes);

}  // namespace kerf
