#pragma once
// What a dialect lays down for the passes between interpreter and planner. The passes know these values, not
// the dialect.

#include <cstddef>
#include <cstdint>

#include "base/alarm.hpp"

namespace kerf {

/// Path of the first and last block of a compensation at outer corners. A: by the point at right angles to
/// the compensated block; B: around the corner, as between compensated blocks.
enum class StartType : std::uint8_t { A, B };

/// What differs between controllers. Every alarm kind must be given.
struct RadiusCompensationPolicy {
  StartType start_type = StartType::A;
  double small_angle_deg = 1.0;           ///< see CornerRules
  double joint_gap_mm = 0.01;             ///< see CornerRules
  std::size_t blocks_without_motion = 2;  ///< so many blocks without motion in the plane end the look-ahead
  const AlarmKind* start_with_arc = nullptr;
  const AlarmKind* end_with_arc = nullptr;
  const AlarmKind* inner_arc_radius = nullptr;    ///< offset larger than the radius on the inside of an arc
  const AlarmKind* no_crossover = nullptr;        ///< the parallels of two blocks do not meet
  const AlarmKind* side_change = nullptr;         ///< side, amount or plane changes while in force
  const AlarmKind* corner_arc_outside = nullptr;  ///< corner arc while not in force
};

/// Travel of the axes.
struct TravelLimitPolicy {
  const AlarmKind* over_travel = nullptr;  ///< must be given unless nothing but lines is clipped
  bool clip = false;                       ///< cut straight moves at the border instead of raising the alarm
};

/// What a dialect lays down for the passes.
struct ToolpathPolicy {
  RadiusCompensationPolicy compensation;
  TravelLimitPolicy limits;
};

}  // namespace kerf
