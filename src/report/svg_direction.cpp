#include "report/svg_direction.hpp"

#include <algorithm>
#include <cmath>

#include "report/move_geometry.hpp"

namespace kerf {
namespace {

constexpr double kFinest = 0.5;  ///< ticks that differ by less are one

/// The way of a move on the picture.
double length_of(const Move& move, const ViewFrame& frame) {
  const int parts = chord_count(move);
  double length = 0.0;
  Point2 from = frame.place(project(move.start, frame.view));
  for (int part = 1; part <= parts; ++part) {
    const AxisVector position = position_at(move, static_cast<double>(part) / parts);
    const Point2 to = frame.place(project(position, frame.view));
    length += std::hypot(to.x - from.x, to.y - from.y);
    from = to;
  }
  return length;
}

}  // namespace

DirectionTicks::DirectionTicks(const ViewFrame& frame, double tolerance)
    : frame_(frame), path_(std::max(tolerance, kFinest)) {}

void DirectionTicks::add(const Move& move, Axis axis) {
  if (move.normal_line == Side::none) {
    since_ = kSpacing;
    return;
  }
  if (!looks_at(frame_.view, move.plane)) return;
  constexpr double kNoWay = 1e-3;
  const double length = length_of(move, frame_);
  if (length < kNoWay) return add_turn(move, axis);
  if (length < kSpacing) {  // one of many short moves, or a short one between corners
    since_ += length;
    if (since_ < kSpacing) return;
    tick(move, axis, 0.5);
    since_ = length / 2.0;
    return;
  }
  // Even parts of the move with a tick in the middle of each: corners and smooth joints keep their distance.
  constexpr double kMost = 10'000.0;
  const double parts = std::min(std::round(length / kSpacing), kMost);
  for (int part = 0; part < static_cast<int>(parts); ++part) tick(move, axis, (part + 0.5) / parts);
  since_ = length / parts / 2.0;
}

void DirectionTicks::add_turn(const Move& move, Axis axis) {
  constexpr double kSmallTurn_deg = 15.0;
  const double turn = std::abs(move.end[axis] - move.start[axis]);
  if (turn < 1e-6 || (turn < kSmallTurn_deg && since_ < kSpacing / 2.0)) return;
  tick(move, axis, 0.0);
  tick(move, axis, 1.0);
  since_ = 0.0;
}

void DirectionTicks::tick(const Move& move, Axis axis, double fraction) {
  const Point2 at = frame_.place(project(position_at(move, fraction), frame_.view));
  const Point2 direction = tool_direction(move, axis, fraction, frame_.view);
  // A stretched picture turns the direction.
  const double x = direction.x * frame_.x_scale;
  const double y = -direction.y * frame_.y_scale;
  const double length = kLength / std::hypot(x, y);
  path_.line(at, {at.x + x * length, at.y + y * length});
}

}  // namespace kerf
