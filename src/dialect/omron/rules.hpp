#pragma once
// How a block of the NC Integrated Controller acts.

#include "dialect/omron/settings.hpp"
#include "execute/block_rules.hpp"
#include "execute/travel.hpp"
#include "machine/machine.hpp"

namespace kerf::omron {

/// Where the motors of a skip move were caught, machine coordinates in the unit of the block.
struct Captured {
  AxisSet axes;
  AxisVector positions;
};

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
  const Travel& travel() const { return travel_; }

 private:
  void keep_captured(const Captured& captured, MacroVariables& variables) const;
  void finish(State& state, ActionQueue& queue) const;

  ControllerSettings settings_;
  Machine machine_;
  Travel travel_;
};

/// Millimetres of a length of 1 in the unit of a code: G20 or G21.
double millimetres_of(CodeNumber unit);

/// The feed in force, mm/min, not above what the parameter set in force allows in the unit in force.
double limited_feed(const Registers& registers, const ControllerSettings& settings);

/// Machine coordinates of the zero point in force: the work coordinate system, if one is selected, and the
/// local coordinate system.
AxisVector workpiece_origin(const Registers& registers, const Tables& tables);

}  // namespace kerf::omron
