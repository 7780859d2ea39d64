#pragma once
// The way through compiled programs: jumps, loops, conditions, variables, calls and returns.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

#include "base/fixed_vector.hpp"
#include "execute/evaluate.hpp"
#include "execute/macro_variables.hpp"
#include "syntax/compiled_program.hpp"

namespace kerf {

/// The program of a number, null when there is none. Called once a program.
using ProgramFinder = std::function<std::shared_ptr<const CompiledProgram>(std::int32_t number)>;

/// What a block asks of the flow, written by the block rules.
struct FlowRequest {
  enum class Kind : std::uint8_t {
    none,
    call,        ///< subprogram
    macro_call,  ///< macro program with arguments
    go_back,     ///< to the caller; in the main program to its start
  };
  Kind kind = Kind::none;
  SourceSpan place;                  ///< what asks for it
  std::int32_t program = -1;         ///< to be called; -1: the one that is running
  std::int32_t sequence_number = 0;  ///< where to start or go on; 0: the start, or behind the call
  std::int32_t repetitions = 1;      ///< 0: none
  bool keep_locals = false;          ///< locals without an argument keep their values instead of becoming 0
  bool renews_locals = false;        ///< every repetition begins with locals of 0
  std::uint64_t given = 0;           ///< bit i - 1: argument for the local variable i
  MacroArguments arguments{};
};

/// What can be wrong on the way.
enum class FlowFault : std::uint8_t {
  no_variable,
  zero_divisor,
  out_of_domain,
  no_program,
  no_sequence_number,
  call_depth,
  macro_depth,
  if_depth,
  loop_depth,
  loop_unpaired,
  jump_into_loop,
  endless,  ///< more jumps back than any program needs
};
inline constexpr std::size_t kFlowFaults = 12;

/// The dialect's alarm for a fault. Texts are literals; empty ones: those of the kind.
struct FlowAlarm {
  const AlarmKind* kind = nullptr;
  std::string_view message = {};
  std::string_view remedy = {};
};

/// In the order of FlowFault.
using FlowAlarms = std::array<FlowAlarm, kFlowFaults>;

/// A value: a copy is a restart point. Allocates only when a program is called for the first time.
class ProgramFlow {
 public:
  static constexpr std::size_t kCalls = 10;
  static constexpr std::size_t kLoops = 27;   ///< nested, over all programs
  static constexpr std::size_t kRanges = 10;  ///< IFs nested in one program
  /// Jumps back, repetitions and calls after which a program counts as endless, ten times as many as with
  /// blocks for the block rules between them: seconds of work.
  static constexpr std::uint32_t kMostRounds = 100'000'000;

  enum class Result : std::uint8_t {
    block,
    end,   ///< a program ended without a word that ends it
    over,  ///< the main program was not loaded, or would begin anew more often than is wanted
    fault
  };

  ProgramFlow(std::shared_ptr<const CompiledProgram> program, ProgramFinder finder, const FlowAlarms& alarms);

  /// Goes on to the next block for the block rules. After `fault` the way goes on behind the faulty block.
  Result next(Block& block, MacroVariables& variables);
  /// Another number of rounds than kMostRounds, and how often the main program may begin anew.
  void limit(std::uint32_t most_rounds, std::uint32_t most_restarts) {
    most_rounds_ = most_rounds;
    most_restarts_ = most_restarts;
  }
  /// The main program would have begun anew once more than that.
  bool began_too_often() const { return restarts_ > most_restarts_; }
  /// Carries out what the block just executed asks for.
  Result carry_out(const FlowRequest& request, MacroVariables& variables);
  /// A check goes on behind a block that should have left the present program: to the caller; `over` when it
  /// is the main program.
  Result leave_program(MacroVariables& variables);
  /// The program ends at this place: a fault when a loop around it has no END.
  Result finish();

  const StatementFault& fault() const { return fault_; }  ///< after Result::fault
  const SourceSpan& span() const { return span_; }        ///< of the block reached
  const CompiledProgram& program() const { return *frames_.back().program; }
  /// The text of a program that was run, by its number.
  std::shared_ptr<const Source> source_of(std::int32_t number) const;
  /// Blocks reached since the start, this one included; those of conditions, loops and variables count as
  /// well.
  std::uint32_t blocks() const { return blocks_; }
  std::int32_t sequence_number() const { return sequence_number_; }  ///< of the block reached; -1: none

 private:
  struct Frame {
    std::shared_ptr<const CompiledProgram> program;
    StatementIndex next = 0;
    StatementIndex entry = 0;  ///< where a repetition starts
    StatementIndex call = 0;   ///< statement of the last call made from here
    LinePlace line;            ///< how far StatementKind::lines has been read
    std::int32_t repetitions_left = 0;
    bool macro = false;  ///< has locals of its own
    bool renews_locals = false;
    FixedVector<std::int16_t, kRanges> ranges;  ///< entered through their IFs
    FixedVector<std::int16_t, kLoops> loops;    ///< entered through their WHILE or DO
  };
  /// What became of one statement.
  enum class Step : std::uint8_t { on, block, fault };

  Step execute(const Statement& statement, Block& block, MacroVariables& variables);
  Step assign(const Statement& statement, MacroVariables& variables);
  Step go_to(const Statement& statement, const MacroVariables& variables);
  Step enter_range(const Statement& statement, const MacroVariables& variables);
  Step enter_loop(const Statement& statement, const MacroVariables& variables);
  Step end_loop(const Statement& statement);
  Step read_line(const Statement& statement, Block& block);
  Step fill(const Statement& statement, Block& block, const MacroVariables& variables);
  Step jump(StatementIndex target);
  /// Counts a jump back, a repetition or a call; false when there were too many.
  bool count_round();
  Step evaluate_condition(const ExpressionRef& condition, const MacroVariables& variables, bool& holds);
  Step compute(const ExpressionRef& expression, const MacroVariables& variables, double& value);
  Result call(const FlowRequest& request, MacroVariables& variables);
  Result go_back(const FlowRequest& request, MacroVariables& variables);
  Result repeat(MacroVariables& variables);
  Step fail(FlowFault fault);
  Result refuse(FlowFault fault);
  Result refuse(FlowFault fault, const SourceSpan& place);
  bool inside_unclosed_loop() const;
  bool may_jump_to(const Frame& frame, StatementIndex target) const;
  Step branch(const Statement& statement, const MacroVariables& variables);
  void leave_ranges(StatementIndex statement);
  void leave_loops(Frame& frame, StatementIndex statement);
  std::size_t loop_depth() const;
  void skip_block();
  void go_behind_fault(const Statement& statement);
  /// Goes back to the caller of the present program.
  void leave(MacroVariables& variables);
  Frame& here() { return frames_.back(); }

  FixedVector<Frame, kCalls + 1> frames_;
  ProgramFinder finder_;
  FlowAlarms alarms_;
  std::uint32_t rounds_ = 0;
  bool block_given_ = false;  ///< since the last round
  std::uint32_t most_rounds_ = kMostRounds;
  std::uint32_t restarts_ = 0;  ///< times the main program went back by itself
  std::uint32_t most_restarts_ = 0xFFFFFFFF;
  StatementFault fault_;
  SourceSpan span_{0, 1, 1, 1};
  std::int32_t sequence_number_ = -1;
  std::uint32_t blocks_ = 0;
};

}  // namespace kerf
