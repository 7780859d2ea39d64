#include "motion/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {
namespace {

SpeedProfile single_ramp(double length, double entry, double exit) {
  SpeedProfile p;
  p.length = length;
  p.entry = entry;
  p.exit = exit;
  p.top = exit;
  p.way1 = length;
  p.ramp1 = (exit - entry) * (exit + entry) / (2.0 * length);
  p.time1 = 2.0 * length / (entry + exit);
  p.time2 = p.time1;
  p.time3 = p.time1;
  return p;
}

SpeedProfile two_ramps(double length, double cap, double acceleration) {
  SpeedProfile p;
  p.length = length;
  p.top = std::min(cap, std::sqrt(acceleration * length));
  p.way1 = 0.5 * length;
  p.ramp1 = p.top * p.top / length;
  p.ramp3 = p.ramp1;
  p.time1 = length / p.top;
  p.time2 = p.time1;
  p.down = p.time1;
  p.time3 = p.time1 + p.down;
  return p;
}

/// A stop before the end, for want of a feed.
SpeedProfile standstill(double length, double entry, double acceleration) {
  SpeedProfile p;
  p.length = length;
  p.entry = entry;
  p.ramp1 = -acceleration;
  p.time1 = entry / acceleration;
  p.way1 = 0.5 * entry * p.time1;
  p.time2 = std::numeric_limits<double>::infinity();
  p.time3 = p.time2;
  return p;
}

}  // namespace

SpeedProfile make_profile(double length, double entry, double exit, double cap, double acceleration) {
  if (!(length > 0.0)) {
    SpeedProfile nothing;
    nothing.entry = nothing.top = nothing.exit = exit;
    return nothing;
  }
  const double gain = 2.0 * acceleration * length;
  const double entry2 = entry * entry;
  const double exit2 = exit * exit;
  // No room for anything but one ramp, with a margin for rounding.
  if (std::abs(exit2 - entry2) >= gain * (1.0 - 1e-12)) return single_ramp(length, entry, exit);
  if (!(cap > 0.0)) return standstill(length, entry, acceleration);

  SpeedProfile p;
  p.length = length;
  p.entry = entry;
  p.exit = exit;
  if (entry > cap) {
    p.top = std::max(cap, exit);
    p.ramp1 = -acceleration;
  } else {
    p.top = std::min(cap, std::sqrt(0.5 * (gain + entry2 + exit2)));
    p.top = std::max({p.top, entry, exit});
    p.ramp1 = acceleration;
  }
  p.ramp3 = acceleration;
  const double inverse = 1.0 / acceleration;
  p.time1 = std::abs(p.top - entry) * inverse;
  p.way1 = 0.5 * (entry + p.top) * p.time1;
  p.down = (p.top - exit) * inverse;
  const double way_flat = length - p.way1 - 0.5 * (p.top + exit) * p.down;
  p.time2 = p.time1 + std::max(0.0, way_flat / p.top);
  p.time3 = p.time2 + p.down;
  if (ends_as_planned(p)) return p;
  return entry + exit > 0.0 ? single_ramp(length, entry, exit) : two_ramps(length, cap, acceleration);
}

bool ends_as_planned(const SpeedProfile& p) {
  const double time_flat = p.time2 - p.time1;
  if (!(p.time1 >= 0.0 && time_flat >= 0.0 && p.down >= 0.0)) return false;
  const double speed1 = p.entry + p.ramp1 * p.time1;
  const double way1 = 0.5 * (p.entry + speed1) * p.time1;
  const double speed3 = speed1 - p.ramp3 * p.down;
  const double way = way1 + speed1 * time_flat + 0.5 * (speed1 + speed3) * p.down;
  const double speed_tolerance = 1e-9 * (p.top + p.entry);
  const double way_tolerance = 1e-9 * p.length + 1e-12;
  return std::abs(speed3 - p.exit) <= speed_tolerance && std::abs(way - p.length) <= way_tolerance;
}

}  // namespace kerf
