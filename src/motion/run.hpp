#pragma once
// Plays actions on the simulated machine in virtual time.

#include <cstdint>
#include <functional>

#include "execute/feed_policy.hpp"
#include "machine/machine.hpp"
#include "motion/cycle.hpp"
#include "motion/function_ref.hpp"
#include "motion/run_record.hpp"

namespace kerf {

/// The next action, valid until the following call; null when there are no more.
using ActionSource = FunctionRef<const Action*()>;

struct RunProgress {
  double time_s = 0.0;       ///< virtual time of the last control cycle
  std::uint64_t blocks = 0;  ///< executed blocks taken from the source so far
  std::uint64_t cycles = 0;
};

struct RunOptions {
  /// Fill in RunRecord::actions and RunRecord::speed; otherwise only the summary, and nothing is stored per
  /// block.
  bool record = false;
  /// Called for every control cycle with the positions of the simulated drives. Without it, cycles
  /// in which nothing changes are counted but not all stepped through.
  std::function<void(const Cycle& cycle, const AxisVector& actual)> on_cycle;
  /// Called about every `progress_cycles` cycles; false ends the run there.
  std::function<bool(const RunProgress&)> on_progress;
  std::uint64_t progress_cycles = 100'000;
};

/// Runs all actions of the source to rest. Memory is bounded by the machine's look-ahead and, with `record`,
/// by the limits of RunRecord. A move whose effective feed is 0 would stand for ever: the run ends before it
/// with RunSummary::stalled.
RunRecord run(ActionSource next, const Machine& machine, const FeedPolicy& policy,
              const RunOptions& options = {});

}  // namespace kerf
