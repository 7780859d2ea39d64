#include "dialect/melsec/rules.hpp"

#include <cmath>

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/block_run.hpp"
#include "dialect/melsec/compile.hpp"
#include "dialect/melsec/coordinate_block.hpp"
#include "execute/grid.hpp"
#include "execute/program_store.hpp"

namespace kerf::melsec {
namespace {

std::shared_ptr<const CompiledProgram> compile_called(ProgramText text, std::int32_t number) {
  if (text.unreadable) return refused_program(std::move(text.source), number, "0040H");
  return text.source == nullptr ? nullptr : compile(std::move(text.source), number);
}

FlowAlarms flow_alarms() {
  // In the order of FlowFault.
  return {{{&alarm_kind("032AH")},
           {&alarm_kind("0319H")},
           {&alarm_kind("0318H")},
           {&alarm_kind("031FH")},
           {&alarm_kind("0320H")},
           {&alarm_kind("0329H")},
           {&alarm_kind("0335H")},
           {&alarm_kind("032FH")},
           {&alarm_kind("0333H")},
           {&alarm_kind("0334H")},
           {&alarm_kind("0306H"), "The jump leads into a loop from outside of it.",
            "Let the jump lead to the WHILE or DO of the loop, or in front of it."},
           {&alarm_kind("endless-loop")}}};
}

}  // namespace

Rules::Rules(const ControllerSettings& settings, const Machine& machine)
    : settings_(settings), machine_(machine), travel_(machine), line_{machine.axes, machine.followers()} {}

BlockFeed Rules::open(std::shared_ptr<const Source> source, ProgramTexts others) const {
  const std::int32_t number = stored_number(source->name()).value_or(1);
  return ProgramFlow(compile(std::move(source), number), compiled_once(std::move(others), compile_called),
                     flow_alarms());
}

State Rules::initial_state() const {
  State state;
  for (const Axis axis : machine_.axes) state.registers.position[axis] = machine_[axis].start;
  state.tables.work_offsets = machine_.work_offsets;
  state.tables.length.assign(static_cast<std::size_t>(kCompensations) + 1, 0.0);
  state.tables.radius = state.tables.length;
  for (const Tool& tool : machine_.tools) {
    if (tool.number <= 0 || tool.number > kCompensations) continue;
    const auto number = static_cast<std::size_t>(tool.number);
    state.tables.length[number] = tool.length;
    state.tables.radius[number] = settings_.diameters ? tool.radius / 2.0 : tool.radius;
  }
  state.variables = MacroVariables(settings_.variables);
  return state;
}

void Rules::begin_program(State& state) const {
  Registers& r = state.registers;
  if (r.placement.polar.on) leave_polar(r, settings_, workpiece_origin(r, state.tables));
  r.modal.set(Group::motion, settings_.initial_motion);
  r.modal.set(Group::plane, settings_.initial_plane);
  r.modal.set(Group::distance, settings_.initial_distance);
  r.modal.set(Group::feed_mode, code(94));
  r.modal.set(Group::radius_compensation, code(40));
  r.modal.set(Group::length_compensation, code(49));
  r.modal.set(Group::work_system, code(54));
  r.modal.set(Group::path_mode, code(64));
  r.modal.set(Group::normal_line, code(40, 1));
  r.modal.set(Group::rotation, code(69));
  r.modal.set(Group::polar, code(13, 1));
  r.placement = {};
  r.placement.machine = r.position;
  r.length_number = r.radius_number = -1;
  r.feed_given = r.normal_line_on = false;
  r.feed = 0.0;
  r.program = r.sequence_number = -1;
  state.tables.local_offsets = {};
  state.variables.restart();
}

BlockOutcome Rules::execute(const Block& block, State& state, ActionQueue& queue,
                            BlockEffects& effects) const {
  if (run_coordinate_block(*this, block, state, queue)) return BlockOutcome::done;
  return execute_whole(block, state, queue, effects);
}

BlockOutcome Rules::execute_whole(const Block& block, State& state, ActionQueue& queue,
                                  BlockEffects& effects) const {
  const Registers before = state.registers;
  BlockRun run(*this, block, state, queue, effects.flow);
  if (!run.run()) {
    state.registers = before;
    effects.flow.kind = FlowRequest::Kind::none;
    queue.roll_back();
    queue.push<Alarm>() = *run.alarm;
    return BlockOutcome::alarm;
  }
  if (run.local_written) state.tables.local_offsets[run.local_written->system] = run.local_written->offset;
  if (!run.ends_program) return BlockOutcome::done;
  queue.push<End>();
  return BlockOutcome::ended;
}

BlockOutcome Rules::take_over(const Block& block, State& state, ActionQueue& queue,
                              BlockEffects& effects) const {
  BlockRun run(*this, block, state, queue, effects.flow);
  run.take_over();
  if (run.local_written) state.tables.local_offsets[run.local_written->system] = run.local_written->offset;
  return run.ends_program ? BlockOutcome::ended : BlockOutcome::done;
}

void Rules::end_of_data(State&, ActionQueue& queue) const {
  queue.push<Alarm>() = {&alarm_kind("0309H"), queue.origin().span, {}, {}};
}

Alarm Rules::syntax_alarm(SyntaxFault, const SourceSpan& span) const {
  return {&alarm_kind("0306H"), span, {}, {}};
}

AxisVector Rules::work_origin(const State& state) const {
  return workpiece_origin(state.registers, state.tables);
}

AxisVector Rules::work_position(const State& state) const {
  // In the coordinates before rotation (5.6 G68, program target position).
  const Placement& placement = state.registers.placement;
  const std::size_t system = work_system(state.registers);
  const AxisVector programmed =
      placement.machine - placement.length_taken - state.tables.work_offsets[system];
  AxisVector position = shown(programmed);
  // The second coordinate of a polar plane is a length, which does not begin anew.
  if (placement.polar.on) position[*settings_.polar_rotary] = programmed[*settings_.polar_rotary];
  return position - state.tables.local_offsets[system];
}

AxisVector Rules::shown(AxisVector position) const {
  for (const Axis axis : settings_.endless) {
    position[axis] = std::fmod(on_grid(position[axis]), 360.0);
    if (position[axis] < 0.0) position[axis] += 360.0;
  }
  return position;
}

AxisVector workpiece_origin(const Registers& registers, const Tables& tables) {
  const std::size_t system = work_system(registers);
  AxisVector origin = tables.work_offsets[system];
  origin += tables.local_offsets[system];
  return origin;
}

}  // namespace kerf::melsec
