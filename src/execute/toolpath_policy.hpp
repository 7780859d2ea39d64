#pragma once
// What a dialect lays down for the passes between interpreter and planner. The passes know these values, not
// the dialect.

#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/alarm.hpp"
#include "base/axis.hpp"

namespace kerf {

/// Path of the first and last block of a compensation at outer corners. A: by the point at right angles to
/// the compensated block; B: around the corner, as between compensated blocks.
enum class StartType : std::uint8_t { A, B };

/// What becomes of compensation points between which the tool would run back along a block.
enum class InterferenceCheck : std::uint8_t {
  none,   ///< nothing
  alarm,  ///< an alarm before the block in front of them
  avoid,  ///< the tool goes from the block before to the block behind, where their paths meet
};

/// What differs between controllers. Every alarm kind must be given.
struct RadiusCompensationPolicy {
  StartType start_type = StartType::A;
  double small_angle_deg = 1.0;           ///< see CornerRules
  double joint_gap_mm = 0.01;             ///< see CornerRules
  std::size_t blocks_without_motion = 2;  ///< so many blocks without motion in the plane end the look-ahead
  bool type_b_beside =
      false;  ///< type B leads by the points at right angles to the starting and ending block
  bool joints_belong_to_next =
      false;                 ///< moves put in behind the first point of a corner are the next block's
  bool start_waits = false;  ///< a start that sees no block behind it is programmed, and the next one starts
  bool resumes_unjoined =
      false;  ///< behind an ended look-ahead a block leads from where the tool is to its end
  bool changes_in_force = false;  ///< side and amount may change while in force
  bool starts_at_rest = false;    ///< a side commanded without motion takes effect at the next move's start
  bool stop_ends_look_ahead = false;  ///< nothing behind a stop is looked at before it
  bool corner_arc_inside = false;     ///< corner arcs are made at inner corners too
  bool small_arcs_turn_over = false;  ///< an arc smaller than the tool is run on the far side of its centre
  bool drops_whole_turns = false;     ///< of an arc that the compensation makes longer than 360 degrees
  bool rounds_acute = false;          ///< see CornerRules
  bool feed_at_edge =
      false;  ///< the feed along arcs is that of the programmed path, not of the tool's centre
  bool stops_before_fault = false;  ///< the block that ends at an impossible corner is not made
  InterferenceCheck interference = InterferenceCheck::none;
  std::size_t interference_blocks = 4;  ///< farther apart than this two blocks are not seen together
  bool sees_contour_ahead = false;  ///< the check looks at all blocks seen together, not at neighbours alone;
                                    ///< not with small_arcs_turn_over
  const AlarmKind* interference_alarm = nullptr;  ///< must be given with a check
  const AlarmKind* start_with_arc = nullptr;
  const AlarmKind* end_with_arc = nullptr;
  const AlarmKind* inner_arc_radius = nullptr;    ///< offset larger than the radius on the inside of an arc
  const AlarmKind* no_crossover = nullptr;        ///< the parallels of two blocks do not meet
  const AlarmKind* side_change = nullptr;         ///< side, amount or plane changes while in force
  const AlarmKind* corner_arc_outside = nullptr;  ///< corner arc while not in force
};

/// A rotary axis that keeps the tool at right angles to the path (MELSEC 6.6). Degrees.
struct NormalLinePolicy {
  std::optional<Axis> axis;  ///< none: there is no such control
  bool one_way = false;      ///< type II: the axis turns at joints as the side says, and the tip has the feed
  double least_angle_deg = 0.0;          ///< smaller turns at joints are left out
  double least_way_mm = 0.0;             ///< shorter moves turn nothing
  double turning_speed = 0.0;            ///< degree/min at joints, type I
  double tool_radius_mm = 0.0;           ///< from the centre of the axis to the tip, type II
  double insert_radius_mm = 0.0;         ///< of arcs put into corners, type I; 0: none
  const AlarmKind* wrong_way = nullptr;  ///< must be given with an axis
};

/// A plane of a linear and a rotary axis (MELSEC 5.6, G12.1).
struct PolarPolicy {
  std::optional<Axis> rotary;  ///< none: there is no such plane
  bool endless = false;        ///< whole turns of it do not count
};

/// Slower before inner corners (MELSEC 5.6, G62): in moves of PathMode::corner_override.
struct CornerOverridePolicy {
  double percent = 100.0;   ///< of the feed; 0 and 100: nothing is slowed
  double widest_deg = 0.0;  ///< corners up to this angle; 0 and 180: none
  double length_mm = 0.0;   ///< along the tool's path before the corner; 0: none

  bool is_on() const {
    return percent > 0.0 && percent < 100.0 && widest_deg > 0.0 && widest_deg < 180.0 && length_mm > 0.0;
  }
};

/// Travel of the axes.
struct TravelLimitPolicy {
  const AlarmKind* over_travel = nullptr;  ///< must be given unless nothing but lines is clipped
  bool clip = false;                       ///< cut straight moves at the border instead of raising the alarm
};

/// What a dialect lays down for the passes.
struct ToolpathPolicy {
  RadiusCompensationPolicy compensation;
  CornerOverridePolicy corner_override;
  NormalLinePolicy normal_line;
  PolarPolicy polar;
  TravelLimitPolicy limits;
};

}  // namespace kerf
