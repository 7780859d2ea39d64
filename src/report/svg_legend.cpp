#include "report/svg_legend.hpp"

#include <fmt/format.h>
#include <string_view>

#include "report/svg_direction.hpp"

namespace kerf {
namespace {

constexpr double kRow = 25.0;

bool is_shown(const Plane& plane) {
  return looks_at(kPlanView, plane) || looks_at(kElevationView, plane) || looks_at(kSideView, plane);
}

bool shows_programmed(const DrawingExtras& extras) {
  if (extras.programmed == nullptr) return false;
  for (std::size_t i = 0; i < extras.programmed->size(); ++i) {
    if (is_shown((*extras.programmed)[i].plane)) return true;
  }
  return false;
}

/// The rows about compensation and control of the tool are rare: they stand below the others.
bool has_second_row(const Legend& legend) {
  return legend.programmed || legend.swept || legend.direction;
}

/// Sets samples with their labels one after the other in a row.
class LegendRow {
 public:
  LegendRow(std::string& out, Point2 at) : out_(out), x_(at.x), y_(at.y) {}

  void stroke(std::string_view style, std::string_view label) {
    out_ += fmt::format("<path class=\"{}\" d=\"M{} {}h32\"/>\n", style, x_, y_);
    text(label, 39.0);
  }
  void swept(std::string_view label) {
    out_ += fmt::format("<path class=\"swept\" stroke-width=\"12\" d=\"M{} {}h20\"/>\n", x_ + 6.0, y_);
    text(label, 39.0);
  }
  void direction(std::string_view label) {
    const double foot = y_ + DirectionTicks::kLength / 2.0;
    out_ += fmt::format("<path class=\"line\" d=\"M{} {}h32\"/>\n", x_, foot);
    out_ += fmt::format("<path class=\"direction\" d=\"M{0} {1}v-{3}M{2} {1}v-{3}\"/>\n", x_ + 8.0, foot,
                        x_ + 24.0, DirectionTicks::kLength);
    text(label, 39.0);
  }
  void hole(std::string_view label) {
    const double cx = x_ + 8.0;
    out_ += fmt::format(
        "<path class=\"hole\" d=\"M{} {}a4.5 4.5 0 0 1 9 0 4.5 4.5 0 0 1-9 0M{} {}h15M{} {}v15\"/>\n",
        cx - 4.5, y_, cx - 7.5, y_, cx, y_ - 7.5);
    text(label, 22.0);
  }
  void start_and_end() {
    out_ += fmt::format("<circle class=\"start\" cx=\"{}\" cy=\"{}\" r=\"8\"/>\n", x_ + 9.0, y_);
    text("start", 23.0);
    out_ += fmt::format("<rect class=\"end\" x=\"{}\" y=\"{}\" width=\"8\" height=\"8\"/>\n", x_, y_ - 4.0);
    text("end", 14.0);
  }

 private:
  void text(std::string_view label, double offset) {
    out_ += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", x_ + offset, y_ + 4.5, label);
    x_ += offset + 7.7 * static_cast<double>(label.size()) + 18.0;
  }

  std::string& out_;
  double x_;
  double y_;
};

}  // namespace

Legend legend_of(const std::vector<TimedAction>& actions, const DrawingExtras& extras, std::size_t holes) {
  Legend legend;
  legend.holes = holes;
  legend.programmed = shows_programmed(extras);
  Move figure;
  for (const TimedAction& timed : actions) {
    const Move* const move = drawn_move(timed, figure);
    if (move == nullptr) continue;
    const bool rapid = move->mode == MoveMode::rapid;
    legend.arc = legend.arc || is_arc(move->mode);
    legend.rapid = legend.rapid || rapid;
    legend.line = legend.line || (!rapid && !is_arc(move->mode));
    if (!is_shown(move->plane)) continue;
    legend.swept = legend.swept || swept_radius(*move) > 0.0;
    legend.direction = legend.direction || (extras.normal_axis && move->normal_line != Side::none);
  }
  return legend;
}

double legend_height(const Legend& legend) {
  return has_second_row(legend) ? kRow : 0.0;
}

void append_legend(std::string& out, const Legend& legend, Point2 at) {
  if (!legend.rapid && !legend.line && !legend.arc) return;
  out += "<g class=\"legend\">\n";
  LegendRow row(out, at);
  if (legend.rapid) row.stroke("rapid", "rapid");
  if (legend.line) row.stroke("line", "line");
  if (legend.arc) row.stroke("arc", "arc");
  if (legend.holes > 0) row.hole(fmt::format("drilled hole ({})", legend.holes));
  if (legend.line || legend.arc) row.stroke("bounds", "cutting bounds");
  row.start_and_end();
  LegendRow second(out, {at.x, at.y + kRow});
  if (legend.programmed) second.stroke("programmed", "programmed path");
  if (legend.swept) second.swept("swept by the tool");
  if (legend.direction) second.direction("where the tool points");
  out += "</g>\n";
}

}  // namespace kerf
