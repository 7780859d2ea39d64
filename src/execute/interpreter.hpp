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
  bool block_skip = false;  ///< leave out blocks marked with a slash
};

/// A value: a copy is a restart point. Allocates nothing once it runs.
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
  const std::shared_ptr<const Source>& source() const { return reader_.source(); }
  /// Blocks executed so far.
  std::uint32_t blocks() const { return blocks_; }

 private:
  void read_block();

  std::shared_ptr<const BlockRules> rules_;
  BlockReader reader_;
  InterpreterOptions options_;
  State state_;
  Block block_;
  ActionQueue queue_;
  DrillingCycle cycle_;
  std::uint32_t blocks_ = 0;
  bool finished_ = false;
  bool refused_ = false;  ///< the block read last gave an alarm
  bool stopped_ = false;
};

}  // namespace kerf
