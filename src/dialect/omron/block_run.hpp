#pragma once
// One block at work: the steps of its execution in order.

#include <bitset>
#include <optional>

#include "dialect/omron/block_words.hpp"
#include "dialect/omron/coordinates.hpp"
#include "dialect/omron/rules.hpp"

namespace kerf::omron {

/// Registers::outputs while the spindle turns counterclockwise.
inline constexpr std::uint32_t kTurnsBack = 1;

/// Every step returns false when it refused the block; `alarm` then says why. The order of the steps: F, S
/// and ramp times, modal codes, the one-shot code or the motion, then the M code.
class BlockRun {
 public:
  BlockRun(const Rules& rules, const Block& block, State& state, ActionQueue& queue, FlowRequest& flow);

  bool run();
  /// After a refusal: the codes and the end of the move count for the blocks behind.
  void take_over();

  Registers& registers;
  std::optional<Alarm> alarm;
  bool ends_program = false;
  std::optional<TappingPlan> tapping;  ///< the cycle that the block starts
  std::optional<Captured> captured;    ///< by the skip inputs

 private:
  // block_run.cpp
  bool collect();
  bool is_skipped() const;
  bool ramps();
  bool feed();
  bool spindle_speed();
  bool operation();
  bool one_shot();
  bool dwell();
  bool every_word_used();
  // program_step.cpp: M codes
  bool early_m_code();
  bool m_code();
  OutputTiming m_timing() const;
  CodeArguments m_arguments();
  bool output();
  void turn_spindle(SpindleDirection direction, OutputTiming timing = OutputTiming::synchronous,
                    const CodeArguments& arguments = {});
  bool call_program();
  void go_back();
  // modal_step.cpp
  bool compensation_allows_modal();
  bool modal();
  bool transformations();
  bool scaling();
  bool magnifications(AxisTransformation& change);
  bool mirroring();
  bool rotation();
  bool center_words(Change change, AxisVector& center, AxisSet* named);
  bool work_system();
  bool plane();
  bool length_offset();
  const Tool* selected_tool() const;
  bool parameter_set();
  void select_set(const Word& word);
  // motion_step.cpp
  bool motion();
  bool targets(AxisVector& target);
  bool straight(MoveMode mode, const AxisVector& target);
  bool arc(bool clockwise);
  bool arc_by_radius(Vec2 start, Vec2 end, bool clockwise, Arc& out, bool& is_line);
  bool arc_by_center(const Plane& plane, Vec2 start, Vec2 end, bool clockwise, Arc& out);
  bool push(MoveMode mode, const AxisVector& end, const AxisVector& commanded, const Plane& plane = kPlaneXY,
            const Arc& arc = {});
  double effective_feed(const Move& move) const;
  AxisVector real_position(const AxisVector& programmed, AxisSet named) const;
  void arrive(const AxisVector& programmed, AxisSet named);
  // radius_step.cpp
  bool radius_compensation();
  bool compensate(Move& move);
  bool starts(const Move& move);
  bool ends(const Move& move);
  bool compensation_allows_m_code();
  bool compensates() const { return registers.modal[Group::radius_compensation] != code(40); }
  /// From G41 or G42 to the move behind G40.
  bool is_compensating() const { return compensates() || registers.offset_return_pending; }
  // skip_step.cpp
  bool skip_move();
  void go_to(const SkipStop& stop);
  // cycle_step.cpp
  bool cycle_allowed();
  /// Of a cycle, programmed positions on Z.
  struct CycleLevels {
    double r = 0.0;
    double bottom = 0.0;
    double back = 0.0;  ///< where the tool goes in the end
  };
  bool fixed_cycle();
  bool hole_position(AxisVector& hole);
  bool cycle_is_complete();
  CycleLevels cycle_levels() const;
  TappingPlan tapping_plan(const AxisVector& hole, const AxisVector& step, std::int32_t repetitions) const;
  bool cycle_words();
  bool cycle_level(char address, CycleLevel& level);
  double level_of(const CycleLevel& level, double from) const;
  bool cycle_inside_travel(const TappingPlan& plan);
  // reference_step.cpp
  bool local_system();
  bool machine_move();
  bool reference_return();
  bool offsets_are_off();
  void stand_at(const AxisVector& machine);

  /// The value of a word between two bounds.
  bool value(const Word& word, double least, double greatest, double& value);
  bool integer(const Word& word, int least, int greatest, std::int32_t& value);
  /// A length or, for a rotary axis, an angle; mm or degrees.
  bool distance(const Word& word, double& mm);
  bool axis_value(Axis axis, double& value);
  bool refuse(std::string_view detail, const SourceSpan& where, const FixedText<200>& message = {});
  SourceSpan span(const Word& word) const { return span_of(block_, word); }
  void use(char address) { used_.set(place_of(address)); }
  /// Takes the word, if it stands in the block.
  const Word* take(char address);
  bool incremental() const { return registers.modal[Group::distance] == code(91); }
  Plane plane_in_force() const;

  const Rules& rules_;
  const ControllerSettings& settings_;
  const Block& block_;
  const Tables& tables_;
  const std::size_t level_;  ///< of the program: 0 the main program
  ActionQueue& queue_;
  FlowRequest& flow_;
  BlockWords words_;
  double unit_mm_ = 1.0;  ///< of a length in the block
  std::bitset<128> used_;
  bool in_cycle_ = false;  ///< a fixed cycle was in force before the block
  bool moved_ = false;     ///< the block gave a move
  bool taking_over_ = false;
};

}  // namespace kerf::omron
