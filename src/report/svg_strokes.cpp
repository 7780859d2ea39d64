#include "report/svg_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <map>

#include "report/number_text.hpp"
#include "report/svg_direction.hpp"
#include "report/svg_path.hpp"

namespace kerf {
namespace {

constexpr double kDegreesPerStroke = 120.0;  ///< an arc stroke must stay below half a turn

/// The circle itself and the rest, for an arc of several turns: more would be drawn on top of each other.
double visible_sweep(double sweep) {
  constexpr double kTurn = 360.0;
  if (std::abs(sweep) <= 2.0 * kTurn) return sweep;
  return std::copysign(kTurn + std::fmod(std::abs(sweep), kTurn), sweep);
}

void draw_round(const Move& move, const ViewFrame& frame, SvgPath& path) {
  Move drawn = move;
  drawn.arc.sweep = visible_sweep(move.arc.sweep);
  const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(drawn.arc.sweep) / kDegreesPerStroke)));
  const double start_radius = std::hypot(move.start[move.plane.first] - move.arc.center[0],
                                         move.start[move.plane.second] - move.arc.center[1]);
  const ArcStroke stroke{start_radius * frame.x_scale, start_radius * frame.y_scale,
                         turns_clockwise(move, frame.view)};
  Point2 from = frame.place(project(drawn.start, frame.view));
  for (int part = 1; part <= parts; ++part) {
    const AxisVector position = position_at(drawn, static_cast<double>(part) / parts);
    const Point2 to = frame.place(project(position, frame.view));
    path.arc(from, to, stroke);
    from = to;
  }
}

void draw_chords(const Move& move, const ViewFrame& frame, SvgPath& path) {
  const int parts = chord_count(move);
  Point2 from = frame.place(project(move.start, frame.view));
  for (int part = 1; part <= parts; ++part) {
    const AxisVector position = position_at(move, static_cast<double>(part) / parts);
    const Point2 to = frame.place(project(position, frame.view));
    path.line(from, to);
    from = to;
  }
}

/// A move as it appears in the view.
void draw(const Move& move, const ViewFrame& frame, SvgPath& path) {
  if (appears_round(move, frame.view)) {
    draw_round(move, frame, path);
  } else {
    draw_chords(move, frame, path);
  }
}

/// The frame with the scale of its horizontal axis in both directions and the same lower edge: in it a stroke
/// is as wide everywhere as the tool.
ViewFrame true_to_scale(const ViewFrame& frame) {
  ViewFrame even = frame;
  even.y_scale = frame.x_scale;
  return even;
}

/// Collects bands by their width: strokes of one path do not darken each other.
class SweptBands {
 public:
  SweptBands(const ViewFrame& frame, double tolerance)
      : frame_(true_to_scale(frame)), tolerance_(tolerance) {}

  void add(const Move& move) {
    const double width = 2.0 * swept_radius(move) * frame_.x_scale;
    if (!(width > 0.0) || !looks_at(frame_.view, move.plane)) return;
    // A hundredth of the width off the middle of a wide band is not seen.
    const double tolerance = std::max(tolerance_, 0.005 * width);
    draw(move, frame_, paths_.try_emplace(std::llround(width * kUnit), tolerance).first->second);
  }
  std::vector<SweptBand> finish() {
    std::vector<SweptBand> bands;
    for (auto& [width, path] : paths_) bands.push_back({static_cast<double>(width) / kUnit, path.finish()});
    return bands;
  }

 private:
  static constexpr double kUnit = 100.0;
  ViewFrame frame_;
  double tolerance_;
  std::map<std::int64_t, SvgPath> paths_;  ///< by hundredths of a picture unit
};

std::string programmed_at(const ProgrammedPath& programmed, const ViewFrame& frame, double tolerance) {
  SvgPath path(tolerance);
  for (std::size_t i = 0; i < programmed.size(); ++i) {
    const Move move = programmed[i];
    if (looks_at(frame.view, move.plane)) draw(move, frame, path);
  }
  return path.finish();
}

ViewStrokes strokes_at(const std::vector<TimedAction>& actions, const DrawingExtras& extras,
                       const ViewFrame& frame, double tolerance) {
  SvgPath rapid(tolerance);
  SvgPath line(tolerance);
  SvgPath arc(tolerance);
  SweptBands swept(frame, tolerance);
  DirectionTicks direction(frame, tolerance);
  Move figure;
  for (const TimedAction& timed : actions) {
    const Move* const move = drawn_move(timed, figure);
    if (move == nullptr) continue;
    draw(*move, frame, is_arc(move->mode) ? arc : move->mode == MoveMode::rapid ? rapid : line);
    swept.add(*move);
    if (extras.normal_axis) direction.add(*move, *extras.normal_axis);
  }
  ViewStrokes strokes{rapid.finish(), line.finish(), arc.finish(), {}, direction.finish(), swept.finish()};
  if (extras.programmed != nullptr) strokes.programmed = programmed_at(*extras.programmed, frame, tolerance);
  return strokes;
}

/// The bands below everything else. As a group they are one even surface, wherever they overlap; it is laid
/// out true to scale, and stretched as the view is.
void append_swept(std::string& out, const ViewFrame& frame, const std::vector<SweptBand>& bands) {
  if (bands.empty()) return;
  out += "<g class=\"swept\"";
  if (frame.y_scale != frame.x_scale) {
    const double stretch = frame.y_scale / frame.x_scale;
    out += fmt::format(" transform=\"matrix(1 0 0 {} 0 {})\"", rounded_text(stretch, 6),
                       rounded_text((frame.top + frame.height) * (1.0 - stretch), 4));
  }
  out += ">\n";
  for (const SweptBand& band : bands) {
    out += fmt::format("<path stroke-width=\"{}\" d=\"{}\"/>\n", rounded_text(band.width, 2), band.data);
  }
  out += "</g>\n";
}

}  // namespace

std::size_t ViewStrokes::size() const {
  std::size_t bytes = rapid.size() + line.size() + arc.size() + programmed.size() + direction.size();
  for (const SweptBand& band : swept) bytes += band.data.size();
  return bytes;
}

ViewStrokes strokes_of(const std::vector<TimedAction>& actions, const DrawingExtras& extras,
                       const ViewFrame& frame, std::size_t most_bytes) {
  constexpr double kFinest = 0.04;
  constexpr double kCoarsest = 2.6;
  ViewStrokes strokes = strokes_at(actions, extras, frame, kFinest);
  for (double tolerance = 2.0 * kFinest; strokes.size() > most_bytes && tolerance < kCoarsest;
       tolerance *= 2.0) {
    strokes = strokes_at(actions, extras, frame, tolerance);
  }
  return strokes;
}

void append_strokes(std::string& out, const ViewFrame& frame, const ViewStrokes& strokes) {
  const std::string id = fmt::format("clip-{}{}", letter(frame.view.horizontal), letter(frame.view.vertical));
  out += fmt::format(
      "<clipPath id=\"{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n"
      "<g clip-path=\"url(#{})\">\n",
      id, rounded_text(frame.left, 2), rounded_text(frame.top, 2), rounded_text(frame.width, 2),
      rounded_text(frame.height, 2), id);
  append_swept(out, frame, strokes.swept);
  append_path(out, "programmed", strokes.programmed);
  append_path(out, "rapid", strokes.rapid);
  append_path(out, "line", strokes.line);
  append_path(out, "arc", strokes.arc);
  append_path(out, "direction", strokes.direction);
  out += "</g>\n";
}

}  // namespace kerf
