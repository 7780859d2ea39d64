#pragma once
// A program of a language with jumps, compiled once: statements with their targets.

#include <cstdint>
#include <memory>
#include <vector>

#include "base/alarm.hpp"
#include "syntax/block.hpp"
#include "syntax/expression.hpp"
#include "syntax/plain_line.hpp"
#include "syntax/source.hpp"

namespace kerf {

/// An index into CompiledProgram::statements.
using StatementIndex = std::uint32_t;
inline constexpr StatementIndex kNoStatement = 0xFFFFFFFF;

enum class StatementKind : std::uint8_t {
  words,       ///< a block of words for the block rules
  lines,       ///< lines of plain words, each such a block (plain_line.hpp), from the start of `span` on; the
               ///< line is the sequence number
  assignment,  ///< the variable whose number is `target` becomes `value`
  go_to,       ///< to the sequence number `value`; when `condition` is given, only if it holds
  if_then,     ///< enters the IF range `range`; to `jump` when `condition` does not hold
  else_part,   ///< to `jump` when the range was entered through its IF
  while_do,    ///< enters the loop `loop`; to `jump` when `condition` is given and does not hold
  end_do,      ///< back to `jump`, the WHILE or DO of the loop
  branch,      ///< to `jump` unless `condition` is given and holds
  go_back,     ///< to the caller; in the main program without effect
  nothing,     ///< a label, an ENDIF
  fault,       ///< raises fault number `jump`
};

/// One step of a program. A block of the text gives one or several.
struct Statement {
  SourceSpan span;  ///< the block
  StatementKind kind = StatementKind::words;
  bool first_of_block = true;
  std::int16_t loop = -1;             ///< innermost loop around it; of a WHILE, DO or END its own; -1: none
  std::int16_t range = -1;            ///< innermost IF range around it; of an IF or ELSE its own; -1: none
  std::int32_t sequence_number = -1;  ///< N word of the block; -1: none
  StatementIndex jump = kNoStatement;
  std::uint32_t first_word = 0;
  std::uint32_t word_count = 0;
  std::uint8_t skip_number = 0;  ///< see Block
  ExpressionRef condition;
  ExpressionRef target;
  ExpressionRef value;
};

/// A WHILE or DO with its END, or an IF with its ENDIF: statements `first` to `last`, both included.
struct StatementRange {
  StatementIndex first = 0;
  StatementIndex last = kNoStatement;  ///< kNoStatement: it never ends
  std::int16_t parent = -1;            ///< the enclosing range of the same sort; -1: none

  bool contains(StatementIndex statement) const { return statement >= first && statement <= last; }
  bool closed() const { return last != kNoStatement; }
};

/// What is wrong with a block; raised when the block is reached.
struct StatementFault {
  const AlarmKind* kind = nullptr;
  SourceSpan span;
  std::string_view message = {};  ///< a literal; empty: the kind's cause
  std::string_view remedy = {};   ///< a literal; empty: the kind's remedy
};

inline Alarm alarm_from(const StatementFault& fault) {
  return {fault.kind, fault.span, fault.message, fault.remedy};
}

/// A sequence number and where it stands.
struct SequenceLabel {
  std::int32_t number = 0;
  StatementIndex statement = 0;
};

/// Immutable once compiled, shared by all interpreters that run it.
struct CompiledProgram {
  std::shared_ptr<const Source> source;
  std::int32_t number = -1;  ///< program number; -1: none
  std::vector<Statement> statements;
  std::vector<Word> words;  ///< of all blocks; Word::expression is an index into `word_values`
  std::vector<ExpressionRef> word_values;
  std::vector<ExpressionStep> steps;  ///< of all expressions
  std::vector<StatementRange> loops;
  std::vector<StatementRange> ranges;
  std::vector<StatementFault> faults;
  std::vector<SequenceLabel> labels;  ///< sorted by number, then by place
  LetterSet plain_letters{""};        ///< of words in StatementKind::lines
  bool refused = false;               ///< the controller did not load it: a fault is all it holds

  Expression expression(const ExpressionRef& ref) const {
    return Expression(steps).subspan(ref.begin, ref.count);
  }
  /// Where a jump from the statement `from` to a sequence number leads: to the first one behind its block or,
  /// without one, to the first one in front of it; kNoStatement when there is none.
  StatementIndex find_label(std::int32_t wanted, StatementIndex from) const;
  /// Leaves nothing but the reason why the controller does not load the program.
  void refuse(const StatementFault& why);
  /// The first statement with the sequence number, from the start of the program; kNoStatement without one.
  StatementIndex find_first(std::int32_t wanted) const;
};

}  // namespace kerf
