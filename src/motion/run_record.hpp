#pragma once
// What a run on the simulated machine leaves behind for the reports.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/alarm.hpp"
#include "base/axis.hpp"
#include "execute/action.hpp"

namespace kerf {

/// Largest magnitudes of one axis's command over a run.
struct AxisPeak {
  double velocity = 0.0;      ///< mm/min or degree/min
  double acceleration = 0.0;  ///< mm/s2 or degree/s2, along the plan, between corners
  double corner_step = 0.0;   ///< mm/s or degree/s: change of velocity at a corner of the exact path, in no
                              ///< time; motion.junction_deviation bounds it
  double jerk = 0.0;  ///< mm/s3 or degree/s3: change of the planned acceleration from one control cycle to
                      ///< the next, divided by the cycle; grows with a shorter cycle when the law has no
                      ///< limit of jerk
};

/// Lower and upper machine coordinate reached.
struct AxisBounds {
  double low = 0.0;
  double high = 0.0;
};

/// Totals of a run; the object of `kerf run --json`.
struct RunSummary {
  double time_s = 0.0;
  double cutting_s = 0.0;
  double rapid_s = 0.0;
  double dwell_s = 0.0;
  double tool_change_s = 0.0;
  double spindle_wait_s = 0.0;
  double cutting_mm = 0.0;
  double rapid_mm = 0.0;
  std::uint64_t blocks = 0;  ///< executed blocks
  std::uint64_t moves = 0;
  std::uint64_t cycles = 0;  ///< control cycles
  AxisSet axes;
  std::array<AxisBounds, kAxisCount> bounds{};
  std::array<AxisPeak, kAxisCount> peak{};
  bool stalled = false;       ///< the run ended at a move whose effective feed is 0
  std::vector<Alarm> alarms;  ///< warnings included, at most `RunRecord::kMaxAlarms`
};

/// One executed action with its time, in order of execution.
struct TimedAction {
  Action action;
  double start_s = 0.0;
  double duration_s = 0.0;
  double length_mm = 0.0;         ///< path length of a move
  double peak_feed_mm_min = 0.0;  ///< highest path speed reached in a move
};

/// Path speed at a time, for the speed chart.
struct SpeedSample {
  double time_s = 0.0;
  double feed_mm_min = 0.0;
  std::uint32_t line = 0;
};

/// Everything a report shows. Kept within a bounded size: beyond `kMaxTimedActions` the record is truncated
/// and `truncated` set; speed samples are thinned so that peaks survive.
struct RunRecord {
  static constexpr std::size_t kMaxTimedActions = 200'000;
  static constexpr std::size_t kMaxSpeedSamples = 20'000;
  static constexpr std::size_t kMaxAlarms = 1'000;
  RunSummary summary;
  std::vector<TimedAction> actions;
  std::vector<SpeedSample> speed;
  bool truncated = false;
};

}  // namespace kerf
