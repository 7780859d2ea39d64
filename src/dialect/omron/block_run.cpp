#include "dialect/omron/block_run.hpp"

#include <algorithm>
#include <cmath>

#include "dialect/omron/addresses.hpp"
#include "dialect/omron/alarms.hpp"

namespace kerf::omron {

BlockRun::BlockRun(const Rules& rules, const Block& block, State& state, ActionQueue& queue,
                   FlowRequest& flow)
    : registers(state.registers),
      rules_(rules),
      settings_(rules.settings()),
      block_(block),
      tables_(state.tables),
      level_(state.variables.level()),
      queue_(queue),
      flow_(flow) {}

bool BlockRun::run() {
  if (is_skipped()) return true;
  if (!collect()) return false;
  const bool done = cycle_allowed() && modal() && ramps() && feed() && spindle_speed() && early_m_code() &&
                    operation() && m_code() && every_word_used();
  // In continuous-path mode a block without a movement is a stop, unless blocks are planned together.
  const bool together = registers.modal[Group::multi_block] == code(500);
  if (!moved_ && !block_.words.empty() && !together) registers.placement.rest_wanted = true;
  return done;
}

void BlockRun::take_over() {
  if (is_skipped() || !collect()) return;
  taking_over_ = true;
  registers.feed_given = true;  // that it is missing is said once
  modal();
  feed();
  if (!words_.has(Group::one_shot)) operation();
  const std::int32_t number = words_.m_code();
  if (number == 2 || number == 30 || number == 98 || number == 99) m_code();
}

/// The unit of the block counts for all of its words.
bool BlockRun::collect() {
  if (!words_.collect(block_, alarm)) return false;
  const CodeNumber unit = words_.has(Group::unit) ? words_[Group::unit] : registers.modal[Group::unit];
  unit_mm_ = millimetres_of(unit);
  in_cycle_ = registers.modal[Group::fixed_cycle] != code(80);
  return true;
}

/// The signals are looked at when the block is interpreted.
bool BlockRun::is_skipped() const {
  return block_.skip_number > 0 && settings_.skips.test(block_.skip_number);
}

bool BlockRun::ramps() {
  constexpr double kLongest = 250000.0;
  constexpr double kLongestJerk = 125000.0;
  const Word* up = take(kAccelerationTime);
  const Word* down = take(kDecelerationTime);
  const Word* jerk = take(kJerkTime);
  return (up == nullptr || value(*up, 0.0, kLongest, registers.ramps.acceleration)) &&
         (down == nullptr || value(*down, 0.0, kLongest, registers.ramps.deceleration)) &&
         (jerk == nullptr || value(*jerk, 0.0, kLongestJerk, registers.ramps.jerk));
}

bool BlockRun::feed() {
  if (words_[Group::one_shot] == code(4)) return true;  // F is its time
  const Word* word = take('F');
  if (word == nullptr) return true;
  // The greatest feedrate keeps its number when the unit changes (manual G20, G21).
  constexpr double kLeast = 1e-8;
  const double greatest =
      std::max(settings_.normal.maximum_feedrate, settings_.operation(registers.rates).maximum_feedrate);
  if (!(word->computed >= kLeast && word->computed <= greatest)) return refuse("feed-range", span(*word));
  registers.feed = word->computed * unit_mm_;
  registers.feed_given = true;
  return true;
}

bool BlockRun::spindle_speed() {
  const Word* word = take('S');
  if (word == nullptr) return true;
  if (!value(*word, 0.0, settings_.spindle_maximum, registers.spindle_rpm)) return false;
  const std::int32_t number = words_.m_code();
  const bool commanded = number == 3 || number == 4 || number == 5 || number == 19;
  if (registers.spindle_on && !commanded)
    turn_spindle(registers.outputs == kTurnsBack ? SpindleDirection::counterclockwise
                                                 : SpindleDirection::clockwise);
  return true;
}

bool BlockRun::operation() {
  if (words_.has(Group::one_shot)) return one_shot();
  const bool mirrors =
      words_[Group::mirror] == code(51, 1) || (words_.has(Group::mirror) && !words_.has(Group::motion));
  if (words_[Group::scaling] == code(51) || mirrors || words_[Group::rotation] == code(68))
    return true;  // its words are those of the code
  if (registers.modal[Group::fixed_cycle] != code(80)) return fixed_cycle();
  return motion();
}

bool BlockRun::one_shot() {
  switch (words_[Group::one_shot]) {
    case code(4):
      return dwell();
    case code(28):
    case code(30):
      return reference_return();
    case code(31):
      return skip_move();
    case code(52):
      return local_system();
    default:
      return machine_move();
  }
}

bool BlockRun::dwell() {
  constexpr double kLongest_s = 100000.0;
  const Word* f = take('F');
  const Word* x = take('X');
  const Word* p = words_.m_code() == 98 ? nullptr : take('P');
  const int given = (f != nullptr ? 1 : 0) + (x != nullptr ? 1 : 0) + (p != nullptr ? 1 : 0);
  if (given > 1) return refuse("dwell-words", block_.span);
  double seconds = 0.0;
  if (p != nullptr) {
    if (!value(*p, 0.0, kLongest_s * 1000.0, seconds)) return false;
    seconds /= 1000.0;
  } else if (given == 1 && !value(f != nullptr ? *f : *x, 0.0, kLongest_s, seconds)) {
    return false;
  }
  if (!taking_over_) queue_.push<Dwell>().seconds = seconds;
  return true;
}

bool BlockRun::every_word_used() {
  for (const Word& word : block_.words) {
    if (word.address == 'G' || word.address == 'M' || used_.test(place_of(word.address))) continue;
    if (kArguments.find(word.address) != std::string_view::npos) return refuse("m-code-words", span(word));
    return refuse(
        "unused-word", span(word),
        FixedText<200>::format("No code in force in this block takes a word {}.", spelling(word.address)));
  }
  return true;
}

const Word* BlockRun::take(char address) {
  use(address);
  return words_.find(address);
}

bool BlockRun::value(const Word& word, double least, double greatest, double& value) {
  use(word.address);
  if (!(word.computed >= least && word.computed <= greatest))
    return refuse("value-range", span(word),
                  FixedText<200>::format("{} may be from {:.12g} to {:.12g}; here it is {:.12g}.",
                                         spelling(word.address), least, greatest, word.computed));
  value = word.computed;
  return true;
}

bool BlockRun::integer(const Word& word, int least, int greatest, std::int32_t& value) {
  double number = 0.0;
  if (!this->value(word, least, greatest, number)) return false;
  if (number != std::trunc(number))
    return refuse("value-range", span(word),
                  FixedText<200>::format("{} is an integer.", spelling(word.address)));
  value = static_cast<std::int32_t>(number);
  return true;
}

bool BlockRun::distance(const Word& word, double& mm) {
  constexpr double kFarthest = 1'000'000.0;
  if (!value(word, -kFarthest, kFarthest, mm)) return false;
  mm *= unit_mm_;
  return true;
}

bool BlockRun::axis_value(Axis axis, double& value) {
  const Word& word = words_.axis(axis);
  if (!rules_.machine().axes.contains(axis)) return refuse("no-axis", span(word));
  if (!distance(word, value)) return false;
  if (rules_.machine()[axis].type == AxisType::rotary) value = word.computed;  // degrees in any unit
  return true;
}

bool BlockRun::refuse(std::string_view detail, const SourceSpan& where, const FixedText<200>& message) {
  alarm = Alarm{&alarm_kind(detail), where, message, {}};
  return false;
}

}  // namespace kerf::omron
