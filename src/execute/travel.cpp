#include "execute/travel.hpp"

#include <algorithm>
#include <limits>

#include "execute/polar_plane.hpp"
#include "geometry/circular_arc.hpp"
#include "geometry/polar.hpp"

namespace kerf {
namespace {

/// The smallest and largest coordinates of the axes on a move, its start left out unless it is an arc.
struct Extent {
  AxisVector low;
  AxisVector high;
};

Extent polar_extent(const Move& move) {
  Extent extent{move.end, move.end};
  const PolarReach reach = polar_reach(move);
  extent.low[move.polar.linear] = reach.linear_low;
  extent.high[move.polar.linear] = reach.linear_high;
  extent.low[move.polar.rotary] = reach.rotary_low;
  extent.high[move.polar.rotary] = reach.rotary_high;
  return extent;
}

Extent extent_of(const Move& move) {
  if (move.polar.form == PolarForm::axes) return polar_extent(move);
  Extent extent{move.end, move.end};
  if (!is_arc(move.mode)) return extent;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    extent.low.values[i] = std::min(move.start.values[i], move.end.values[i]);
    extent.high.values[i] = std::max(move.start.values[i], move.end.values[i]);
  }
  const Vec2 center{move.arc.center[0], move.arc.center[1]};
  const CircularArc arc =
      arc_through({move.start[move.plane.first], move.start[move.plane.second]}, center, move.arc.sweep);
  const PlanarBox box =
      bounds_of(arc, distance(center, {move.end[move.plane.first], move.end[move.plane.second]}));
  // The box and the ends: within the arc tolerance the programmed end lies a little beside the arc.
  const auto take_in = [&extent](Axis axis, double low, double high) {
    extent.low[axis] = std::min(extent.low[axis], low);
    extent.high[axis] = std::max(extent.high[axis], high);
  };
  take_in(move.plane.first, box.low.x, box.high.x);
  take_in(move.plane.second, box.low.y, box.high.y);
  return extent;
}

}  // namespace

Travel::Travel(const Machine& machine) {
  lower_.fill(-std::numeric_limits<double>::infinity());
  upper_.fill(std::numeric_limits<double>::infinity());
  for (const Axis axis : machine.axes) {
    axes_ = index(axis) + 1;
    type_[index(axis)] = machine[axis].type;
    lower_[index(axis)] = machine[axis].lower_limit;
    upper_[index(axis)] = machine[axis].upper_limit;
  }
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    lowest_[i] = lower_[i] - kRounding;
    highest_[i] = upper_[i] + kRounding;
  }
}

bool Travel::contains_between(const Move& move) const {
  const Extent extent = extent_of(move);
  return contains(extent.low) && contains(extent.high);
}

std::optional<Excess> Travel::excess_of(const Move& move) const {
  const Extent extent = extent_of(move);
  const auto above = excess_of(extent.high);
  return above ? above : excess_of(extent.low);
}

std::optional<Excess> Travel::excess_of(const AxisVector& position) const {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const double reached = position.values[i];
    if (reached > highest_[i] || reached < lowest_[i]) {
      return Excess{static_cast<Axis>(i), reached};
    }
  }
  return std::nullopt;
}

std::optional<Excess> Travel::leaving(const Move& move) const {
  const Extent extent = extent_of(move);
  for (std::size_t i = 0; i < axes_; ++i) {
    const auto axis = static_cast<Axis>(i);
    if (!contains(axis, move.start.values[i])) continue;
    if (extent.high.values[i] > highest_[i]) return Excess{axis, extent.high.values[i]};
    if (extent.low.values[i] < lowest_[i]) return Excess{axis, extent.low.values[i]};
  }
  return std::nullopt;
}

FixedText<200> Travel::message_for(const Excess& excess) const {
  const std::size_t i = index(excess.axis);
  const char* unit = type_[i] == AxisType::rotary ? "deg" : "mm";
  return FixedText<200>::format("{} would reach {:.4f} {}; travel is {} to {} {}", letter(excess.axis),
                                excess.reached, unit, lower_[i], upper_[i], unit);
}

}  // namespace kerf
