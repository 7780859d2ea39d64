#include "report/polar_picture.hpp"

#include "execute/polar_plane.hpp"

namespace kerf {

std::optional<Axis> figure_axis(const Move& move) {
  if (move.polar.form == PolarForm::none) return std::nullopt;
  constexpr AxisSet kSpace{Axis::X, Axis::Y, Axis::Z};
  AxisSet rest = kSpace;
  for (const Axis axis : {move.polar.linear, move.plane.third}) {
    if (!rest.contains(axis)) return std::nullopt;
    rest.erase(axis);
  }
  return *rest.begin();
}

Move as_figure(const Move& move) {
  const std::optional<Axis> across = figure_axis(move);
  if (!across) return move;
  const Axis rotary = move.polar.rotary;
  Move figure = in_polar_plane(move);
  const double beside = move.start[*across];
  figure.start[*across] = beside + figure.start[rotary];
  figure.end[*across] = beside + figure.end[rotary];
  figure.start[rotary] = move.start[rotary];
  figure.end[rotary] = move.end[rotary];
  figure.plane = {move.polar.linear, *across, move.plane.third};
  if (is_arc(move.mode)) figure.arc.center[1] += beside;
  figure.polar = {};
  return figure;
}

}  // namespace kerf
