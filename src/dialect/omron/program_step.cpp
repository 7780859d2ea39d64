// M codes (manual chapter 3): what they tell the machine, and the way through the programs.

#include <algorithm>
#include <array>
#include <optional>

#include "dialect/omron/addresses.hpp"
#include "dialect/omron/block_run.hpp"
#include "dialect/omron/variables.hpp"

namespace kerf::omron {
namespace {

constexpr std::int32_t kFirstSubprogram = 1000;
constexpr std::int32_t kLastSubprogram = 9999;

/// All codes but those that steer the program are put out to the machine, those of the spindle too.
bool is_put_out(std::int32_t number) {
  constexpr std::array kSteering{0, 1, 2, 30, 98, 99};
  return std::find(kSteering.begin(), kSteering.end(), number) == kSteering.end();
}

std::optional<SpindleDirection> spindle_code(std::int32_t number) {
  switch (number) {
    case 3:
      return SpindleDirection::clockwise;
    case 4:
      return SpindleDirection::counterclockwise;
    case 5:
      return SpindleDirection::off;
    case 19:
      return SpindleDirection::orient;
    default:
      return std::nullopt;
  }
}

}  // namespace

/// Output timing 1: when the block is interpreted, in front of its move; timing 2: with the move.
bool BlockRun::early_m_code() {
  const std::int32_t number = words_.m_code();
  if (number < 0 || !is_put_out(number) || m_timing() == OutputTiming::synchronous) return true;
  return output();
}

/// An M code with arguments waits for the end of the movement and for its reset, whatever its setting is.
OutputTiming BlockRun::m_timing() const {
  const auto given = [this](char address) { return words_.find(address) != nullptr; };
  if (std::any_of(kArguments.begin(), kArguments.end(), given)) return OutputTiming::synchronous;
  return settings_.timing[static_cast<std::size_t>(words_.m_code())];
}

bool BlockRun::m_code() {
  const std::int32_t number = words_.m_code();
  if (number < 0) return true;
  if (!compensation_allows_m_code()) return false;
  switch (number) {
    case 0:
      queue_.push<Stop>();
      return true;
    case 1:
      if (settings_.optional_stop) queue_.push<Stop>().optional = true;
      return true;
    case 2:
    case 30:
      ends_program = true;
      return true;
    case 98:
      return call_program();
    case 99:
      go_back();
      return true;
    default:
      break;
  }
  return m_timing() != OutputTiming::synchronous || output();
}

bool BlockRun::output() {
  Auxiliary auxiliary;
  auxiliary.code = words_.m_code();
  auxiliary.timing = m_timing();
  auxiliary.arguments = m_arguments();
  if (const auto direction = spindle_code(auxiliary.code)) {
    turn_spindle(*direction, auxiliary.timing, auxiliary.arguments);
    return true;
  }
  if (auxiliary.code == settings_.tool_m_code && (auxiliary.arguments.given & 1U) != 0) {
    constexpr int kMostTools = 9999;
    if (!integer(*words_.find(kArguments[0]), 0, kMostTools, registers.tool)) return false;
  }
  if (!taking_over_) queue_.push<Auxiliary>() = auxiliary;
  return true;
}

CodeArguments BlockRun::m_arguments() {
  CodeArguments arguments;
  for (std::size_t i = 0; i < kArguments.size(); ++i) {
    const Word* word = take(kArguments[i]);
    if (word == nullptr) continue;
    arguments.given = static_cast<std::uint8_t>(arguments.given | 1U << i);
    arguments.values[i] = word->computed;
  }
  return arguments;
}

void BlockRun::turn_spindle(SpindleDirection direction, OutputTiming timing, const CodeArguments& arguments) {
  const bool turns =
      direction == SpindleDirection::clockwise || direction == SpindleDirection::counterclockwise;
  registers.spindle_on = turns;
  registers.outputs = direction == SpindleDirection::counterclockwise ? kTurnsBack : 0U;
  if (taking_over_) return;
  Spindle& spindle = queue_.push<Spindle>();
  spindle.direction = direction;
  spindle.timing = timing;
  spindle.arguments = arguments;
  if (turns) spindle.rpm = registers.spindle_rpm;
  if (direction != SpindleDirection::orient) return;
  spindle.rpm = settings_.orientation_velocity;
  spindle.angle = settings_.orientation_angle;
}

bool BlockRun::call_program() {
  constexpr int kMostCalls = 10000;
  const Word* program = take('P');
  const Word* times = take('L');
  if (program == nullptr)
    return refuse("program-number", span(words_.m_word()), "M98 needs the program number P.");
  FlowRequest request;
  request.kind = FlowRequest::Kind::macro_call;
  request.renews_locals = true;
  request.place = span(*program);
  request.repetitions = 1;
  if (times != nullptr && !integer(*times, 0, kMostCalls, request.repetitions)) return false;
  if (!(program->computed >= kFirstSubprogram && program->computed <= kLastSubprogram))
    return refuse("program-number", span(*program));
  if (!integer(*program, kFirstSubprogram, kLastSubprogram, request.program)) return false;
  // Deeper than the controller goes nothing is called, and the next block runs (manual M98).
  if (level_ < kDeepestCall) flow_ = request;
  return true;
}

/// To the caller; a program that nobody called ends.
void BlockRun::go_back() {
  if (level_ == 0) {
    ends_program = true;
    return;
  }
  flow_ = {};
  flow_.kind = FlowRequest::Kind::go_back;
  flow_.place = span(words_.m_word());
}

}  // namespace kerf::omron
