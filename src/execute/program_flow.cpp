#include "execute/program_flow.hpp"

#include <cmath>
#include <utility>

namespace kerf {
namespace {

FlowFault fault_of(MathFault fault) {
  switch (fault) {
    case MathFault::zero_divisor:
      return FlowFault::zero_divisor;
    case MathFault::out_of_domain:
      return FlowFault::out_of_domain;
    default:
      return FlowFault::no_variable;
  }
}

const StatementRange& range_of(const std::vector<StatementRange>& ranges, std::int16_t index) {
  return ranges[static_cast<std::size_t>(index)];
}

}  // namespace

ProgramFlow::ProgramFlow(std::shared_ptr<const CompiledProgram> program, ProgramFinder finder,
                         const FlowAlarms& alarms)
    : finder_(std::move(finder)), alarms_(alarms) {
  frames_.push_back().program = std::move(program);
}

ProgramFlow::Result ProgramFlow::next(Block& block, MacroVariables& variables) {
  for (;;) {
    Frame& frame = here();
    if (frame.next >= frame.program->statements.size()) {
      if (!frame.program->refused) return Result::end;
      if (leave_program(variables) == Result::over) return Result::over;
      continue;
    }
    const Statement& statement = frame.program->statements[frame.next];
    if (statement.first_of_block) {
      span_ = statement.span;
      sequence_number_ = statement.sequence_number;
      ++blocks_;
    }
    switch (execute(statement, block, variables)) {
      case Step::on:
        break;
      case Step::block:
        block_given_ = true;
        return Result::block;
      case Step::fault:
        go_behind_fault(statement);
        return Result::fault;
    }
  }
}

/// A loop whose condition cannot be told is passed over, lest its END be judged as well.
void ProgramFlow::go_behind_fault(const Statement& statement) {
  Frame& frame = here();
  const bool loop = statement.kind == StatementKind::while_do && statement.jump != kNoStatement;
  if (loop && range_of(frame.program->loops, statement.loop).closed()) {
    frame.next = statement.jump;
  } else {
    skip_block();
  }
}

ProgramFlow::Result ProgramFlow::leave_program(MacroVariables& variables) {
  if (frames_.size() == 1) return Result::over;
  leave(variables);
  return Result::block;
}

void ProgramFlow::leave(MacroVariables& variables) {
  if (here().macro) variables.leave_level();
  here().program.reset();
  frames_.resize(frames_.size() - 1);
}

void ProgramFlow::skip_block() {
  Frame& frame = here();
  const auto& statements = frame.program->statements;
  do {
    ++frame.next;
  } while (frame.next < statements.size() && !statements[frame.next].first_of_block);
}

ProgramFlow::Step ProgramFlow::execute(const Statement& statement, Block& block, MacroVariables& variables) {
  Frame& frame = here();
  switch (statement.kind) {
    case StatementKind::words:
      return fill(statement, block, variables);
    case StatementKind::lines:
      return read_line(statement, block);
    case StatementKind::assignment:
      return assign(statement, variables);
    case StatementKind::go_to:
      return go_to(statement, variables);
    case StatementKind::if_then:
      return enter_range(statement, variables);
    case StatementKind::else_part:
      leave_ranges(frame.next);
      // Reached from the THEN part; after a jump into the range the IF is without effect.
      frame.next =
          !frame.ranges.empty() && frame.ranges.back() == statement.range ? statement.jump : frame.next + 1;
      return Step::on;
    case StatementKind::while_do:
      return enter_loop(statement, variables);
    case StatementKind::end_do:
      return end_loop(statement);
    case StatementKind::branch:
      return branch(statement, variables);
    case StatementKind::go_back:
      if (frames_.size() > 1) return go_back({}, variables) == Result::block ? Step::on : Step::fault;
      ++frame.next;
      return Step::on;
    case StatementKind::nothing:
      ++frame.next;
      return Step::on;
    case StatementKind::fault:
      fault_ = frame.program->faults[statement.jump];
      return Step::fault;
  }
  return Step::on;
}

ProgramFlow::Step ProgramFlow::fail(FlowFault fault) {
  const FlowAlarm& alarm = alarms_[static_cast<std::size_t>(fault)];
  fault_ = {alarm.kind, span_, alarm.message, alarm.remedy};
  return Step::fault;
}

ProgramFlow::Result ProgramFlow::refuse(FlowFault fault) {
  fail(fault);
  return Result::fault;
}

ProgramFlow::Result ProgramFlow::refuse(FlowFault fault, const SourceSpan& place) {
  fail(fault);
  fault_.span = place;
  return Result::fault;
}

ProgramFlow::Result ProgramFlow::finish() {
  return inside_unclosed_loop() ? refuse(FlowFault::loop_unpaired) : Result::end;
}

std::shared_ptr<const Source> ProgramFlow::source_of(std::int32_t number) const {
  for (const Frame& frame : frames_) {
    if (frame.program->number == number) return frame.program->source;
  }
  const auto found = finder_(number);
  return found == nullptr ? frames_.begin()->program->source : found->source;
}

ProgramFlow::Step ProgramFlow::compute(const ExpressionRef& expression, const MacroVariables& variables,
                                       double& value) {
  const ExpressionStep& first = program().steps[expression.begin];
  if (expression.count == 1 && first.op == ExpressionOp::constant) {
    value = first.operand;
    return Step::on;
  }
  const MathFault fault = evaluate(program().expression(expression), variables, value);
  return fault == MathFault::none ? Step::on : fail(fault_of(fault));
}

ProgramFlow::Step ProgramFlow::evaluate_condition(const ExpressionRef& condition,
                                                  const MacroVariables& variables, bool& holds) {
  double value = 1.0;
  if (condition.count > 0 && compute(condition, variables, value) != Step::on) return Step::fault;
  holds = value != 0.0;
  return Step::on;
}

ProgramFlow::Step ProgramFlow::fill(const Statement& statement, Block& block,
                                    const MacroVariables& variables) {
  const CompiledProgram& text = program();
  block.span = statement.span;
  block.skip_mark = false;
  block.skip_number = statement.skip_number;
  block.words.clear();
  for (std::uint32_t i = 0; i < statement.word_count; ++i) {
    Word& word = block.words.push_back(text.words[statement.first_word + i]);
    if (word.expression < 0) continue;
    const ExpressionRef& value = text.word_values[static_cast<std::size_t>(word.expression)];
    word.is_computed = true;
    if (compute(value, variables, word.computed) != Step::on) return Step::fault;
  }
  ++here().next;
  return Step::block;
}

/// The compiler has seen that the last line has words.
ProgramFlow::Step ProgramFlow::read_line(const Statement& statement, Block& block) {
  Frame& frame = here();
  const std::string_view text = frame.program->source->text();
  const SourceSpan& all = statement.span;
  if (frame.line.line == 0) frame.line = {all.offset, all.offset - (all.column - 1), all.line};
  do {
    read_plain_line(frame.line, text, frame.program->plain_letters, block);
  } while (block.words.empty());
  span_ = block.span;
  sequence_number_ = static_cast<std::int32_t>(block.span.line);
  if (frame.line.at >= all.offset + all.length) {
    frame.line = {};
    ++frame.next;
  }
  return Step::block;
}

ProgramFlow::Step ProgramFlow::assign(const Statement& statement, MacroVariables& variables) {
  double number = 0.0;
  double value = 0.0;
  if (compute(statement.target, variables, number) != Step::on) return Step::fault;
  if (compute(statement.value, variables, value) != Step::on) return Step::fault;
  double* variable = variables.find(number);
  if (variable == nullptr) return fail(FlowFault::no_variable);
  *variable = value;
  ++here().next;
  return Step::on;
}

bool ProgramFlow::count_round() {
  constexpr std::uint32_t kWithBlocks = 10;  // executing a block takes so much longer than a statement
  rounds_ += std::exchange(block_given_, false) ? kWithBlocks : 1;
  return rounds_ <= most_rounds_;
}

ProgramFlow::Step ProgramFlow::jump(StatementIndex target) {
  if (target <= here().next && !count_round()) return fail(FlowFault::endless);
  if (here().next != target) here().line = {};
  here().next = target;
  return Step::on;
}

bool ProgramFlow::may_jump_to(const Frame& frame, StatementIndex target) const {
  const Statement& statement = frame.program->statements[target];
  std::int16_t loop = statement.loop;
  if (loop >= 0 && statement.kind == StatementKind::while_do)
    loop = range_of(frame.program->loops, loop).parent;
  if (loop < 0) return true;
  for (const std::int16_t entered : frame.loops) {
    if (entered == loop) return true;
  }
  return false;
}

ProgramFlow::Step ProgramFlow::go_to(const Statement& statement, const MacroVariables& variables) {
  Frame& frame = here();
  bool holds = false;
  if (evaluate_condition(statement.condition, variables, holds) != Step::on) return Step::fault;
  if (!holds) {
    ++frame.next;
    return Step::on;
  }
  double number = 0.0;
  if (compute(statement.value, variables, number) != Step::on) return Step::fault;
  const double rounded = std::round(number);
  StatementIndex target = kNoStatement;
  if (rounded >= 1.0 && rounded <= 1e9) {
    target = frame.program->find_label(static_cast<std::int32_t>(rounded), frame.next);
  }
  if (target == kNoStatement) return fail(FlowFault::no_sequence_number);
  leave_loops(frame, frame.next);
  if (!may_jump_to(frame, target)) return fail(FlowFault::jump_into_loop);
  return jump(target);
}

ProgramFlow::Step ProgramFlow::branch(const Statement& statement, const MacroVariables& variables) {
  bool holds = false;
  if (statement.condition.count > 0 && evaluate_condition(statement.condition, variables, holds) != Step::on)
    return Step::fault;
  if (!holds) return jump(statement.jump);
  ++here().next;
  return Step::on;
}

void ProgramFlow::leave_ranges(StatementIndex statement) {
  Frame& frame = here();
  while (!frame.ranges.empty() && !range_of(frame.program->ranges, frame.ranges.back()).contains(statement)) {
    frame.ranges.resize(frame.ranges.size() - 1);
  }
}

void ProgramFlow::leave_loops(Frame& frame, StatementIndex statement) {
  while (!frame.loops.empty() && !range_of(frame.program->loops, frame.loops.back()).contains(statement)) {
    frame.loops.resize(frame.loops.size() - 1);
  }
}

ProgramFlow::Step ProgramFlow::enter_range(const Statement& statement, const MacroVariables& variables) {
  Frame& frame = here();
  leave_ranges(frame.next);
  // The place may be reached again without its range having been left: a loop inside the range's own text.
  if (!frame.ranges.empty() && frame.ranges.back() == statement.range)
    frame.ranges.resize(frame.ranges.size() - 1);
  if (frame.ranges.full()) return fail(FlowFault::if_depth);
  bool holds = false;
  if (evaluate_condition(statement.condition, variables, holds) != Step::on) return Step::fault;
  frame.ranges.push_back(statement.range);
  frame.next = holds ? frame.next + 1 : statement.jump;
  return Step::on;
}

std::size_t ProgramFlow::loop_depth() const {
  std::size_t depth = 0;
  for (const Frame& frame : frames_) depth += frame.loops.size();
  return depth;
}

ProgramFlow::Step ProgramFlow::enter_loop(const Statement& statement, const MacroVariables& variables) {
  Frame& frame = here();
  leave_loops(frame, frame.next);
  const bool again = !frame.loops.empty() && frame.loops.back() == statement.loop;
  if (!again && loop_depth() >= kLoops) return fail(FlowFault::loop_depth);
  bool holds = false;
  if (evaluate_condition(statement.condition, variables, holds) != Step::on) return Step::fault;
  if (!holds && !range_of(frame.program->loops, statement.loop).closed())
    return fail(FlowFault::loop_unpaired);
  if (!again) frame.loops.push_back(statement.loop);
  frame.next = holds ? frame.next + 1 : statement.jump;
  return Step::on;
}

ProgramFlow::Step ProgramFlow::end_loop(const Statement& statement) {
  Frame& frame = here();
  leave_loops(frame, frame.next);
  if (frame.loops.empty() || frame.loops.back() != statement.loop) return fail(FlowFault::loop_unpaired);
  return jump(statement.jump);
}

bool ProgramFlow::inside_unclosed_loop() const {
  const Frame& frame = frames_.back();
  for (const std::int16_t loop : frame.loops) {
    if (!range_of(frame.program->loops, loop).closed()) return true;
  }
  return false;
}

ProgramFlow::Result ProgramFlow::carry_out(const FlowRequest& request, MacroVariables& variables) {
  return request.kind == FlowRequest::Kind::go_back ? go_back(request, variables) : call(request, variables);
}

ProgramFlow::Result ProgramFlow::call(const FlowRequest& request, MacroVariables& variables) {
  const bool macro = request.kind == FlowRequest::Kind::macro_call;
  if (request.repetitions <= 0) return Result::block;
  if (!count_round()) return refuse(FlowFault::endless);
  if (macro && variables.level() + 1 >= variables.levels())
    return refuse(FlowFault::macro_depth, request.place);
  if (frames_.full()) return refuse(FlowFault::call_depth, request.place);
  auto called =
      request.program < 0 || request.program == program().number ? here().program : finder_(request.program);
  if (called == nullptr) return refuse(FlowFault::no_program, request.place);
  StatementIndex entry = 0;
  if (request.sequence_number > 0 && !called->refused) {
    entry = called->find_first(request.sequence_number);
    if (entry == kNoStatement) return refuse(FlowFault::no_sequence_number, request.place);
  }
  if (macro) {
    if (request.given != 0 && !variables.has_locals()) return refuse(FlowFault::no_variable);
    variables.enter_level(request.arguments, request.given, request.keep_locals);
  }
  here().call = here().next - 1;
  Frame& frame = frames_.push_back();
  frame = Frame{};
  frame.program = std::move(called);
  frame.next = frame.entry = entry;
  frame.repetitions_left = request.repetitions - 1;
  frame.macro = macro;
  frame.renews_locals = request.renews_locals;
  return Result::block;
}

ProgramFlow::Result ProgramFlow::repeat(MacroVariables& variables) {
  if (!count_round()) return refuse(FlowFault::endless);
  Frame& frame = here();
  --frame.repetitions_left;
  frame.next = frame.entry;
  frame.line = {};
  if (frame.renews_locals) variables.clear_level();
  return Result::block;
}

ProgramFlow::Result ProgramFlow::go_back(const FlowRequest& request, MacroVariables& variables) {
  if (inside_unclosed_loop()) return refuse(FlowFault::loop_unpaired);
  Frame& frame = here();
  frame.loops.clear();
  frame.ranges.clear();
  if (frame.repetitions_left > 0) return repeat(variables);
  const bool main = frames_.size() == 1;
  Frame& target_frame = main ? frame : frames_[frames_.size() - 2];
  StatementIndex target = main ? 0 : target_frame.next;
  if (request.sequence_number > 0) {
    target = target_frame.program->find_label(request.sequence_number, target_frame.call);
    if (target == kNoStatement) return refuse(FlowFault::no_sequence_number, request.place);
    leave_loops(target_frame, target_frame.call);
    if (!may_jump_to(target_frame, target)) return refuse(FlowFault::jump_into_loop, request.place);
  }
  if (main && target <= frame.next && ++restarts_ > most_restarts_) return Result::over;
  if (!main) {
    leave(variables);
  }
  return jump(target) == Step::on ? Result::block : Result::fault;
}

}  // namespace kerf
