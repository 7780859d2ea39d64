#pragma once
// How a DGSHAPE block acts.

#include "dialect/dgshape/block_words.hpp"
#include "dialect/dgshape/settings.hpp"
#include "execute/block_rules.hpp"
#include "execute/travel.hpp"
#include "machine/machine.hpp"

namespace kerf::dgshape {

/// Bits of Registers::outputs.
inline constexpr std::uint32_t kBlowerOutput = 1;
inline constexpr std::uint32_t kCleanerOutput = 2;
inline constexpr std::uint32_t kLightOutput = 4;

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

  const ControllerSettings& settings() const { return settings_; }
  const Machine& machine() const { return machine_; }
  const CodeIndex& codes() const { return codes_; }
  const Travel& travel() const { return travel_; }

 private:
  /// Apart from execute(), whose stack frame it would make large: most blocks do not come here.
  [[gnu::noinline]] BlockOutcome execute_whole(const Block& block, State& state, ActionQueue& queue,
                                               DrillingCycle& cycle) const;
  void finish(State& state, ActionQueue& queue) const;

  ControllerSettings settings_;
  Machine machine_;
  CodeIndex codes_;
  Travel travel_;
};

/// Workpiece origin-point offset plus EXOFS plus the shift of G92, per axis (manual 1-2).
AxisVector workpiece_origin(const Registers& registers, const Tables& tables);

/// Spindle speed the machine really turns: override, resolution, limits (manual 1-4, 2-4).
double effective_rpm(const ControllerSettings& settings, double programmed);

}  // namespace kerf::dgshape
