#include "report/svg_view.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <utility>

#include "report/drawing_scale.hpp"
#include "report/number_text.hpp"
#include "report/svg_path.hpp"
#include "report/text_escape.hpp"

namespace kerf {
namespace {

std::string hundredths(double value) {
  return rounded_text(value, 2);
}

void append_line(std::string& out, double x1, double y1, double x2, double y2) {
  out += fmt::format("M{} {}L{} {}", hundredths(x1), hundredths(y1), hundredths(x2), hundredths(y2));
}

void append_text(std::string& out, double x, double y, std::string_view anchor, std::string_view text) {
  out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">", hundredths(x), hundredths(y), anchor);
  append_xml(out, text);
  out += "</text>\n";
}

/// The distance of the grid's lines in machine units, so that they stand at least `apart` picture units
/// apart.
double grid_step(double scale, double apart) {
  return round_up_125(apart / scale);
}

/// Grid steps of both axes, the same one where the scales are.
std::pair<double, double> grid_steps(const ViewFrame& frame) {
  constexpr double kApartX = 70.0;  // room for a label
  constexpr double kApartY = 36.0;
  const double x_step = grid_step(frame.x_scale, kApartX);
  if (frame.x_scale == frame.y_scale && frame.height > 2.0 * kApartX) return {x_step, x_step};
  return {x_step, grid_step(frame.y_scale, kApartY)};
}

}  // namespace

void append_frame(std::string& out, const ViewFrame& frame) {
  const auto [x_step, y_step] = grid_steps(frame);
  const double right = frame.left + frame.width;
  const double bottom = frame.top + frame.height;
  std::string grid;
  std::string labels;
  for (const double x : ticks_between(frame.x_low, frame.x_low + frame.width / frame.x_scale, x_step)) {
    const double at = frame.place({x, 0.0}).x;
    append_line(grid, at, frame.top, at, bottom);
    append_text(labels, at, bottom + 16.0, "middle", tick_text(x, x_step));
  }
  for (const double y : ticks_between(frame.y_low, frame.y_low + frame.height / frame.y_scale, y_step)) {
    const double at = frame.place({0.0, y}).y;
    append_line(grid, frame.left, at, right, at);
    append_text(labels, frame.left - 7.0, at + 4.0, "end", tick_text(y, y_step));
  }
  append_path(out, "grid", grid);
  out += fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                     hundredths(frame.left), hundredths(frame.top), hundredths(frame.width),
                     hundredths(frame.height));
  out += "<g class=\"tick\">\n" + labels + "</g>\n";
  out += "<g class=\"axis\">\n";
  append_text(out, frame.left + frame.width / 2.0, bottom + 34.0, "middle", frame.x_title);
  const std::string x = hundredths(frame.left - 52.0);
  const std::string y = hundredths(frame.top + frame.height / 2.0);
  out += fmt::format(
      "<text x=\"{0}\" y=\"{1}\" text-anchor=\"middle\" transform=\"rotate(-90 {0} {1})\">{2}</text>\n", x, y,
      xml_text(frame.y_title));
  out += "</g>\n";
}

void append_bounds(std::string& out, const ViewFrame& frame, const RunExtents& extents) {
  const Extent& x = extents.drawn_cutting[index(frame.view.horizontal)];
  const Extent& y = extents.drawn_cutting[index(frame.view.vertical)];
  if (x.empty() || y.empty()) return;
  const Point2 corner = frame.place({x.low, y.high});
  out += fmt::format("<rect class=\"bounds\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                     hundredths(corner.x), hundredths(corner.y), hundredths(x.length() * frame.x_scale),
                     hundredths(y.length() * frame.y_scale));
}

void append_scale_bar(std::string& out, const ViewFrame& frame) {
  constexpr double kLongest = 180.0;
  constexpr double kMargin = 14.0;
  const double length_mm = round_down_125(kLongest / frame.x_scale);
  const double length = length_mm * frame.x_scale;
  const double right = frame.left + frame.width - kMargin;
  const double left = right - length;
  const double y = frame.top + frame.height - kMargin;
  out += fmt::format(
      "<rect class=\"label\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"32\"/>\n"
      "<path class=\"scale\" d=\"M{} {}v7H{}v-7\"/>\n<g class=\"tick\">\n",
      hundredths(left - 8.0), hundredths(y - 24.0), hundredths(length + 16.0), hundredths(left),
      hundredths(y - 5.0), hundredths(right));
  append_text(out, (left + right) / 2.0, y - 8.0, "middle", tick_text(length_mm, length_mm) + " mm");
  out += "</g>\n";
}

void append_start_and_end(std::string& out, const ViewFrame& frame, const AxisVector& start,
                          const AxisVector& end) {
  const Point2 first = frame.place(project(start, frame.view));
  const Point2 last = frame.place(project(end, frame.view));
  out += fmt::format(
      "<rect class=\"end\" x=\"{}\" y=\"{}\" width=\"8\" height=\"8\"><title>end</title></rect>\n",
      hundredths(last.x - 4.0), hundredths(last.y - 4.0));
  out += fmt::format("<circle class=\"start\" cx=\"{}\" cy=\"{}\" r=\"8\"><title>start</title></circle>\n",
                     hundredths(first.x), hundredths(first.y));
}

void append_holes(std::string& out, const ViewFrame& frame, const std::vector<Hole>& holes) {
  // Marks a fraction of a picture unit apart are one mark: the dedupe of SvgPath keeps the data small.
  SvgPath path(0.25);
  constexpr double kRadius = 4.5;
  constexpr double kCross = 7.5;
  for (const Hole& hole : holes) {
    const Point2 at = frame.place(hole.at);
    const Point2 west{at.x - kRadius, at.y};
    const Point2 east{at.x + kRadius, at.y};
    path.arc(west, east, {kRadius, kRadius, true});
    path.arc(east, west, {kRadius, kRadius, true});
    path.line({at.x - kCross, at.y}, {at.x + kCross, at.y});
    path.line({at.x, at.y - kCross}, {at.x, at.y + kCross});
  }
  append_path(out, "hole", path.finish());
}

}  // namespace kerf
