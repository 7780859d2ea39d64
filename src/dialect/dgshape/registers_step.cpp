// F, S and M words: what acts at the start of the block.

#include <algorithm>

#include "dialect/dgshape/block_run.hpp"
#include "dialect/dgshape/spindle_codes.hpp"
#include "execute/moves.hpp"

namespace kerf::dgshape {
namespace {

constexpr double kLowestRpm = 100.0;  // smaller values are numerical codes (manual 2-4)

double register_rpm(const ControllerSettings& settings, double value) {
  if (value >= kLowestRpm) return value;
  if (value <= 0.0) return settings.spindle_min;
  if (value >= 99.0) return settings.spindle_max;
  return spindle_code_rpm(static_cast<int>(value));
}

}  // namespace

bool BlockRun::feed() {
  if (!words_.has('F')) return true;
  use("F");
  double value = 0.0;
  if (!accept('F', reader_.feed(words_.word('F')), value)) return false;
  if (value < 0.0 && settings_.strict) return refuse("feed-range", span('F'));
  registers.feed = value;
  registers.feed_given = true;
  return true;
}

void BlockRun::emit_spindle() {
  queue_.push<Spindle>() = {SpindleDirection::clockwise, effective_rpm(settings_, registers.spindle_rpm),
                            settings_.spindle_delay_s};
}

bool BlockRun::spindle() {
  if (!words_.has('S')) return true;
  double value = 0.0;
  if (!read_integer('S', value)) return false;
  if (value < 0.0 && settings_.strict) return refuse("spindle-range", span('S'));
  const double before = effective_rpm(settings_, registers.spindle_rpm);
  registers.spindle_rpm = register_rpm(settings_, value);
  const bool changed = effective_rpm(settings_, registers.spindle_rpm) != before;
  if (registers.spindle_on && changed) emit_spindle();
  return true;
}

bool BlockRun::switch_function(const Word& word, bool fitted, unsigned bit, bool on, std::string_view key) {
  if (!fitted) {
    warn("no-equipment", span_of(block_, word));
    std::get<Alarm>(queue_.last().what).remedy =
        FixedText<200>::format("Delete the word, or set dgshape.{} = true.", key);
    return true;
  }
  registers.outputs = on ? registers.outputs | bit : registers.outputs & ~bit;
  queue_.push<Auxiliary>().code = static_cast<std::int32_t>(word.number.digits);
  return true;
}

bool BlockRun::auxiliary() {
  bool tool_selected = false;
  for (std::uint8_t i : words_.m_words()) {
    const Word& word = words_.at(i);
    bool good = true;
    switch (word.number.digits) {
      case 0:
        queue_.push<Stop>().optional = false;
        break;
      case 1:
        if (settings_.optional_stop) queue_.push<Stop>().optional = true;
        break;
      case 2:
      case 30:
        ends_program = true;
        break;
      case 3:
        if (!registers.spindle_on) emit_spindle();
        registers.spindle_on = true;
        break;
      case 5:
        if (registers.spindle_on) queue_.push<Spindle>();
        registers.spindle_on = false;
        break;
      case 6:
        good = !tool_selected
                   ? tool_change(word)
                   : refuse("tool-word", span_of(block_, word), "Only one M06 may stand in a block.");
        tool_selected = true;
        break;
      case 12:
      case 13:
        good = switch_function(word, settings_.air_blower, kBlowerOutput, word.number.digits == 12,
                               "air_blower");
        break;
      case 14:
      case 15:
        good = switch_function(word, settings_.chip_cleaner, kCleanerOutput, word.number.digits == 14,
                               "chip_cleaner");
        break;
      case 16:
      case 17:
        good = switch_function(word, settings_.light, kLightOutput, word.number.digits == 16, "light");
        break;
      default:
        break;
    }
    if (!good) return false;
  }
  if (words_.has('T') && !tool_selected) {
    return refuse("tool-word", span('T'), "T is allowed only together with M06.");
  }
  return true;
}

bool BlockRun::tool_change(const Word& word) {
  if (!settings_.tool_changer) return refuse("no-tool-changer", span_of(block_, word));
  if (!words_.has('T')) return refuse("tool-word", span_of(block_, word), "M06 needs the stocker number T.");
  double number = 0.0;
  if (!read_integer('T', number)) return false;
  if (number < 0.0 || number > static_cast<double>(settings_.stockers)) {
    return refuse("tool-number", span('T'),
                  FixedText<200>::format("The magazine has stockers 1 to {}.", settings_.stockers));
  }
  const auto tool = static_cast<std::int32_t>(number);
  if (tool == registers.tool) return true;  // held already, or nothing to put back: ignored (manual M06)
  // The tool rises to the top before the change (manual M06). The top is the reference point of Z.
  const double top = rules_.machine()[Axis::Z].home - registers.length_applied;
  if (settings_.tool_change_retract && registers.position[Axis::Z] < top) {
    AxisVector target = registers.position;
    target[Axis::Z] = top;
    const double commanded_length = registers.length_offset;
    registers.length_offset = registers.length_applied;
    if (!push_move(MoveMode::rapid, target)) return false;
    last_move().axis_words = false;
    registers.length_offset = commanded_length;
  }
  queue_.push<ToolChange>() = {tool, settings_.tool_change_s};
  registers.tool = tool;
  return true;
}

}  // namespace kerf::dgshape
