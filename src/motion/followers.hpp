#pragma once
// Axes that go with another one, at every instant (AxisSettings::master).

#include "base/fixed_vector.hpp"
#include "machine/machine.hpp"
#include "motion/cycle.hpp"

namespace kerf {

class Followers {
 public:
  explicit Followers(const Machine& machine) {
    for (const Axis axis : machine.followers()) {
      const Axis master = *machine[axis].master;
      pairs_.push_back({axis, master, machine[axis].start - machine[master].start});
    }
  }

  /// Places the followers where their masters are.
  void follow(PathPoint& point) const {
    for (const Pair& pair : pairs_) {
      point.position[pair.axis] = point.position[pair.master] + pair.distance;
      point.velocity[pair.axis] = point.velocity[pair.master];
      point.acceleration[pair.axis] = point.acceleration[pair.master];
    }
  }

  /// The extremes of all axes out of those of the masters.
  MotionExtremes completed(MotionExtremes extremes) const {
    for (const Pair& pair : pairs_) {
      for (AxisVector* peak :
           {&extremes.velocity, &extremes.acceleration, &extremes.corner_step, &extremes.jerk})
        (*peak)[pair.axis] = (*peak)[pair.master];
      extremes.low[pair.axis] = extremes.low[pair.master] + pair.distance;
      extremes.high[pair.axis] = extremes.high[pair.master] + pair.distance;
    }
    return extremes;
  }

 private:
  struct Pair {
    Axis axis = Axis::U;
    Axis master = Axis::X;
    double distance = 0.0;  ///< machine coordinate of the follower less that of the master
  };
  FixedVector<Pair, kAxisCount> pairs_;
};

}  // namespace kerf
