#pragma once
// Speed over time along one segment, with constant acceleration in every phase.

namespace kerf {

/// Way, speed and acceleration at a time.
struct ProfilePoint {
  double s = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
};

/// A ramp from the entry speed to the top speed, top speed, a ramp down to the exit speed. Where the entry
/// speed is above the top speed (the override was lowered) the first ramp goes down. Times in seconds from
/// the start.
struct SpeedProfile {
  double entry = 0.0;   ///< mm/s
  double top = 0.0;     ///< mm/s
  double exit = 0.0;    ///< mm/s
  double ramp1 = 0.0;   ///< acceleration of the first phase, mm/s2, signed
  double ramp3 = 0.0;   ///< deceleration of the last phase, mm/s2, >= 0
  double time1 = 0.0;   ///< end of the first phase
  double time2 = 0.0;   ///< end of the second phase
  double time3 = 0.0;   ///< end; infinite when the top speed is 0 and way remains
  double down = 0.0;    ///< duration of the last phase: time3 - time2 before rounding
  double way1 = 0.0;    ///< way of the first phase, mm
  double length = 0.0;  ///< mm

  ProfilePoint at(double time) const {
    if (time < time1) return {(entry + 0.5 * ramp1 * time) * time, entry + ramp1 * time, ramp1};
    if (time < time2) return {way1 + top * (time - time1), top, 0.0};
    double rest = time3 - time;
    if (!(rest > 0.0)) return {length, exit, 0.0};
    if (rest > down) rest = down;  // in long profiles the times are coarser than a short ramp
    return {length - (exit + 0.5 * ramp3 * rest) * rest, exit + ramp3 * rest, -ramp3};
  }

  /// Highest speed up to a time.
  double peak_until(double time) const {
    const double now = at(time).speed;
    const double start = entry > now ? entry : now;
    return time > time1 && top > start ? top : start;
  }
};

/// The quickest profile over `length` from speed `entry` to speed `exit` with accelerations up to
/// `acceleration` (> 0) that stays below `cap` as soon as it can. The caller sees to it that the exit can be
/// reached: |exit2 - entry2| <= 2 acceleration length, and exit <= cap unless that forbids it. With cap 0 the
/// profile ends in a standstill before the end, and time3 is infinite. No length takes no time.
///
/// The closed form is accepted only when an integration over its phases ends at `length` with speed `exit`,
/// to rounding. Otherwise the answer is slower and simpler: one ramp from entry to exit, or from rest to rest
/// two ramps that meet in the middle.
SpeedProfile make_profile(double length, double entry, double exit, double cap, double acceleration);

/// Whether the phases of a profile, integrated one after the other, end at its length with its exit speed, to
/// 1e-9 of the quantities involved, and no time is negative.
bool ends_as_planned(const SpeedProfile& profile);

}  // namespace kerf
