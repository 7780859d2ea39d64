#pragma once
// Everything the interpreter remembers between two blocks. Plain values: a copy is a restart point.

#include <array>
#include <cstdint>
#include <vector>

#include "base/axis.hpp"
#include "execute/action.hpp"
#include "execute/macro_variables.hpp"
#include "execute/modal.hpp"
#include "geometry/turn.hpp"
#include "machine/machine.hpp"

namespace kerf {

/// Same-scale enlargement about a point of the workpiece coordinate system.
struct Scaling {
  double factor = 1.0;
  AxisVector reference;  ///< workpiece coordinates
};

/// A level of a fixed cycle as it was written, mm: the coordinate system and the scaling in force when it is
/// used decide where it lies.
struct CycleLevel {
  bool given = false;
  bool incremental = false;
  double value = 0.0;
};

/// Words of a fixed cycle that stay until it is cancelled.
struct CycleWords {
  double initial_level = 0.0;  ///< machine coordinate without length offset
  CycleLevel r;
  CycleLevel bottom;
  double peck = 0.0;  ///< mm, before scaling; 0: none given
  double dwell_s = 0.0;
};

/// Turning of the programmed plane about a point.
struct PlaneRotation {
  bool active = false;
  Plane plane;
  Vec2 center;             ///< machine coordinates
  double angle_deg = 0.0;  ///< counterclockwise; stays when the rotation ends
  Turn turn;               ///< by the angle
};

/// Polar coordinate interpolation: the programmed position of the rotary axis is the second coordinate of the
/// plane (PolarPlane).
struct PolarMode {
  bool on = false;
  bool minus = false;
  CodeNumber plane = 0;  ///< selected before
  double center = 0.0;   ///< as in PolarPlane
  double zero = 0.0;
  double angle = 0.0;  ///< of the rotary axis from there, whole turns included, degrees
  AxisVector length;   ///< tool length offset to go on with behind it
};

/// Mirroring and enlargement of each axis by itself, in this order, about machine coordinates without length
/// offset. The rotation comes behind.
struct AxisTransformation {
  AxisSet mirrored;
  AxisVector mirrors;  ///< of mirrored axes: where the mirror stands
  bool scaled = false;
  AxisVector magnification;  ///< of every axis while scaled, never 0; below 0 it mirrors as well
  AxisVector center;         ///< of the enlargement
};

/// What lies between the programmed position and the axes where it is more than an offset of Z: kept by
/// dialects that turn coordinates and offset the tool's length along any axis.
struct Placement {
  AxisVector machine;       ///< where the axes stand behind the last move, machine coordinates
  AxisVector length;        ///< mm, the tool length offset in force
  AxisVector length_taken;  ///< mm, the part of `machine` that is tool length offset
  AxisSet length_left_out;  ///< axes whose last move in machine coordinates took them back from it
  AxisTransformation transformation;
  PlaneRotation rotation;
  PolarMode polar;
  bool absolute_wanted = false;  ///< the next move must be absolute, because the rotation has changed
  bool rest_wanted = false;      ///< the next move begins from rest
};

/// How long a program wants its speed changes to take, ms.
struct RampTimes {
  double acceleration = 0.0;
  double deceleration = 0.0;
  double jerk = 0.0;
};

/// What a block may change. Small, so that a block works on a copy and the copy replaces the original only
/// when the whole block proved right: an alarm leaves everything as it was.
struct Registers {
  ModalState modal;
  AxisVector position;  ///< machine coordinates as programmed: before tool radius and length compensation
  double length_offset = 0.0;   ///< mm, added to Z by the tool length offset in force
  double length_applied = 0.0;  ///< mm, the part of it that Z has already moved by
  Placement placement;
  AxisVector shift;  ///< of all workpiece coordinate systems (G92)
  Scaling scaling;
  AxisVector midpoint;    ///< of the reference-point return, machine coordinates
  AxisSet midpoint_axes;  ///< axes whose midpoint was ever given
  CycleWords cycle;
  double feed = 0.0;  ///< programmed mm/min
  RampTimes ramps;
  RateSet rates = 0;                ///< of the moves to come
  double spindle_rpm = 0.0;         ///< the S register: programmed speed before limits and override
  std::int32_t tool = 0;            ///< held; 0: none
  std::int32_t radius_number = -1;  ///< D in force; -1: never given
  std::int32_t length_number = 0;   ///< H in force
  double radius_amount = 0.0;       ///< mm, of the D in force
  std::uint32_t radius_start = 0;   ///< counts the starts of the radius compensation
  std::int32_t program = -1;
  std::int32_t sequence_number = -1;
  std::uint32_t outputs = 0;  ///< switched functions, a bit each; which is which is the dialect's business
  bool feed_given = false;
  bool normal_line_on = false;  ///< the axis of normal line control stands square to the path
  bool spindle_on = false;
  bool unit_locked = false;           ///< a motion or coordinate setting was executed
  bool offset_start_pending = false;  ///< radius compensation was commanded, and no move has started it yet
  bool offset_unused = false;         ///< no move came behind the one that started radius compensation
  bool offset_return_pending =
      false;                    ///< radius compensation was cancelled, the tool is not back on the path yet
  bool spindle_warned = false;  ///< cutting with the spindle stopped was reported
};

/// Tables that a program may overwrite.
struct Tables {
  std::array<AxisVector, kWorkOffsetCount> work_offsets;  ///< EXT, then G54 to G59
  std::array<AxisVector, kWorkOffsetCount>
      local_offsets;           ///< local coordinate systems in G54 to G59 ([0] unused)
  std::vector<double> radius;  ///< mm, by D number; [0] is 0
  std::vector<double> length;  ///< mm, by H number; [0] is 0
};

struct State {
  Registers registers;
  Tables tables;
  MacroVariables variables;
};

}  // namespace kerf
