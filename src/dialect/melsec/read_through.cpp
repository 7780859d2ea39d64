#include "dialect/melsec/read_through.hpp"

#include <optional>

#include "dialect/melsec/block_words.hpp"
#include "dialect/melsec/compile.hpp"

namespace kerf::melsec {
namespace {

/// The block of a statement; nothing when a value is computed.
std::optional<Block> constant_block(const CompiledProgram& program, const Statement& statement) {
  Block block;
  block.span = statement.span;
  for (std::uint32_t i = 0; i < statement.word_count; ++i) {
    const Word& word = program.words[statement.first_word + i];
    if (word.expression >= 0) return std::nullopt;
    block.words.push_back(word);
  }
  return block;
}

}  // namespace

std::vector<Alarm> read_through(const std::shared_ptr<const Source>& source, const Machine& machine) {
  const auto program = compile(source, 0);
  const LineAxes line{machine.axes, machine.followers()};
  std::vector<Alarm> alarms;
  for (const Statement& statement : program->statements) {
    if (statement.kind == StatementKind::fault) {
      alarms.push_back(alarm_from(program->faults[statement.jump]));
    }
    if (statement.kind != StatementKind::words) continue;
    const auto block = constant_block(*program, statement);
    BlockWords words;
    std::optional<Alarm> alarm;
    if (block && !words.collect(*block, code(91), line, alarm)) alarms.push_back(*alarm);
  }
  return alarms;
}

}  // namespace kerf::melsec
