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
  bool unfinished_codes();
  bool feed();
  void modal();
  bool operation();
  bool dwell();
  bool local_system();
  bool program_code();
  // motion_step.cpp
  bool motion();
  bool machine_move();
  bool straight(MoveMode mode, const AxisVector& target);
  bool arc();
  bool arc_axes(Plane& plane);
  bool arc_center(const Plane& plane, Vec2 start, Vec2& center);
  bool arc_by_center(const Plane& plane, const AxisVector& target, bool clockwise, Arc& out);
  bool arc_by_radius(const Plane& plane, const AxisVector& target, bool clockwise, Arc& out, bool& nothing);
  bool targets(AxisVector& target);
  bool cutting_feed();
  bool push(MoveMode mode, const AxisVector& target, const Plane& plane = kPlaneXY, const Arc& arc = {});
  char center_address(Axis axis) const;

  bool accept(const Word& word, const NumberResult& result, double& value);
  bool refuse(std::string_view detail, const SourceSpan& where, const FixedText<200>& message = {});
  SourceSpan span(const Word& word) const { return span_of(block_, word); }
  SourceSpan span(Axis axis) const { return span(*words_.axis(axis).word); }

  const Rules& rules_;
  const Block& block_;
  const Tables& tables_;
  ActionQueue& queue_;
  FlowRequest& flow_;
  BlockWords words_;
};

}  // namespace kerf::melsec
