#include "execute/interpreter.hpp"

#include <utility>

namespace kerf {

Interpreter::Interpreter(std::shared_ptr<const BlockRules> rules, std::shared_ptr<const Source> source,
                         InterpreterOptions options)
    : rules_(std::move(rules)),
      reader_(std::move(source)),
      options_(options),
      state_(rules_->initial_state()) {
  rules_->begin_program(state_);
}

void Interpreter::load(std::shared_ptr<const Source> source, const AxisVector& position) {
  reader_ = BlockReader(std::move(source));
  queue_.clear();
  cycle_ = {};
  blocks_ = 0;
  finished_ = stopped_ = refused_ = false;
  state_.registers.position = position;
  state_.registers.length_offset = state_.registers.length_applied = 0.0;
  rules_->begin_program(state_);
}

const Action* Interpreter::next() {
  for (;;) {
    if (!queue_.empty()) {
      const Action& action = queue_.pop();
      const auto* alarm = std::get_if<Alarm>(&action.what);
      if (alarm != nullptr && alarm->kind->severity == Severity::alarm) stopped_ = true;
      return &action;
    }
    if (stopped_) return nullptr;
    if (cycle_.running()) {
      cycle_.step(state_.registers, rules_->work_origin(state_), queue_);
    } else if (finished_) {
      return nullptr;
    } else {
      read_block();
    }
  }
}

void Interpreter::recover() {
  if (!stopped_) return;
  stopped_ = false;
  if (!refused_ || !queue_.empty()) return;
  refused_ = false;
  queue_.begin(queue_.origin());
  rules_->take_over(block_, state_, queue_);
}

void Interpreter::read_block() {
  const Registers& registers = state_.registers;
  BlockOutcome outcome = BlockOutcome::done;
  refused_ = false;
  switch (reader_.next(block_, options_.block_skip)) {
    case BlockReader::Result::block:
      queue_.begin({block_.span, ++blocks_, registers.program, registers.sequence_number});
      outcome = rules_->execute(block_, state_, queue_, cycle_);
      finished_ = outcome == BlockOutcome::ended;
      refused_ = outcome == BlockOutcome::alarm;
      break;
    case BlockReader::Result::fault:
      queue_.begin({reader_.fault_span(), blocks_, registers.program, registers.sequence_number});
      queue_.push<Alarm>() = rules_->syntax_alarm(reader_.fault(), reader_.fault_span());
      // A text that never starts has no end to miss either.
      finished_ = reader_.fault() == SyntaxFault::no_data_start;
      break;
    case BlockReader::Result::end:
      // The block is the last line that was read: the closing % or the last one of a text that just ends.
      queue_.begin({block_.span, blocks_, registers.program, registers.sequence_number});
      rules_->end_of_data(state_, queue_);
      finished_ = true;
      break;
  }
}

}  // namespace kerf
