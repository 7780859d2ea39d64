#pragma once
// The machine as the stages below the interpreter see it: plain numbers, already validated.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/axis.hpp"

namespace kerf {

enum class AxisType : std::uint8_t { linear, rotary };

/// Highest rates of an axis. In a set of its own 0 stands for what the axis has otherwise.
struct AxisRates {
  double rapid = 0.0;               ///< mm/min or degree/min
  double max_feed = 0.0;            ///< the same while cutting
  double acceleration = 0.0;        ///< mm/s2 or degree/s2
  double rapid_acceleration = 0.0;  ///< of rapid moves
};

/// Which rates of the axes a move keeps to: 0 those that the axes have otherwise, i the set
/// AxisSettings::other_rates[i - 1]. What the sets are for is the dialect's business.
using RateSet = std::uint8_t;
inline constexpr std::size_t kOtherRateSets = 4;

/// One axis. Lengths in mm (degrees when rotary), speeds per minute, accelerations per second squared.
struct AxisSettings {
  std::int32_t number = 0;  ///< servo axis number
  AxisType type = AxisType::linear;
  double lower_limit = -9999.9999;  ///< machine coordinate; infinite: none
  double upper_limit = 9999.9999;
  double rapid = 6000.0;            ///< mm/min or degree/min
  double max_feed = 6000.0;         ///< mm/min or degree/min
  double acceleration = 500.0;      ///< mm/s2 or degree/s2
  double rapid_acceleration = 0.0;  ///< of rapid moves; 0: acceleration
  double jerk = 5000.0;             ///< mm/s3 or degree/s3
  double home = 0.0;                ///< machine coordinate of the reference point
  double start = 0.0;               ///< machine coordinate where the axis stands when the program starts
  std::array<AxisRates, kOtherRateSets> other_rates{};
  std::optional<Axis> master =
      std::nullopt;  ///< the axis makes every movement of this one and none of its own
};

/// One tool or compensation number.
struct Tool {
  std::int32_t number = 0;
  double radius = 0.0;  ///< mm
  double length = 0.0;  ///< mm
};

/// Settings of the motion stages.
struct MotionSettings {
  std::string law = "controller";    ///< controller | optimal
  double junction_deviation = 0.01;  ///< mm; 0: every corner is an exact stop
  double servo_gain = 60.0;          ///< 1/s, position loop of the simulated drives
  std::int32_t look_ahead = 1024;    ///< blocks
  bool feed_of_all_axes = false;     ///< a feed is the speed of all axes together, not of X, Y and Z
};

inline constexpr std::size_t kWorkOffsetCount = 7;  ///< EXT, then G54 to G59

struct Machine {
  std::string name;
  double cycle_s = 0.001;  ///< control cycle, seconds
  AxisSet axes;
  std::array<AxisSettings, kAxisCount> axis;  ///< only those in `axes` count
  std::array<AxisVector, kWorkOffsetCount> work_offsets;
  std::vector<Tool> tools;  ///< ascending by number
  MotionSettings motion;

  const AxisSettings& operator[](Axis a) const { return axis[index(a)]; }

  /// The axes that follow another one.
  AxisSet followers() const {
    AxisSet set;
    for (const Axis a : axes) {
      if (axis[index(a)].master) set.insert(a);
    }
    return set;
  }
};

}  // namespace kerf
