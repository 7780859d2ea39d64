#pragma once
// One block at work: the steps of its execution in order.

#include <optional>

#include "dialect/dgshape/block_words.hpp"
#include "dialect/dgshape/numbers.hpp"
#include "dialect/dgshape/rules.hpp"

namespace kerf::dgshape {

/// A table entry that G10 writes when the whole block proved right.
struct TableWrite {
  enum class Kind : std::uint8_t { none, work_offset, radius };
  Kind kind = Kind::none;
  std::size_t index = 0;
  AxisVector offset;
  double radius = 0.0;
};

/// Every step returns false when it refused the block; `alarm` then says why. The order of the steps is the
/// order of execution (manual 1-3, 2-7): F and S, M codes, modal G codes, then the one-shot code or the
/// motion.
class BlockRun {
 public:
  BlockRun(const Rules& rules, const Block& block, State& state, ActionQueue& queue);

  bool run();

  /// After a refusal: takes over what of the block is beyond doubt, so that the blocks behind it are judged
  /// as if it had been right.
  void take_over();

  Registers& registers;  ///< of the state; the caller puts them back when run() fails
  TableWrite write;
  std::optional<DrillingPlan> drilling;
  bool ends_program = false;
  std::optional<Alarm> alarm;

 private:
  // block_run.cpp
  bool numbers();
  bool stand_alone();
  bool operation();
  bool every_word_used();
  // registers_step.cpp: F, S and M codes
  bool feed();
  bool spindle();
  bool auxiliary();
  bool tool_change(const Word& word);
  bool switch_function(const Word& word, bool fitted, unsigned bit, bool on, std::string_view key);
  void emit_spindle();
  // modal_step.cpp
  bool modal();
  bool offset_restrictions();
  bool offset_start_restrictions();
  bool offset_forbids_one_shot();
  bool unit_and_plane();
  void motion_and_cycle();
  void work_system();
  bool scaling();
  bool radius_offset();
  bool radius_number(std::int32_t& number);
  bool length_offset();
  // motion_step.cpp
  bool motion();
  bool straight(MoveMode mode);
  bool arc();
  bool arc_words(const Plane& plane);
  bool arc_geometry(const Plane& plane, const AxisVector& target, bool clockwise, Arc& out);
  bool feed_available();
  bool cutting_allowed();
  bool push_rapid(const AxisVector& target);
  bool length_move();
  // one_shot_step.cpp
  bool one_shot();
  bool dwell();
  bool data_setting();
  bool work_offset_data();
  bool radius_data();
  bool reference_return();
  bool corner_arc();
  bool machine_move();
  bool set_coordinates();
  // recovery_step.cpp
  void take_over_codes();
  void take_over_end();
  // cycle_step.cpp
  bool fixed_cycle();
  bool cycle_allowed();
  bool cycle_words();
  double cycle_level(const CycleLevel& level, double from) const;
  bool cycle_dwell_and_step();
  bool cycle_repetitions(std::int32_t& repetitions);
  bool cycle_inside_travel(const DrillingPlan& plan);

  // helpers
  bool refuse(std::string_view detail, const SourceSpan& where, const FixedText<200>& message = {},
              const FixedText<200>& remedy = {});
  bool accept(char address, const NumberResult& result, double& value);
  bool read_distance(char address, double& value);
  bool read_integer(char address, double& value);
  /// Writes the destination of every axis word of `axes` into `target`, machine coordinates.
  bool target_of_words(std::string_view axes, AxisVector& target);
  /// The value of an axis word as written, mm or degrees.
  bool axis_value(Axis axis, double& value);
  /// Destination of one axis for a value, under G90/G91 and scaling.
  double destination(Axis axis, double value) const;
  double absolute_destination(Axis axis, double value) const;
  double scaled_length(double value) const;
  SourceSpan span(char address) const { return span_of(block_, words_.word(address)); }
  SourceSpan span(Group group) const { return span_of(block_, words_.word(group)); }
  /// The block leads the tool back from beside the path, even when it names the point programmed last.
  bool returns_from_offset() const {
    return registers.offset_return_pending && (words_.has('X') || words_.has('Y'));
  }
  bool offset_on() const { return registers.modal[Group::radius_compensation] != code(40); }
  bool incremental() const { return registers.modal[Group::distance] == code(91); }
  bool scaled() const { return registers.modal[Group::scaling] == code(51); }
  /// Takes in what the block changed about the workpiece coordinate system.
  void update_origin();
  void warn(std::string_view detail, const SourceSpan& where);
  void use(std::string_view addresses) { used_ |= mask_of(addresses); }
  /// A move, refused when it would leave the travel; the arc only when the mode is one.
  bool push_move(MoveMode mode, const AxisVector& target, const Plane& plane = kPlaneXY, const Arc& arc = {});
  bool check_travel(const Move& move);
  bool refuse_travel(const Excess& excess);
  Move& last_move() { return std::get<Move>(queue_.last().what); }

  const Rules& rules_;
  const ControllerSettings& settings_;
  const Block& block_;
  const Tables& tables_;
  ActionQueue& queue_;
  NumberReader reader_;
  BlockWords words_;
  AxisVector origin_;  // machine coordinates of the workpiece origin in force
  WordMask used_ = 0;
  bool offset_was_on_ = false;  // radius compensation in force before the block
};

}  // namespace kerf::dgshape
