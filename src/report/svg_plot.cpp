#include "report/svg_plot.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "report/drawing_scale.hpp"
#include "report/move_geometry.hpp"
#include "report/number_text.hpp"
#include "report/svg_legend.hpp"
#include "report/svg_strokes.hpp"
#include "report/svg_view.hpp"
#include "report/text_escape.hpp"

namespace kerf {
namespace {

constexpr double kWidth = 1000.0;
constexpr double kLeft = 78.0;
constexpr double kFrameWidth = 898.0;
constexpr double kLegendTop = 82.0;            ///< middle of the first row
constexpr double kBelowLegend = 22.0;          ///< from the middle of the last row to the plan
constexpr double kGap = 58.0;                  ///< below a frame: ticks and title
constexpr double kMargin = 1.12;               ///< frame over extent
constexpr std::size_t kMostBytes = 1'500'000;  ///< of the strokes of one view

// Okabe and Ito's palette (Color Universal Design, 2008), which people with any colour vision can tell apart;
// every kind of stroke also differs in weight or dashes.
constexpr std::string_view kStyle = R"(<style>
text{font-family:system-ui,-apple-system,"Segoe UI","DejaVu Sans",Arial,sans-serif;fill:#1b1f24}
.title{font-size:21px;font-weight:600}
.totals{font-size:13.5px;fill:#3d444d}
.tick text{font-size:12px;fill:#3d444d}
.axis text{font-size:13px;font-weight:600}
.legend text{font-size:13px}
.note{font-size:12.5px;fill:#3d444d}
.grid,.frame,.bounds,.rapid,.line,.arc,.hole,.scale,.start,.end,.programmed,.direction{fill:none;vector-effect:non-scaling-stroke}
.grid{stroke:#e4e7eb;stroke-width:1}
.frame{stroke:#8b949e;stroke-width:1}
.bounds{stroke:#57606a;stroke-width:1;stroke-dasharray:1 4}
.rapid,.line,.arc{stroke-linecap:round;stroke-linejoin:round}
.rapid{stroke:#6e7781;stroke-width:1;stroke-dasharray:5 4;stroke-linecap:butt}
.line{stroke:#0072b2;stroke-width:1.4}
.arc{stroke:#d55e00;stroke-width:2.6}
.swept{fill:none;stroke:#56b4e9;stroke-linecap:round;stroke-linejoin:round;opacity:.3}
.programmed{stroke:#1b1f24;stroke-width:1.1;stroke-dasharray:9 3;stroke-linejoin:round}
.direction{stroke:#7b3294;stroke-width:1.5;stroke-linecap:round}
.hole{stroke:#007a5a;stroke-width:1.6}
.scale{stroke:#1b1f24;stroke-width:1.6}
.start{stroke:#1b1f24;stroke-width:1.8}
.end{fill:#1b1f24;stroke:#fff;stroke-width:1}
.label{fill:#fff;fill-opacity:.85}
</style>
)";

struct Ends {
  AxisVector start;
  AxisVector end;
};

std::optional<Ends> ends_of(const RunRecord& record) {
  std::optional<Ends> ends;
  Move figure;
  for (const TimedAction& timed : record.actions) {
    const Move* const move = drawn_move(timed, figure);
    if (move == nullptr) continue;
    if (!ends) ends = Ends{move->start, move->end};
    ends->end = move->end;
  }
  return ends;
}

/// "Y (mm)", and what else is shown along the axis.
std::string length_title(const RunExtents& extents, Axis axis) {
  if (!extents.across || extents.across->shown != axis) return fmt::format("{} (mm)", letter(axis));
  return fmt::format("{}, {} across (mm)", letter(axis), letter(extents.across->rotary));
}

/// One scale for both axes, chosen so that it fills the frame's width or its largest height.
ViewFrame true_frame(const RunExtents& extents, View view, double top) {
  constexpr double kLowest = 200.0;
  constexpr double kHighest = 580.0;
  constexpr double kSmallestRange = 1e-6;
  constexpr double kPointRange = 10.0;  // mm around a run that stays at one point
  constexpr double kScaleBar = 28.0;    // room below the moves
  const Extent& x = extents.drawn[index(view.horizontal)];
  const Extent& y = extents.drawn[index(view.vertical)];
  double x_range = x.length() * kMargin;
  const double y_range = y.length() * kMargin;
  if (std::max(x_range, y_range) < kSmallestRange) x_range = kPointRange;

  ViewFrame frame;
  frame.view = view;
  frame.left = kLeft;
  frame.top = top;
  frame.width = kFrameWidth;
  const double fill_width = kFrameWidth / std::max(x_range, kSmallestRange);
  const double fill_height = kHighest / std::max(y_range, kSmallestRange);
  frame.x_scale = frame.y_scale = std::min(fill_width, fill_height);
  const double moves_height = std::clamp(y_range * frame.y_scale, kLowest, kHighest);
  frame.height = moves_height + kScaleBar;
  frame.x_low = x.middle() - frame.width / frame.x_scale / 2.0;
  frame.y_low = y.middle() - (moves_height / 2.0 + kScaleBar) / frame.y_scale;
  frame.has_scale_bar = true;
  frame.x_title = length_title(extents, view.horizontal);
  frame.y_title = length_title(extents, view.vertical);
  return frame;
}

/// The elevation below the plan: the same X, and the same scale of Z unless it would be too flat to read or
/// too high.
ViewFrame elevation_frame(const RunExtents& extents, const ViewFrame& plan) {
  constexpr double kLowest = 90.0;
  constexpr double kHighest = 340.0;
  constexpr double kFlat = 1e-6;
  const Extent& z = extents.drawn[index(Axis::Z)];
  ViewFrame frame = plan;
  frame.has_scale_bar = false;
  frame.view = kElevationView;
  frame.top = plan.top + plan.height + kGap;
  const double natural = z.length() * kMargin * plan.y_scale;
  double factor = 1.0;
  if (z.length() > kFlat && natural < kLowest) factor = round_up_125(kLowest / natural);
  if (natural > kHighest) factor = round_down_125(kHighest / natural);
  frame.y_scale = plan.y_scale * factor;
  frame.height = std::max(natural * factor, kLowest);
  frame.y_low = z.middle() - frame.height / frame.y_scale / 2.0;
  frame.y_title = length_title(extents, Axis::Z);
  if (factor != 1.0) frame.y_title += ", drawn ×" + rounded_text(factor, 6);
  return frame;
}

/// A rotary axis against the linear axis it turns about, each filling the frame.
ViewFrame unrolled_frame(const RunExtents& extents, View view, double top) {
  constexpr double kHeight = 190.0;
  constexpr double kSmallestRange = 1e-6;
  ViewFrame frame;
  frame.view = view;
  frame.left = kLeft;
  frame.top = top;
  frame.width = kFrameWidth;
  frame.height = kHeight;
  const Extent& x = extents.drawn[index(view.horizontal)];
  const Extent& y = extents.drawn[index(view.vertical)];
  const double x_range = x.length() < kSmallestRange ? 10.0 : x.length() * kMargin;
  const double y_range = y.length() < kSmallestRange ? 10.0 : y.length() * kMargin;
  frame.x_scale = frame.width / x_range;
  frame.y_scale = frame.height / y_range;
  frame.x_low = x.middle() - x_range / 2.0;
  frame.y_low = y.middle() - y_range / 2.0;
  frame.x_title = fmt::format("{} (mm)", letter(view.horizontal));
  frame.y_title = fmt::format("{} (°), unrolled", letter(view.vertical));
  return frame;
}

std::vector<ViewFrame> frames_of(const RunExtents& extents, const Machine& machine, double top) {
  std::vector<ViewFrame> frames{true_frame(extents, kPlanView, top)};
  const auto below = [&frames] { return frames.back().top + frames.back().height + kGap; };
  if (extents.elevation_shapes) {
    frames.push_back(true_frame(extents, kElevationView, below()));
  } else if (machine.axes.contains(Axis::Z)) {
    frames.push_back(elevation_frame(extents, frames.front()));
  }
  if (extents.side_shapes) frames.push_back(true_frame(extents, kSideView, below()));
  for (const View view : {View{Axis::X, Axis::A}, View{Axis::Y, Axis::B}, View{Axis::Z, Axis::C}}) {
    constexpr double kTurning = 1e-6;
    const bool turns = machine.axes.contains(view.vertical) &&
                       machine[view.vertical].type == AxisType::rotary &&
                       extents.all[index(view.vertical)].length() > kTurning;
    if (!turns) continue;
    frames.push_back(unrolled_frame(extents, view, below()));
    const ViewFrame& plan = frames.front();
    ViewFrame& frame = frames.back();
    if (view.horizontal == Axis::X) {
      frame.x_scale = plan.x_scale;
      frame.x_low = plan.x_low;
    }
  }
  return frames;
}

std::string shortened(std::string_view text, std::size_t most) {
  std::string out;
  std::size_t count = 0;
  while (!text.empty() && count < most) {
    const Character character = first_character(text);
    append_utf8(out, character.code);
    text.remove_prefix(character.bytes);
    ++count;
  }
  if (!text.empty()) out += "…";
  return out;
}

void append_header(std::string& out, const RunRecord& record, const SvgPlotTitle& title, bool truncated) {
  const RunSummary& summary = record.summary;
  out += fmt::format("<text class=\"title\" x=\"{}\" y=\"34\">{}</text>\n", kLeft,
                     xml_text(shortened(title.title, 70)));
  std::string totals =
      fmt::format("{} · cutting {} mm in {} · rapid {} mm in {} · {} blocks", clock_text(summary.time_s),
                  fixed_text(summary.cutting_mm, 1), clock_text(summary.cutting_s),
                  fixed_text(summary.rapid_mm, 1), clock_text(summary.rapid_s), grouped_text(summary.blocks));
  if (!summary.alarms.empty()) totals += fmt::format(" · alarms and warnings: {}", summary.alarms.size());
  if (truncated) totals += " · only the first part is drawn";
  out += fmt::format("<text class=\"totals\" x=\"{}\" y=\"57\">{}</text>\n", kLeft, xml_text(totals));
}

/// The ranges of the cutting moves, or of all when nothing is cut, for the axes that move. Returns the height
/// used.
double append_ranges(std::string& out, const RunExtents& extents, const Machine& machine, double top) {
  if (extents.empty) return 0.0;
  const bool cuts = !extents.cutting[index(Axis::X)].empty();
  constexpr double kColumn = 300.0;
  constexpr double kRow = 19.0;
  constexpr int kColumns = 3;
  out +=
      fmt::format("<text class=\"note\" x=\"{}\" y=\"{}\">{}</text>\n", kLeft, rounded_text(top, 2),
                  cuts ? "Cutting moves reach (machine coordinates):" : "Moves reach (machine coordinates):");
  const auto rows_of = [](int cells) { return (cells + kColumns - 1) / kColumns; };
  int cell = 0;
  for (const Axis axis : machine.axes) {
    if (extents.all[index(axis)].length() == 0.0) continue;
    const Extent& extent = cuts ? extents.cutting[index(axis)] : extents.all[index(axis)];
    const std::string_view unit = machine[axis].type == AxisType::rotary ? "°" : "mm";
    out += fmt::format("<text class=\"note\" x=\"{}\" y=\"{}\">{}  {} … {}  ({} {})</text>\n",
                       kLeft + kColumn * (cell % kColumns), rounded_text(top + kRow * rows_of(cell + 1), 2),
                       letter(axis), fixed_text(extent.low, 3), fixed_text(extent.high, 3),
                       fixed_text(extent.length(), 3), unit);
    ++cell;
  }
  return kRow * (1 + rows_of(cell));
}

void append_view(std::string& out, const ViewFrame& frame, const RunRecord& record,
                 const ViewStrokes& strokes, const RunExtents& extents, const std::vector<Hole>& holes) {
  append_frame(out, frame);
  append_bounds(out, frame, extents);
  append_strokes(out, frame, strokes);
  if (frame.view.vertical == Axis::Y) append_holes(out, frame, holes);
  if (frame.has_scale_bar) append_scale_bar(out, frame);
  if (const auto ends = ends_of(record)) append_start_and_end(out, frame, ends->start, ends->end);
}

}  // namespace

std::string svg_plot(const RunRecord& record, const Machine& machine, const SvgPlotTitle& title,
                     const DrawingExtras& extras) {
  const RunExtents extents = extents_of(record.actions, extras);
  const std::vector<Hole> holes = find_holes(record.actions);
  const Legend legend = legend_of(record.actions, extras, holes.size());
  const double top = kLegendTop + legend_height(legend) + kBelowLegend;
  const std::vector<ViewFrame> frames = frames_of(extents, machine, top);
  const double below = frames.back().top + frames.back().height + kGap;

  std::string body;
  append_header(body, record, title,
                record.truncated || (extras.programmed != nullptr && extras.programmed->truncated()));
  append_legend(body, legend, {kLeft, kLegendTop});
  for (const ViewFrame& frame : frames) {
    append_view(body, frame, record, strokes_of(record.actions, extras, frame, kMostBytes), extents, holes);
  }
  if (extents.empty) {
    const ViewFrame& plan = frames.front();
    body +=
        fmt::format("<text class=\"totals\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">nothing moves</text>\n",
                    kLeft + kFrameWidth / 2.0, rounded_text(plan.top + plan.height / 2.0, 2));
  }
  double height = below + append_ranges(body, extents, machine, below);
  body += fmt::format("<text class=\"note\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n",
                      kLeft + kFrameWidth, rounded_text(height + 8.0, 2), xml_text(title.maker));
  height += 24.0;

  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
             "role=\"img\" aria-labelledby=\"plot-title\">\n<title id=\"plot-title\">{2}</title>\n",
             kWidth, rounded_text(height, 2), xml_text(title.title)) +
         std::string(kStyle) +
         fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"#fff\"/>\n", kWidth, rounded_text(height, 2)) +
         body + "</svg>\n";
}

}  // namespace kerf
