#include "dialect/dgshape/block_run.hpp"

#include <cmath>

#include "dialect/dgshape/alarms.hpp"
#include "execute/grid.hpp"
#include "execute/moves.hpp"

namespace kerf::dgshape {
namespace {

/// Scaled destinations are rounded to the machine's least increment (DGS-396).
double to_least_increment(double value) {
  return std::round(value * 1e4) / 1e4;
}

}  // namespace

BlockRun::BlockRun(const Rules& rules, const Block& block, State& state, ActionQueue& queue)
    : registers(state.registers),
      rules_(rules),
      settings_(rules.settings()),
      block_(block),
      tables_(state.tables),
      queue_(queue),
      reader_(rules.settings(), false) {
  update_origin();
}

bool BlockRun::run() {
  if (!words_.collect(block_, rules_.codes(), alarm)) return false;
  // The unit of the block counts for all its words, also for those that act before the G codes.
  const CodeNumber unit = words_.has(Group::unit) ? words_[Group::unit] : registers.modal[Group::unit];
  reader_ = NumberReader(settings_, unit == code(20));
  offset_was_on_ = offset_on();
  return numbers() && stand_alone() && feed() && spindle() && auxiliary() && modal() && operation() &&
         every_word_used();
}

bool BlockRun::refuse(std::string_view detail, const SourceSpan& where, const FixedText<200>& message,
                      const FixedText<200>& remedy) {
  alarm = Alarm{&alarm_kind(detail), where, message, remedy};
  return false;
}

void BlockRun::warn(std::string_view detail, const SourceSpan& where) {
  queue_.push<Alarm>() = {&alarm_kind(detail), where, {}, {}};
}

bool BlockRun::numbers() {
  if (words_.has('N')) {
    const Word& word = words_.word('N');
    const NumberResult number = NumberReader::integer(word);
    if (&word != &words_.at(0)) {
      return refuse("sequence-number", span('N'), "N must be the first word of the block.");
    }
    if (number.fault != NumberFault::none || number.value < (settings_.strict ? 1.0 : 0.0)) {
      return refuse("sequence-number", span('N'));
    }
    registers.sequence_number = static_cast<std::int32_t>(number.value);
    use("N");
  }
  if (words_.has('O')) {
    const NumberResult number = NumberReader::integer(words_.word('O'));
    if (block_.words.size() != 1) {
      return refuse("program-number", span('O'), "O must be alone in its block.");
    }
    if (number.fault != NumberFault::none || number.value < (settings_.strict ? 1.0 : 0.0)) {
      return refuse("program-number", span('O'));
    }
    if (registers.program >= 0) {
      return refuse("second-program-number", span('O'),
                    FixedText<200>::format("The program already has the number O{}.", registers.program));
    }
    registers.program = static_cast<std::int32_t>(number.value);
    use("O");
  }
  Origin origin = queue_.origin();
  origin.program = registers.program;
  origin.sequence_number = registers.sequence_number;
  queue_.begin(origin);
  return true;
}

bool BlockRun::stand_alone() {
  const std::size_t others = words_.has('N') ? 2 : 1;
  for (std::uint8_t i : words_.m_words()) {
    const Word& word = words_.at(i);
    const auto number = word.number.digits;
    const bool alone = number <= 2 || number == 30;
    if (alone && block_.words.size() > others) {
      return refuse("stands-alone", span_of(block_, word),
                    FixedText<200>::format("M{:02} must be alone in its block.", number));
    }
  }
  return true;
}

bool BlockRun::operation() {
  if (words_.has(Group::one_shot)) return one_shot();
  if (registers.modal[Group::fixed_cycle] != code(80)) return length_move() && fixed_cycle();
  return motion();
}

bool BlockRun::every_word_used() {
  const WordMask unused = words_.present() & ~used_;
  if (unused == 0) return true;
  for (const Word& word : block_.words) {
    if (word.address == 'G' || word.address == 'M' || (unused & mask(word.address)) == 0) continue;
    return refuse("unused-word", span_of(block_, word),
                  FixedText<200>::format("No code in force in this block takes a word {}.", word.address));
  }
  return true;
}

bool BlockRun::accept(char address, const NumberResult& result, double& value) {
  value = result.value;
  switch (result.fault) {
    case NumberFault::none:
      return true;
    case NumberFault::range:
      return refuse("value-range", span(address));
    case NumberFault::decimal_point:
      return refuse("decimal-point", span(address));
  }
  return true;
}

bool BlockRun::read_distance(char address, double& value) {
  use({&address, 1});
  return accept(address, reader_.distance(words_.word(address)), value);
}

bool BlockRun::read_integer(char address, double& value) {
  use({&address, 1});
  return accept(address, NumberReader::integer(words_.word(address)), value);
}

bool BlockRun::axis_value(Axis axis, double& value) {
  const char address = letter(axis);
  if (axis != Axis::A) return read_distance(address, value);
  if (!settings_.rotary_unit) return refuse("no-rotary-unit", span('A'));
  if (!rules_.machine().axes.contains(Axis::A)) {
    return refuse("no-rotary-unit", span('A'), "The machine file has no axis A.",
                  "Delete the A word, or add an [axes.A] table to the machine file.");
  }
  use("A");
  return accept(address, reader_.angle(words_.word(address)), value);
}

double BlockRun::scaled_length(double value) const {
  return scaled() ? value * registers.scaling.factor : value;
}

double BlockRun::absolute_destination(Axis axis, double value) const {
  if (scaled() && axis != Axis::A) {
    const double reference = registers.scaling.reference[axis];
    value = to_least_increment(reference + registers.scaling.factor * (value - reference));
  }
  return on_grid(origin_[axis] + value);
}

double BlockRun::destination(Axis axis, double value) const {
  if (!incremental()) return absolute_destination(axis, value);
  // Increments are not rounded to the least increment: a thousand of them would miss their sum.
  return on_grid(registers.position[axis] + (axis == Axis::A ? value : scaled_length(value)));
}

bool BlockRun::target_of_words(std::string_view axes, AxisVector& target) {
  for (char address : axes) {
    if (!words_.has(address)) continue;
    const Axis axis = *axis_from_letter(address);
    double value = 0.0;
    if (!axis_value(axis, value)) return false;
    target[axis] = destination(axis, value);
  }
  return true;
}

void BlockRun::update_origin() {
  origin_ = workpiece_origin(registers, tables_);
}

bool BlockRun::check_travel(const Move& move) {
  // Where radius compensation moves the tool only the toolpath knows, and it checks the travel then.
  if (offset_on() || registers.offset_return_pending || settings_.clip_over_travel) return true;
  const Travel& travel = rules_.travel();
  // An axis that is outside, where only an alarm before can have left it, is not complained of again.
  if (travel.contains(move)) return true;
  const auto excess = travel.leaving(move);
  return !excess || refuse_travel(*excess);
}

bool BlockRun::refuse_travel(const Excess& excess) {
  const char address = letter(excess.axis);
  return refuse("over-travel", words_.has(address) ? span(address) : block_.span,
                rules_.travel().message_for(excess));
}

bool BlockRun::push_move(MoveMode mode, const AxisVector& target, const Plane& plane, const Arc& arc) {
  Move& move = push_straight(mode, target, registers, origin_, queue_);
  move.plane = plane;
  move.arc = arc;
  if (words_[Group::one_shot] == code(53)) move.commanded = move.end;  // written in machine coordinates
  registers.unit_locked = true;
  if (!check_travel(move)) return false;
  move.axis_words = words_.has('X') || words_.has('Y');
  if (offset_on()) {
    const bool left = registers.modal[Group::radius_compensation] == code(41);
    move.compensation.side = left ? Side::left : Side::right;
    move.compensation.amount = registers.radius_amount;
    move.compensation.start = registers.radius_start;
  } else if (move.axis_words) {
    registers.offset_return_pending = false;
  }
  return true;
}

}  // namespace kerf::dgshape
