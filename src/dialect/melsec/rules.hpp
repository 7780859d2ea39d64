#pragma once
// How blocks of the MELSEC G-code control act on the state.

#include "dialect/melsec/block_words.hpp"
#include "dialect/melsec/settings.hpp"
#include "execute/block_rules.hpp"
#include "execute/code_table.hpp"
#include "execute/travel.hpp"
#include "machine/machine.hpp"

namespace kerf::melsec {

/// Tool compensation numbers, from 1; 0 cancels.
inline constexpr std::int32_t kCompensations = 40;

/// Axes that one block may move.
inline constexpr int kContouringAxes = 4;

class Rules final : public BlockRules {
 public:
  Rules(const ControllerSettings& settings, const Machine& machine);

  BlockFeed open(std::shared_ptr<const Source> source, ProgramTexts others) const override;
  State initial_state() const override;
  void begin_program(State& state) const override;
  BlockOutcome execute(const Block& block, State& state, ActionQueue& queue,
                       BlockEffects& effects) const override;
  BlockOutcome take_over(const Block& block, State& state, ActionQueue& queue,
                         BlockEffects& effects) const override;
  void end_of_data(State& state, ActionQueue& queue) const override;
  Alarm syntax_alarm(SyntaxFault fault, const SourceSpan& span) const override;
  AxisVector work_origin(const State& state) const override;
  AxisVector work_position(const State& state) const override;
  AxisVector shown(AxisVector position) const override;

  const ControllerSettings& settings() const { return settings_; }
  const Machine& machine() const { return machine_; }
  const Travel& travel() const { return travel_; }
  const LineAxes& line() const { return line_; }

 private:
  /// Apart from execute(), whose stack frame it would make large: most blocks do not come here.
  [[gnu::noinline]] BlockOutcome execute_whole(const Block& block, State& state, ActionQueue& queue,
                                               BlockEffects& effects) const;

  ControllerSettings settings_;
  Machine machine_;
  Travel travel_;
  LineAxes line_;
};

/// 1 for G54 to 6 for G59.
inline std::size_t work_system(const Registers& registers) {
  return static_cast<std::size_t>(registers.modal[Group::work_system] / 10 - 53);
}

/// Offset of the selected work coordinate system, the local coordinate system in it included.
AxisVector workpiece_origin(const Registers& registers, const Tables& tables);

}  // namespace kerf::melsec
