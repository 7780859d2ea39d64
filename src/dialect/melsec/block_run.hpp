#pragma once
// One block at work: the steps of its execution in order.

#include <optional>

#include "dialect/melsec/block_words.hpp"
#include "dialect/melsec/numbers.hpp"
#include "dialect/melsec/rules.hpp"
#include "geometry/vec2.hpp"

namespace kerf::melsec {

/// A local coordinate system that G52 writes when the whole block proved right.
struct LocalSystem {
  std::size_t system = 0;  ///< 1 for G54
  AxisVector offset;
};

/// The plane of polar coordinate interpolation: linear, rotary and height axis.
Plane polar_plane(const ControllerSettings& settings);
/// I, J or K: the word for the centre of an arc along an axis of that plane.
char polar_center_address(Axis axis, const ControllerSettings& settings);
/// Ends polar coordinate interpolation, if it is on: the program has the axes where they stand. `origin`: of
/// the workpiece coordinate system in force.
void leave_polar(Registers& registers, const ControllerSettings& settings, const AxisVector& origin);

/// Every step returns false when it refused the block; `alarm` then says why.
class BlockRun {
 public:
  BlockRun(const Rules& rules, const Block& block, State& state, ActionQueue& queue, FlowRequest& flow);

  bool run();
  /// After a refusal: the codes and the end of the move count for the blocks behind.
  void take_over();

  Registers& registers;
  std::optional<Alarm> alarm;
  bool ends_program = false;
  std::optional<LocalSystem> local_written;

 private:
  // block_run.cpp
  bool feed();
  bool operation();
  void take_over_operation();
  bool dwell();
  bool local_system();
  void move_rotation(const AxisVector& by);
  bool program_code();
  // modal_step.cpp
  bool combinations();
  bool polar_stands_alone();
  bool codes_have_axes();
  bool modal();
  bool compensation_numbers();
  bool length_offset();
  bool length_number();
  bool calls() const { return words_.program_code() == ProgramCode::call; }
  std::optional<Axis> offset_axis() const;
  bool compensation_number(char address, std::int32_t& number);
  bool rotation();
  bool start_rotation();
  bool rotation_center(Axis axis, double& center);
  bool rotation_angle(double& angle);
  const Word& last_code(CodeSet codes) const;
  // normal_line_step.cpp
  void take_normal_line_axis();
  void turn_along(Move& move);
  // polar_step.cpp
  bool polar();
  bool polar_axes();
  void enter_polar();
  void into_polar_plane(Move& move);
  // radius_step.cpp
  bool radius_compensation();
  bool compensate(Move& move);
  bool vector_direction(const Plane& plane, std::array<double, 2>& direction);
  VectorRule vector_rule(const Move& move) const;
  void corner_arc();
  bool compensation_at_rest();
  // motion_step.cpp
  bool motion();
  bool machine_move();
  void arrive_turned();
  void arrive_at_machine(const AxisVector& machine);
  bool straight(MoveMode mode, const AxisVector& target);
  bool arc();
  bool plane_axes(Plane& plane);
  bool arc_axes(Plane& plane);
  bool stands_on_arc(const Plane& plane);
  bool arc_center(const Plane& plane, Vec2 start, Vec2& center);
  bool arc_by_center(const Plane& plane, const AxisVector& target, bool clockwise, Arc& out);
  bool arc_by_radius(const Plane& plane, const AxisVector& target, bool clockwise, Arc& out, bool& nothing);
  bool targets(AxisVector& target);
  double absolute_target(Axis axis, double from, double shown, double local, double value) const;
  bool absolute_first();
  bool feed_given_for(MoveMode mode);
  /// A move of the axes to `end` in machine coordinates.
  bool push(MoveMode mode, const AxisVector& end, const AxisVector& commanded, const Plane& plane = kPlaneXY,
            const Arc& arc = {});
  /// The axes stand at a programmed position.
  void arrive(const AxisVector& programmed, AxisSet named);
  char center_address(Axis axis) const;

  bool accept(const Word& word, const NumberResult& result, double& value);
  bool refuse(std::string_view detail, const SourceSpan& where, const FixedText<200>& message = {},
              const FixedText<200>& remedy = {});
  SourceSpan span(const Word& word) const { return span_of(block_, word); }
  SourceSpan span(Axis axis) const { return span(*words_.axis(axis).word); }

  const Rules& rules_;
  const Block& block_;
  const Tables& tables_;
  ActionQueue& queue_;
  FlowRequest& flow_;
  BlockWords words_;
  bool taking_over_ = false;       ///< a refused block: nothing is pushed, and no move is refused again
  bool turns_along_ = false;       ///< under normal line control
  bool ends_normal_line_ = false;  ///< which is a stop
  std::optional<double> turned_;   ///< where the move leaves the axis of normal line control
  bool was_compensated_ = false;   ///< before the block
  double rapid_feed_ = 0.0;        ///< mm/min, of ,F; 0: not given
};

}  // namespace kerf::melsec
