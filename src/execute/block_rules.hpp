#pragma once
// What a dialect adds to the interpreter: how one block acts on the state.

#include <functional>
#include <memory>
#include <variant>

#include "execute/action_queue.hpp"
#include "execute/drilling_cycle.hpp"
#include "execute/program_flow.hpp"
#include "execute/state.hpp"
#include "execute/tapping_cycle.hpp"
#include "syntax/block.hpp"
#include "syntax/block_reader.hpp"

namespace kerf {

/// What became of a block.
enum class BlockOutcome : std::uint8_t {
  done,
  alarm,  ///< the block changed nothing; the alarm is the only action it gave
  ended,  ///< the program is over
};

/// Where the blocks come from: a text without jumps is read as it is executed, any other is compiled first.
using BlockFeed = std::variant<BlockReader, ProgramFlow>;

/// A further program.
struct ProgramText {
  std::shared_ptr<const Source> source;  ///< null: there is none
  bool unreadable = false;               ///< its file is there and cannot be read; the source is empty
};

/// Finds a further program by its number.
using ProgramTexts = std::function<ProgramText(std::int32_t number)>;

/// What a block sets going besides its own actions.
struct BlockEffects {
  DrillingCycle cycle;
  TappingCycle tapping;
  FlowRequest flow;
};

/// Immutable once made, so that copies of an interpreter can share it.
class BlockRules {
 public:
  virtual ~BlockRules() = default;

  /// Makes the text ready to be executed block by block. `others` finds the programs it may call.
  virtual BlockFeed open(std::shared_ptr<const Source> source, ProgramTexts others) const = 0;
  /// Tables and registers before the first program, from the machine file.
  virtual State initial_state() const = 0;
  /// What the start of a program resets.
  virtual void begin_program(State& state) const = 0;
  /// Acts on one block. The queue has begun with the block's place and the program and sequence number in
  /// force; the rules renew these when the block changes them.
  virtual BlockOutcome execute(const Block& block, State& state, ActionQueue& queue,
                               BlockEffects& effects) const = 0;
  /// A check goes on behind a block that execute() refused: takes over what of it is beyond doubt (modal
  /// codes, the end of its move), so that the blocks behind it are judged as if it had been right.
  /// `ended` when the block ends the program, `done` otherwise.
  virtual BlockOutcome take_over(const Block& block, State& state, ActionQueue& queue,
                                 BlockEffects& effects) const = 0;
  /// The text ended without an end-of-program word, at the place the queue has begun with.
  virtual void end_of_data(State& state, ActionQueue& queue) const = 0;
  /// The alarm for text that is no block.
  virtual Alarm syntax_alarm(SyntaxFault fault, const SourceSpan& span) const = 0;
  /// Machine coordinates of the origin of the workpiece coordinate system in force.
  virtual AxisVector work_origin(const State& state) const = 0;
  /// A position as the controller shows it: an axis that turns without end within one turn.
  virtual AxisVector shown(AxisVector position) const { return position; }
  /// What the controller shows as the position in the workpiece coordinate system: without tool length
  /// offset, and without rotation where the controller shows it so.
  virtual AxisVector work_position(const State& state) const {
    return state.registers.position - work_origin(state);
  }
};

}  // namespace kerf
