#include "toolpath/travel_limits.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {

TravelLimitPass::TravelLimitPass(const Machine& machine, const TravelLimitPolicy& policy)
    : policy_(policy), travel_(machine) {}

void TravelLimitPass::reset() {
  out_.clear();
  displaced_ = false;
}

void TravelLimitPass::push(const Origin& origin, const Move& move) {
  if (!displaced_) out_.set_position(move.start);
  if (travel_.contains(move)) {
    out_.add_rejoined(origin, move);
    displaced_ = false;
    return;
  }
  displaced_ = true;
  if (policy_.clip && !is_arc(move.mode)) return push_clipped(origin, move);
  // A check went on behind an alarm with the tool outside: said once is enough.
  if (!travel_.contains(move.start)) return;
  const Excess excess = travel_.excess_of(move).value_or(Excess{});
  out_.add({origin, Alarm{policy_.over_travel, origin.span, travel_.message_for(excess), {}}});
}

void TravelLimitPass::push_clipped(const Origin& origin, Move move) {
  const AxisVector& start = out_.position();
  const AxisVector way = move.end - start;
  double part = 1.0;  // of the way that lies inside
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const double end = move.end.values[i];
    const double border = std::clamp(end, travel_.lower(i), travel_.upper(i));
    if (std::abs(end - border) <= Travel::kRounding) continue;
    const bool leaves = end > border ? start.values[i] < border : start.values[i] > border;
    part = leaves ? std::min(part, (border - start.values[i]) / way.values[i]) : 0.0;
  }
  if (part <= 0.0) return;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    move.end.values[i] =
        std::clamp(start.values[i] + part * way.values[i], travel_.lower(i), travel_.upper(i));
  }
  out_.add_move(origin, move);
}

}  // namespace kerf
