#include "dialect/dgshape/rules.hpp"

#include <algorithm>
#include <cmath>

#include "dialect/dgshape/alarms.hpp"
#include "dialect/dgshape/block_run.hpp"
#include "dialect/dgshape/coordinate_block.hpp"

namespace kerf::dgshape {
namespace {

std::vector<double> offset_table(const Machine& machine, std::int64_t highest, double Tool::*value) {
  std::vector<double> table(static_cast<std::size_t>(highest) + 1, 0.0);
  for (const Tool& tool : machine.tools) {
    if (tool.number > 0 && tool.number <= highest) table[static_cast<std::size_t>(tool.number)] = tool.*value;
  }
  return table;
}

}  // namespace

double effective_rpm(const ControllerSettings& settings, double programmed) {
  const auto limited = [&](double rpm) {
    return std::clamp(rpm, settings.spindle_min, std::max(settings.spindle_min, settings.spindle_max));
  };
  // The speed a program may have is what the override takes for 100 % (manual 1-4).
  double rpm = limited(programmed) * settings.spindle_override / 100.0;
  if (settings.spindle_resolution > 0.0) {
    rpm = std::round(rpm / settings.spindle_resolution) * settings.spindle_resolution;
  }
  return limited(rpm);
}

Rules::Rules(const ControllerSettings& settings, const Machine& machine)
    : settings_(settings), machine_(machine), travel_(machine) {}

BlockFeed Rules::open(std::shared_ptr<const Source> source, ProgramTexts) const {
  return BlockReader(std::move(source));
}

State Rules::initial_state() const {
  State state;
  for (Axis axis : machine_.axes) state.registers.position[axis] = machine_[axis].start;
  state.registers.spindle_rpm = settings_.spindle_default;
  state.tables.work_offsets = machine_.work_offsets;
  state.tables.radius = offset_table(machine_, settings_.offset_numbers, &Tool::radius);
  state.tables.length = offset_table(machine_, settings_.length_numbers, &Tool::length);
  return state;
}

void Rules::begin_program(State& state) const {
  Registers& r = state.registers;
  r.position[Axis::Z] += r.length_applied;
  r.length_offset = r.length_applied = 0.0;
  r.modal.set(Group::motion, settings_.initial_motion);
  r.modal.set(Group::plane, settings_.initial_plane);
  r.modal.set(Group::unit, settings_.initial_unit);
  r.modal.set(Group::distance, settings_.initial_distance);
  r.modal.set(Group::return_level, settings_.initial_return);
  r.modal.set(Group::work_system, settings_.initial_system);
  r.modal.set(Group::radius_compensation, code(40));
  r.modal.set(Group::length_compensation, code(49));
  r.modal.set(Group::scaling, code(50));
  r.modal.set(Group::fixed_cycle, code(80));
  r.scaling = {};
  r.midpoint_axes = {};
  r.cycle = {};
  r.feed_given = r.unit_locked = r.offset_return_pending = r.spindle_warned = false;
  r.feed = 0.0;
  r.radius_number = -1;
  r.length_number = 0;
  r.program = r.sequence_number = -1;
}

BlockOutcome Rules::execute(const Block& block, State& state, ActionQueue& queue,
                            BlockEffects& effects) const {
  if (run_coordinate_block(*this, block, state, queue)) return BlockOutcome::done;
  return execute_whole(block, state, queue, effects.cycle);
}

BlockOutcome Rules::execute_whole(const Block& block, State& state, ActionQueue& queue,
                                  DrillingCycle& cycle) const {
  const Registers before = state.registers;
  BlockRun run(*this, block, state, queue);
  if (!run.run()) {
    state.registers = before;
    queue.roll_back();
    queue.push<Alarm>() = *run.alarm;
    return BlockOutcome::alarm;
  }
  if (run.write.kind == TableWrite::Kind::work_offset)
    state.tables.work_offsets[run.write.index] = run.write.offset;
  if (run.write.kind == TableWrite::Kind::radius) state.tables.radius[run.write.index] = run.write.radius;
  if (run.drilling) cycle.start(*run.drilling, queue.origin());
  if (!run.ends_program) return BlockOutcome::done;
  finish(state, queue);
  return BlockOutcome::ended;
}

BlockOutcome Rules::take_over(const Block& block, State& state, ActionQueue& queue, BlockEffects&) const {
  BlockRun run(*this, block, state, queue);
  run.take_over();
  return run.ends_program ? BlockOutcome::ended : BlockOutcome::done;
}

void Rules::finish(State& state, ActionQueue& queue) const {
  // M02 and M30 leave a safe machine: spindle, blower and cleaner go off (DGS-508); the light stays.
  if (state.registers.spindle_on) queue.push<Spindle>();
  state.registers.spindle_on = false;
  state.registers.outputs &= kLightOutput;
  if (settings_.g10_volatile) state.tables = initial_state().tables;
  if (settings_.shift_volatile) state.registers.shift = {};
  queue.push<End>();
}

void Rules::end_of_data(State& state, ActionQueue& queue) const {
  queue.push<Alarm>() = {&alarm_kind("no-program-end"), queue.origin().span, {}, {}};
  finish(state, queue);
}

Alarm Rules::syntax_alarm(SyntaxFault fault, const SourceSpan& span) const {
  Alarm alarm{&syntax_alarm_kind(fault), span, {}, {}};
  if (fault == SyntaxFault::letter_in_number) {
    alarm.message = "A letter stands where the number begins.";
    alarm.remedy = "Write the digit 0 instead of the letter O, and 1 instead of I.";
  }
  return alarm;
}

AxisVector Rules::work_origin(const State& state) const {
  return workpiece_origin(state.registers, state.tables);
}

AxisVector workpiece_origin(const Registers& registers, const Tables& tables) {
  const auto system = static_cast<std::size_t>(registers.modal[Group::work_system] / 10 - 53);
  AxisVector origin = tables.work_offsets[0];
  origin += tables.work_offsets[system];
  origin += registers.shift;
  return origin;
}

}  // namespace kerf::dgshape
