#pragma once
// Executes a program block by block, pulled by its caller.

#include <memory>

#include "execute/action_queue.hpp"
#include "execute/block_rules.hpp"
#include "execute/drilling_cycle.hpp"
#include "execute/state.hpp"
#include "syntax/block_reader.hpp"

namespace kerf {

struct InterpreterOptions {
  bool block_skip = false;                               ///< leave out blocks marked with a slash
  std::uint32_t most_rounds = ProgramFlow::kMostRounds;  ///< see ProgramFlow
  std::uint32_t most_restarts = 0xFFFFFFFF;              ///< see ProgramFlow
  ProgramTexts programs = [](std::int32_t) { return ProgramText{}; };  ///< what may be called
};

/// A value: a copy is a restart point. Allocates nothing once it runs, except to read a program called for
/// the first time.
class Interpreter {
 public:
  Interpreter(std::shared_ptr<const BlockRules> rules, std::shared_ptr<const Source> source,
              InterpreterOptions options);

  /// The next action, valid until the following call; null when the program is over. An alarm is the last
  /// action unless recover() is called.
  const Action* next();

  /// After an alarm: goes on with the next block, see BlockRules::take_over.
  void recover();

  /// Starts another program on the same state, as the controller does when the operator loads one. `position`
  /// is where the axes really stand, in machine coordinates.
  void load(std::shared_ptr<const Source> source, const AxisVector& position);

  const State& state() const { return state_; }
  const BlockRules& rules() const { return *rules_; }
  /// The text of a program by its number; of the only one when the dialect calls none.
  std::shared_ptr<const Source> source_of(std::int32_t program) const;
  /// Blocks executed so far.
  std::uint32_t blocks() const { return blocks_; }
  /// It ended because the main program would have begun anew once more than
  /// InterpreterOptions::most_restarts.
  bool began_too_often() const {
    const auto* flow = std::get_if<ProgramFlow>(&feed_);
    return flow != nullptr && flow->began_too_often();
  }

 private:
  void limit_rounds();
  void read_block(BlockReader& reader);
  void read_block(ProgramFlow& flow);
  /// Does what the last block asked for, then goes on to the next block.
  ProgramFlow::Result next_block(ProgramFlow& flow);
  void execute_block();
  void reach_end(const SourceSpan& place);

  std::shared_ptr<const BlockRules> rules_;
  BlockFeed feed_;
  InterpreterOptions options_;
  State state_;
  Block block_;
  ActionQueue queue_;
  BlockEffects effects_;
  std::uint32_t blocks_ = 0;
  bool finished_ = false;
  bool refused_ = false;  ///< the block read last gave an alarm
  bool stopped_ = false;
  bool behind_alarm_ = false;    ///< no block was executed since the last alarm
  bool return_refused_ = false;  ///< the block read last was to leave the program, and could not
};

}  // namespace kerf
