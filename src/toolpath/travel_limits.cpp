#include "toolpath/travel_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/circular_arc.hpp"

namespace kerf {
namespace {

// The smallest and largest coordinates of the axes on an arc move.
struct Extent {
  AxisVector low;
  AxisVector high;
};

Extent arc_extent(const Move& move) {
  Extent extent{move.start, move.start};
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    extent.low.values[i] = std::min(move.start.values[i], move.end.values[i]);
    extent.high.values[i] = std::max(move.start.values[i], move.end.values[i]);
  }
  const Vec2 center{move.arc.center[0], move.arc.center[1]};
  CircularArc arc = arc_through(in_plane(move.start, move.plane), center, move.arc.sweep);
  arc.radius = move.arc.radius;
  const PlanarBox box = bounds_of(arc);
  extent.low = with_point(extent.low, move.plane, box.low);
  extent.high = with_point(extent.high, move.plane, box.high);
  return extent;
}

}  // namespace

TravelLimitPass::TravelLimitPass(const Machine& machine, const TravelLimitPolicy& policy) : policy_(policy) {
  lower_.fill(-std::numeric_limits<double>::infinity());
  upper_.fill(std::numeric_limits<double>::infinity());
  for (const Axis axis : machine.axes) {
    lower_[index(axis)] = machine[axis].lower_limit;
    upper_[index(axis)] = machine[axis].upper_limit;
    type_[index(axis)] = machine[axis].type;
  }
}

void TravelLimitPass::reset() {
  out_.clear();
  displaced_ = false;
}

bool TravelLimitPass::is_arc_inside(const Move& move) const {
  const Extent extent = arc_extent(move);
  return is_inside(extent.low) && is_inside(extent.high);
}

void TravelLimitPass::push(const Origin& origin, const Move& move) {
  if (!displaced_) out_.set_position(move.start);
  if (is_inside(move)) {
    out_.add_rejoined(origin, move);
    displaced_ = false;
    return;
  }
  displaced_ = true;
  if (policy_.clip && !is_arc(move.mode)) return push_clipped(origin, move);
  out_.add({origin, Alarm{policy_.over_travel, origin.span, message_for(excess_of(move)), {}}});
}

void TravelLimitPass::push_clipped(const Origin& origin, Move move) {
  const AxisVector& start = out_.position();
  const AxisVector way = move.end - start;
  double part = 1.0;  // of the way that lies inside
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const double end = move.end.values[i];
    const double border = std::clamp(end, lower_[i], upper_[i]);
    if (std::abs(end - border) <= kRounding) continue;
    const bool leaves = end > border ? start.values[i] < border : start.values[i] > border;
    part = leaves ? std::min(part, (border - start.values[i]) / way.values[i]) : 0.0;
  }
  if (part <= 0.0) return;
  for (std::size_t i = 0; i < kAxisCount; ++i)
    move.end.values[i] = std::clamp(start.values[i] + part * way.values[i], lower_[i], upper_[i]);
  out_.add_move(origin, move);
}

TravelLimitPass::Excess TravelLimitPass::excess_of(const Move& move) const {
  const Extent extent = is_arc(move.mode) ? arc_extent(move) : Extent{move.end, move.end};
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const Axis axis = static_cast<Axis>(i);
    if (extent.high[axis] > upper_[i] + kRounding) return {axis, extent.high[axis]};
    if (extent.low[axis] < lower_[i] - kRounding) return {axis, extent.low[axis]};
  }
  return {};
}

FixedText<200> TravelLimitPass::message_for(const Excess& excess) const {
  const std::size_t i = index(excess.axis);
  const char* unit = type_[i] == AxisType::rotary ? "deg" : "mm";
  return FixedText<200>::format("{} would reach {:.3f} {}; travel is {:.3f} to {:.3f} {}",
                                letter(excess.axis), excess.reached, unit, lower_[i], upper_[i], unit);
}

}  // namespace kerf
