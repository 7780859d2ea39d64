#include "dialect/omron/rules.hpp"

#include <algorithm>

#include "dialect/omron/alarms.hpp"
#include "dialect/omron/block_run.hpp"
#include "dialect/omron/compile.hpp"
#include "dialect/omron/coordinate_block.hpp"
#include "dialect/omron/variables.hpp"
#include "execute/program_store.hpp"

namespace kerf::omron {
namespace {

FlowAlarms flow_alarms() {
  FlowAlarms alarms;
  alarms.fill({&alarm_kind("syntax")});  // faults that no program of this language can have
  alarms[static_cast<std::size_t>(FlowFault::no_variable)] = {&alarm_kind("captured-position")};
  alarms[static_cast<std::size_t>(FlowFault::no_program)] = {&alarm_kind("missing-program")};
  alarms[static_cast<std::size_t>(FlowFault::endless)] = {&alarm_kind("endless-loop")};
  return alarms;
}

}  // namespace

Rules::Rules(const ControllerSettings& settings, const Machine& machine)
    : settings_(settings), machine_(machine), travel_(machine) {}

BlockFeed Rules::open(std::shared_ptr<const Source> source, ProgramTexts others) const {
  const std::int32_t number = number_in_name(source->name());
  const auto compiler = [](ProgramText text, std::int32_t called) {
    return text.source == nullptr ? nullptr : compile(std::move(text.source), called);
  };
  return ProgramFlow(compile(std::move(source), number), compiled_once(std::move(others), compiler),
                     flow_alarms());
}

State Rules::initial_state() const {
  State state;
  for (const Axis axis : machine_.axes) state.registers.position[axis] = machine_[axis].start;
  state.tables.work_offsets = machine_.work_offsets;
  state.registers.tool = settings_.tool;
  state.variables = MacroVariables(variable_layout(machine_.axes.size()));
  return state;
}

void Rules::begin_program(State& state) const {
  Registers& r = state.registers;
  r.modal.set(Group::motion, code(1));
  r.modal.set(Group::plane, code(17));
  r.modal.set(Group::distance, code(90));
  r.modal.set(Group::unit, settings_.inch ? code(20) : code(21));
  r.modal.set(Group::radius_compensation, code(40));
  r.modal.set(Group::length_compensation, code(49));
  r.modal.set(Group::fixed_cycle, code(80));
  r.modal.set(Group::return_level, code(98));
  r.modal.set(Group::work_system, kNoCode);
  r.modal.set(Group::path_mode, code(64));
  r.modal.set(Group::multi_block, code(501));
  r.shift = {};
  r.placement = {};
  r.placement.machine = r.position;
  release_transformations(r);
  r.cycle = {};
  r.feed = 0.0;
  r.feed_given = r.spindle_on = r.offset_start_pending = r.offset_return_pending = false;
  r.spindle_rpm = 0.0;
  r.rates = 0;
  r.ramps = settings_.normal.ramps;
  r.program = r.sequence_number = -1;
  state.variables.restart();
}

BlockOutcome Rules::execute(const Block& block, State& state, ActionQueue& queue,
                            BlockEffects& effects) const {
  if (run_coordinate_block(*this, block, state, queue)) return BlockOutcome::done;
  const Registers before = state.registers;
  BlockRun run(*this, block, state, queue, effects.flow);
  if (!run.run()) {
    state.registers = before;
    effects.flow.kind = FlowRequest::Kind::none;
    queue.roll_back();
    queue.push<Alarm>() = *run.alarm;
    return BlockOutcome::alarm;
  }
  if (run.captured) keep_captured(*run.captured, state.variables);
  if (run.tapping) effects.tapping.start(*run.tapping, queue.origin());
  if (!run.ends_program) return BlockOutcome::done;
  finish(state, queue);
  return BlockOutcome::ended;
}

/// The system variables count the motors in the order of their numbers.
void Rules::keep_captured(const Captured& captured, MacroVariables& variables) const {
  for (const Axis axis : captured.axes) {
    const auto before = [&](Axis other) { return machine_[other].number < machine_[axis].number; };
    double place = 0.0;
    for (const Axis other : machine_.axes) place += before(other) ? 1.0 : 0.0;
    *variables.find_system(place) = captured.positions[axis];
  }
}

BlockOutcome Rules::take_over(const Block& block, State& state, ActionQueue& queue,
                              BlockEffects& effects) const {
  BlockRun run(*this, block, state, queue, effects.flow);
  run.take_over();
  return run.ends_program ? BlockOutcome::ended : BlockOutcome::done;
}

void Rules::finish(State& state, ActionQueue& queue) const {
  state.registers.spindle_on = false;
  state.registers.rates = 0;
  queue.push<End>();
}

void Rules::end_of_data(State& state, ActionQueue& queue) const {
  queue.push<Alarm>() = {&alarm_kind("no-program-end"), queue.origin().span, {}, {}};
  finish(state, queue);
}

Alarm Rules::syntax_alarm(SyntaxFault, const SourceSpan& span) const {
  return {&alarm_kind("syntax"), span, {}, {}};
}

AxisVector Rules::work_origin(const State& state) const {
  return workpiece_origin(state.registers, state.tables);
}

double millimetres_of(CodeNumber unit) {
  constexpr double kInch = 25.4;
  return unit == code(20) ? kInch : 1.0;
}

double limited_feed(const Registers& registers, const ControllerSettings& settings) {
  const double unit = millimetres_of(registers.modal[Group::unit]);
  return std::min(registers.feed, settings.operation(registers.rates).maximum_feedrate * unit);
}

AxisVector workpiece_origin(const Registers& registers, const Tables& tables) {
  AxisVector origin = registers.shift;
  const CodeNumber system = registers.modal[Group::work_system];
  if (system != kNoCode) origin += tables.work_offsets[static_cast<std::size_t>(system / 10 - 53)];
  return origin;
}

}  // namespace kerf::omron
