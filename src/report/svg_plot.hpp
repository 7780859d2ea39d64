#pragma once
// A picture of a run: plan and elevation of its moves as one SVG file.

#include <string>
#include <string_view>

#include "machine/machine.hpp"
#include "motion/run_record.hpp"
#include "report/move_geometry.hpp"

namespace kerf {

/// What the picture says about itself.
struct SvgPlotTitle {
  std::string_view title;  ///< usually the file name or program number
  std::string_view maker;  ///< e.g. "kerf 0.1.0"
};

/// The plan (X-Y) with the elevation (X-Z) below it at the same horizontal scale, and for each rotary axis
/// that turns a view unrolled along the linear axis it turns about (X-A, Y-B, Z-C). Machine coordinates, mm
/// and degrees. Rapids are thin and dashed, lines solid, arcs heavier and true SVG arcs; drilled holes are
/// marked in the plan. A view that looks straight at the plane of tool radius compensation shows the
/// programmed path and what the tool sweeps beside its centre; one at the plane of normal line control, where
/// the tool points. The file stays below a few megabytes however long the run is: strokes below the
/// picture's resolution are joined.
std::string svg_plot(const RunRecord& record, const Machine& machine, const SvgPlotTitle& title,
                     const DrawingExtras& extras = {});

}  // namespace kerf
