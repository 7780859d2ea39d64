#pragma once
// Simulated inputs that end a move when a signal comes: probes, light barriers, sensors.

#include <array>
#include <cstdint>
#include <optional>

#include "base/axis.hpp"
#include "machine/machine.hpp"

namespace kerf {

/// Where the signal at the input of one axis comes from.
struct SkipInput {
  enum class Source : std::uint8_t {
    none,      ///< it never comes
    position,  ///< when this axis reaches a position
    time,      ///< so long after the movement began
    shared,    ///< it is the signal at the input of another axis, whose source is none of `shared`
  };
  Source source = Source::none;
  double position = 0.0;  ///< machine coordinate
  double seconds = 0.0;
  Axis axis = Axis::X;  ///< of `shared`
};

using SkipInputs = std::array<SkipInput, kAxisCount>;

/// A movement from rest to rest with constant acceleration and a highest speed: the position of one axis over
/// time. What takes no time has an acceleration or a speed without bounds.
class RestToRest {
 public:
  /// Speed per minute, acceleration per second squared, both above 0.
  RestToRest(double start, double end, double speed, double acceleration);

  double seconds() const { return 2.0 * ramp_ + cruise_; }
  /// `time` from 0 to seconds().
  double position(double time) const;
  double speed(double time) const;  ///< per second, along the way, >= 0
  /// When it passes a position; nothing when that is not on the way, or where it starts.
  std::optional<double> time_at(double position) const;
  /// Where it comes to rest when it starts to brake at a time.
  double braked_from(double time) const;

 private:
  double start_;
  double way_;  ///< >= 0
  double sign_;
  double acceleration_;
  double top_;     ///< per second
  double ramp_;    ///< seconds of each ramp
  double cruise_;  ///< seconds between them
};

/// Where the axes of a move go when each stops by its own signal.
struct SkipStop {
  AxisVector captured;  ///< where the signal came; of an axis without one, where it was sent
  AxisVector braked;    ///< where the axis comes to rest before it goes back there
};

/// All axes start at the same time and go by themselves, with their rapid rates of the set.
SkipStop skip_stop(const AxisVector& start, const AxisVector& end, const Machine& machine, RateSet rates,
                   const SkipInputs& inputs);

}  // namespace kerf
