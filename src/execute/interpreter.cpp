#include "execute/interpreter.hpp"

#include <utility>

namespace kerf {

Interpreter::Interpreter(std::shared_ptr<const BlockRules> rules, std::shared_ptr<const Source> source,
                         InterpreterOptions options)
    : rules_(std::move(rules)),
      feed_(rules_->open(std::move(source), options.programs)),
      options_(std::move(options)),
      state_(rules_->initial_state()) {
  limit_rounds();
  rules_->begin_program(state_);
}

void Interpreter::limit_rounds() {
  if (auto* flow = std::get_if<ProgramFlow>(&feed_))
    flow->limit(options_.most_rounds, options_.most_restarts);
}

void Interpreter::load(std::shared_ptr<const Source> source, const AxisVector& position) {
  feed_ = rules_->open(std::move(source), options_.programs);
  limit_rounds();
  queue_.clear();
  effects_ = {};
  blocks_ = 0;
  finished_ = stopped_ = refused_ = behind_alarm_ = return_refused_ = false;
  state_.registers.position = position;
  state_.registers.length_offset = state_.registers.length_applied = 0.0;
  rules_->begin_program(state_);
}

std::shared_ptr<const Source> Interpreter::source_of(std::int32_t program) const {
  if (const auto* flow = std::get_if<ProgramFlow>(&feed_)) return flow->source_of(program);
  return std::get<BlockReader>(feed_).source();
}

const Action* Interpreter::next() {
  for (;;) {
    if (!queue_.empty()) {
      const Action& action = queue_.pop();
      if (stops_program(action)) stopped_ = true;
      return &action;
    }
    if (stopped_) return nullptr;
    if (effects_.cycle.running()) {
      effects_.cycle.step(state_.registers, rules_->work_origin(state_), queue_);
    } else if (effects_.tapping.running()) {
      effects_.tapping.step(queue_);
    } else if (finished_) {
      return nullptr;
    } else if (auto* reader = std::get_if<BlockReader>(&feed_)) {
      read_block(*reader);
    } else {
      read_block(std::get<ProgramFlow>(feed_));
    }
  }
}

void Interpreter::recover() {
  if (!stopped_) return;
  stopped_ = false;
  behind_alarm_ = true;
  if (std::exchange(return_refused_, false)) {
    auto& flow = std::get<ProgramFlow>(feed_);
    finished_ = flow.leave_program(state_.variables) == ProgramFlow::Result::over;
  }
  if (!refused_ || !queue_.empty()) return;
  refused_ = false;
  queue_.begin(queue_.origin());
  finished_ = rules_->take_over(block_, state_, queue_, effects_) == BlockOutcome::ended;
}

void Interpreter::execute_block() {
  behind_alarm_ = false;
  const Registers& registers = state_.registers;
  queue_.begin({block_.span, blocks_, registers.program, registers.sequence_number});
  const BlockOutcome outcome = rules_->execute(block_, state_, queue_, effects_);
  finished_ = outcome == BlockOutcome::ended;
  refused_ = outcome == BlockOutcome::alarm;
}

void Interpreter::reach_end(const SourceSpan& place) {
  queue_.begin({place, blocks_, state_.registers.program, state_.registers.sequence_number});
  rules_->end_of_data(state_, queue_);
  finished_ = true;
}

void Interpreter::read_block(BlockReader& reader) {
  refused_ = false;
  switch (reader.next(block_, options_.block_skip)) {
    case BlockReader::Result::block:
      ++blocks_;
      execute_block();
      break;
    case BlockReader::Result::fault:
      queue_.begin(
          {reader.fault_span(), blocks_, state_.registers.program, state_.registers.sequence_number});
      queue_.push<Alarm>() = rules_->syntax_alarm(reader.fault(), reader.fault_span());
      // A text that never starts has no end to miss either.
      finished_ = reader.fault() == SyntaxFault::no_data_start;
      break;
    case BlockReader::Result::end:
      // The block is the last line that was read: the closing % or the last one of a text that just ends.
      reach_end(block_.span);
      break;
  }
}

void Interpreter::read_block(ProgramFlow& flow) {
  refused_ = false;
  ProgramFlow::Result result = next_block(flow);
  if (result == ProgramFlow::Result::end && behind_alarm_) {
    // The refused block may have been the one that ends the program: to miss that too would be a false alarm.
    result = flow.leave_program(state_.variables);
    if (result == ProgramFlow::Result::block) return;
  }
  blocks_ = flow.blocks();
  Registers& registers = state_.registers;
  registers.program = flow.program().number;
  if (flow.sequence_number() >= 0) registers.sequence_number = flow.sequence_number();
  if (result == ProgramFlow::Result::end) reach_end(flow.span());
  if (result == ProgramFlow::Result::over) finished_ = true;
  if (result == ProgramFlow::Result::block) {
    execute_block();
    if (finished_) result = flow.finish();
  }
  if (result != ProgramFlow::Result::fault) return;
  // What a block gave that ends the program inside an open loop goes back: the alarm is all there is.
  queue_.roll_back();
  queue_.begin({flow.span(), blocks_, registers.program, registers.sequence_number});
  queue_.push<Alarm>() = alarm_from(flow.fault());
}

ProgramFlow::Result Interpreter::next_block(ProgramFlow& flow) {
  FlowRequest& request = effects_.flow;
  if (request.kind != FlowRequest::Kind::none) {
    const ProgramFlow::Result result = flow.carry_out(request, state_.variables);
    const bool leaves = request.kind == FlowRequest::Kind::go_back;
    return_refused_ = leaves && result == ProgramFlow::Result::fault;
    request.kind = FlowRequest::Kind::none;
    if (result != ProgramFlow::Result::block) return result;
  }
  return flow.next(block_, state_.variables);
}

}  // namespace kerf
