#pragma once
// What the interpreter gives: a dialect-free list of machine verbs, as values. Toolpath passes rewrite them,
// the planner times them, the reports print them.

#include <array>
#include <cstdint>
#include <variant>

#include "base/alarm.hpp"
#include "base/axis.hpp"
#include "base/fixed_vector.hpp"
#include "base/source_span.hpp"
#include "machine/machine.hpp"

namespace kerf {

/// Where an action came from. The stopping points of single block operation lie where `block` changes: what
/// the toolpath puts in between (moves around corners, arcs put into corners, turns of a normal line axis)
/// has the block that it is executed with (MELSEC 6.4, 6.6). A value of 0 in `sequence_number` is a legal N0.
struct Origin {
  SourceSpan span;                    ///< the block
  std::uint32_t block = 0;            ///< blocks with content reached since the start, counted from 1
  std::int32_t program = -1;          ///< program number; -1: none
  std::int32_t sequence_number = -1;  ///< sequence number in force; -1: none
};

enum class MoveMode : std::uint8_t { rapid, linear, clockwise, counterclockwise };

constexpr bool is_arc(MoveMode mode) {
  return mode == MoveMode::clockwise || mode == MoveMode::counterclockwise;
}

/// A plane for arcs: third points to the viewer when first x second is right-handed (X-Y-Z, Z-X-Y, Y-Z-X).
struct Plane {
  Axis first = Axis::X;
  Axis second = Axis::Y;
  Axis third = Axis::Z;
  friend constexpr bool operator==(const Plane&, const Plane&) = default;
};

inline constexpr Plane kPlaneXY{Axis::X, Axis::Y, Axis::Z};
inline constexpr Plane kPlaneZX{Axis::Z, Axis::X, Axis::Y};
inline constexpr Plane kPlaneYZ{Axis::Y, Axis::Z, Axis::X};

/// An arc in a plane; every other axis moves linearly with the angle (helix). Where the end of the move lies
/// at another distance from the centre than its start, the radius changes evenly (spiral).
struct Arc {
  std::array<double, 2> center{};  ///< machine coordinates of plane.first and plane.second, mm
  double radius = 0.0;             ///< mm, > 0; of a spiral that of its start
  double sweep = 0.0;              ///< degrees, positive counter-clockwise seen from +third; may exceed 360
};

/// Side of the programmed path on which the tool runs, looking in the direction of travel.
enum class Side : std::uint8_t { none, left, right };

/// What the vector from the programmed path to the tool is where a block ends.
enum class VectorRule : std::uint8_t {
  computed,         ///< by the paths before and behind
  at_right_angles,  ///< to RadiusCompensation::direction, on the side in force
  along,            ///< in that direction
  kept,             ///< as it was where the block began
};

/// Tool radius compensation as the block commands it; the compensation pass acts on it.
struct RadiusCompensation {
  Side side = Side::none;
  double amount = 0.0;      ///< mm; a negative amount exchanges the sides. With no side, behind the toolpath:
                            ///< that of the compensation which the move ends
  std::uint32_t start = 0;  ///< counts the starts: with another number a new compensation begins
  VectorRule rule = VectorRule::computed;
  bool suspended = false;  ///< this move alone goes to its programmed end
  /// In the compensation plane, any length. Of a block that ends the compensation: not {0, 0}: it ends where
  /// the path meets that of an imagined straight block in this direction.
  std::array<double, 2> direction{};
};

/// Feed of a rotary axis by the peripheral speed at a radius (DGSHAPE 1-4, 2-5): rate = feed / radius. With
/// radius 0 or at_maximum the rotary axis turns at its own maximum rate.
struct RotaryFeed {
  bool active = false;
  bool at_maximum = false;
  Axis axis = Axis::A;
  double radius = 0.0;  ///< mm
};

/// How a path is to be followed, as the program asks for it.
enum class PathMode : std::uint8_t {
  cutting,          ///< blocks run into each other
  exact_stop,       ///< at rest between blocks; Move::exact_stop says so too
  high_accuracy,    ///< with the corners and speeds that keep the path true
  corner_override,  ///< slower before inner corners
};

/// How the coordinates of a move in a polar plane are to be read.
enum class PolarForm : std::uint8_t {
  none,   ///< no polar plane: every coordinate is that of its axis
  plane,  ///< that of the rotary axis is the second one of the plane, mm from the centre of rotation
  axes,   ///< start and end are where the axes stand; between them they run so that the move is the line or
          ///< arc of the plane
};

/// A linear and a rotary axis that draw Cartesian figures on the work (polar coordinate interpolation). The
/// point (x, y) of the plane, in mm from the centre of rotation, lies at the distance and the angle of the
/// axes: x = r cos a, y = r sin a with r = linear axis - center, a = rotary axis - zero. r keeps its sign.
/// Arc::center has the first coordinate in machine coordinates of the linear axis and the second in mm from
/// the centre of rotation.
struct PolarPlane {
  PolarForm form = PolarForm::none;
  bool minus = false;  ///< r <= 0
  Axis linear = Axis::X;
  Axis rotary = Axis::C;
  double center = 0.0;  ///< machine coordinate of the linear axis over the centre of rotation, mm
  double zero = 0.0;    ///< machine coordinate of the rotary axis at the angle 0, degrees
};

/// Move::inner_corner_deg in front of an arc that was put into an inner corner, which counts as one of any
/// angle.
inline constexpr double kRoundedInnerCorner = 1e-3;

struct Move {
  MoveMode mode = MoveMode::rapid;
  PathMode path_mode = PathMode::cutting;
  bool from_rest = false;   ///< the axes come to rest before it
  bool exact_stop = false;  ///< the axes come to rest at the end
  bool axis_words = true;   ///< the block names an axis of the plane, even when the distance is zero
  bool each_axis = false;  ///< of a rapid move: every axis goes by itself, as fast as it may (AxisMotionPass)
  bool passes_on = false;  ///< of such a move: its next leg goes on without a rest between; of one of
                           ///< PolarForm::axes: its next piece (PolarPieces)
  RateSet rates = 0;       ///< highest rates of the axes
  Side normal_line = Side::none;  ///< a rotary axis keeps the tool square to the path, on this side of it
  Axis last_axis = Axis::X;  ///< of such a move's legs: the axis that arrives last, and moves in all of them
  Plane plane = kPlaneXY;
  RadiusCompensation compensation;
  RotaryFeed rotary_feed;
  PolarPlane polar;
  AxisVector start;            ///< machine coordinates; where the tool reference point really is
  AxisVector end;              ///< machine coordinates
  AxisVector commanded;        ///< end in the coordinate system the block was written in, before tool
                               ///< compensations: the workpiece coordinate system, or the machine's for G53
  bool normal_starts = false;  ///< with normal_line: the control starts here, even where it ended just before
  bool rounds_corner = false;  ///< an arc that was put into a corner
  bool feed_in_space = false;  ///< of an arc: the feed is that along X, Y and Z, not that in its plane
  double inner_corner_deg = 0.0;  ///< of a compensated move: angle of the inner corner at its end, on the
                                  ///< tool's side; 0: there is none between cutting moves
  double spindle_turns = 0.0;     ///< that a spindle turning with the axes makes along it, clockwise positive
  double normal_zero = 0.0;       ///< with normal_line: machine coordinate of its axis at 0 degrees, degrees
  double feed = 0.0;  ///< programmed mm/min, before override; of a rapid move the highest speed of any axis,
                      ///< 0: the axes' own
  Arc arc;            ///< only when is_arc(mode)
};

/// Corner arc of the tool radius compensation (G39): turn on the spot to the direction of the next move.
/// Consumed by the compensation pass.
struct CornerArc {
  std::array<double, 2> direction{};  ///< in the compensation plane, any length; {0, 0}: take the next move's
  double feed = 0.0;                  ///< mm/min
};

struct Dwell {
  double seconds = 0.0;
};

/// When the output of an M code is switched on (OMRON manual chapter 3, M Code Output Timing).
enum class OutputTiming : std::uint8_t {
  synchronous,     ///< behind the movement; the program waits until it is reset
  immediate,       ///< when the block is interpreted
  with_next_move,  ///< when the next move begins; the program does not wait
};

/// The numbers that an M code hands over. With any of them its timing is synchronous.
struct CodeArguments {
  static constexpr std::size_t kMost = 8;
  std::uint8_t given = 0;              ///< bit i: `values[i]` was written
  std::array<double, kMost> values{};  ///< in the order of the alphabet: A to H
};

/// An M code that is handed to the machine as it is.
struct Auxiliary {
  std::int32_t code = 0;
  OutputTiming timing = OutputTiming::synchronous;
  CodeArguments arguments{};
};

enum class SpindleDirection : std::uint8_t { off, clockwise, counterclockwise, orient };

struct Spindle {
  SpindleDirection direction = SpindleDirection::off;
  double rpm = 0.0;      ///< effective speed after limits and override; 0 when off
  double seconds = 0.0;  ///< time the program waits for the speed
  double angle = 0.0;    ///< of orient: where the spindle stops, degrees
  OutputTiming timing = OutputTiming::synchronous;
  CodeArguments arguments{};
};

struct ToolChange {
  std::int32_t number = 0;  ///< 0: the tool is put back
  double seconds = 0.0;
};

struct Stop {
  bool optional = false;
};

struct End {};

using ActionVariant = std::variant<Move, CornerArc, Dwell, Auxiliary, Spindle, ToolChange, Stop, End, Alarm>;

/// One step of the executed program. An Alarm of severity warning does not stop the program; any other is the
/// last action unless the interpreter is told to recover.
struct Action {
  Origin origin;
  ActionVariant what;
};

/// Whether the program stops with this action: it is an alarm and not just a warning.
inline bool stops_program(const Action& action) {
  const auto* alarm = std::get_if<Alarm>(&action.what);
  return alarm != nullptr && stops_program(*alarm);
}

}  // namespace kerf
