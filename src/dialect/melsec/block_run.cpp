#include "dialect/melsec/block_run.hpp"

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/placement.hpp"
#include "dialect/melsec/program_call.hpp"

namespace kerf::melsec {

BlockRun::BlockRun(const Rules& rules, const Block& block, State& state, ActionQueue& queue,
                   FlowRequest& flow)
    : registers(state.registers),
      rules_(rules),
      block_(block),
      tables_(state.tables),
      queue_(queue),
      flow_(flow) {}

bool BlockRun::run() {
  if (!words_.collect(block_, registers.modal[Group::distance], rules_.line(), alarm)) return false;
  take_normal_line_axis();
  if (words_.axes().size() > kContouringAxes - (turns_along_ ? 1 : 0)) return refuse("0302H", block_.span);
  if (!combinations() || !compensation_numbers() || !codes_have_axes() || !feed() || !modal()) return false;
  for (const std::int32_t number : words_.auxiliaries()) queue_.push<Auxiliary>().code = number;
  if (!operation()) return false;
  if (ends_normal_line_) registers.placement.rest_wanted = true;
  return program_code();
}

bool BlockRun::refuse(std::string_view detail, const SourceSpan& where, const FixedText<200>& message,
                      const FixedText<200>& remedy) {
  melsec::refuse(alarm, detail, where, message);
  alarm->remedy = remedy;
  return false;
}

bool BlockRun::accept(const Word& word, const NumberResult& result, double& value) {
  value = result.value;
  if (result.fault == NumberFault::none) return true;
  return refuse(result.fault == NumberFault::range ? "0308H" : "031AH", span(word));
}

bool BlockRun::feed() {
  if (const Word* rapid = words_.rapid_feed()) {
    const NumberResult speed = feed_of(*rapid);
    if (speed.fault != NumberFault::none) return refuse("0312H", span(*rapid));
    rapid_feed_ = speed.value;
  }
  const Word* word = words_.find('F');
  if (word == nullptr) return true;
  const NumberResult result = feed_of(*word);
  if (result.fault != NumberFault::none) return refuse("0312H", span(*word));
  registers.feed = result.value;
  registers.feed_given = true;
  return true;
}

bool BlockRun::operation() {
  if (words_.has(kDwell)) return dwell();
  if (words_.has(kLocalSystem)) return local_system();
  if (words_.has(kMachineMove)) return machine_move();
  if (words_[Group::rotation] == code(68)) return true;  // its words are the centre and the angle
  return motion();
}

bool BlockRun::dwell() {
  // P, H and L beside M98 belong to the call.
  const bool call = calls();
  const Word* seconds = words_.find('X');
  const Word* milliseconds = call ? nullptr : words_.find('P');
  if (seconds != nullptr && milliseconds != nullptr) {
    (seconds->column > milliseconds->column ? milliseconds : seconds) = nullptr;
  }
  double value = 0.0;
  if (seconds != nullptr && !accept(*seconds, seconds_of(*seconds), value)) return false;
  if (milliseconds != nullptr) {
    if (!accept(*milliseconds, integer_of(*milliseconds, 0.0, 99999999.0), value)) return false;
    value /= 1000.0;
  }
  queue_.push<Dwell>().seconds = value;
  return true;
}

bool BlockRun::local_system() {
  const std::size_t system = work_system(registers);
  LocalSystem written{system, tables_.local_offsets[system]};
  AxisVector& local = written.offset;
  for (const Axis axis : words_.axes()) {
    const AxisWord& word = words_.axis(axis);
    double value = 0.0;
    if (!accept(*word.word, position_of(*word.word), value)) return false;
    local[axis] = word.incremental ? local[axis] + value : value;
  }
  move_rotation(local - tables_.local_offsets[system]);
  local_written = written;
  return true;
}

/// The centre of rotation keeps its local coordinates when the local coordinate system moves.
void BlockRun::move_rotation(const AxisVector& by) {
  PlaneRotation& rotation = registers.placement.rotation;
  if (!rotation.active) return;
  rotation.center += {by[rotation.plane.first], by[rotation.plane.second]};
  if (!rules_.settings().rotation_takes_start)
    place_plane_at_machine(registers.placement, true, registers.position);
}

bool BlockRun::program_code() {
  if (words_.has(kMacroCall)) {
    if (!read_macro_call(block_, words_.first_argument(), flow_, alarm)) return false;
    flow_.keep_locals = rules_.settings().keep_arguments;
    return true;
  }
  switch (words_.program_code()) {
    case ProgramCode::none:
      return true;
    case ProgramCode::stop:
      queue_.push<Stop>();
      return true;
    case ProgramCode::end:
      ends_program = true;
      return true;
    case ProgramCode::call:
      return read_subprogram_call(block_, words_, flow_, alarm);
    case ProgramCode::go_back:
      return read_return(block_, words_, flow_, alarm);
  }
  return true;
}

void BlockRun::take_over() {
  if (!words_.collect(block_, registers.modal[Group::distance], rules_.line(), alarm)) return;
  taking_over_ = true;
  take_normal_line_axis();
  registers.feed_given = true;  // that it is missing is said once
  modal();
  take_over_operation();
  if (words_.program_code() == ProgramCode::stop || program_code()) return;
  flow_.kind = FlowRequest::Kind::none;
}

/// The blocks behind are judged as if the move of this one had been right.
void BlockRun::take_over_operation() {
  if (words_.has(kDwell) || words_.has(kMacroCall) || words_.has(Group::polar)) return;
  const bool moves = !words_.has(kLocalSystem) && words_[Group::rotation] != code(68);
  if (moves && !words_.axes().empty()) registers.placement.absolute_wanted = false;
  if (operation() || !moves || words_.has(kMachineMove)) return;
  AxisVector target = registers.position;
  if (targets(target)) arrive(target, words_.axes());
}

}  // namespace kerf::melsec
