#pragma once
// The table of `kerf run --trace`: one row a control cycle.

#include <cstdint>
#include <string>

#include "base/axis.hpp"

namespace kerf {

/// One control cycle.
struct TraceRow {
  double time_s = 0.0;
  std::uint32_t line = 0;
  double feed_mm_min = 0.0;     ///< speed along the path
  AxisVector command;           ///< machine coordinates, mm or degrees
  AxisVector actual;            ///< of the simulated drives, mm or degrees
  AxisVector velocity_per_min;  ///< command velocity, mm/min or degree/min
};

/// Writes comma-separated values: `t_s,line,feed_mm_min`, then `X_cmd,X_act,X_vel` for each axis. Positions
/// have nine decimals, so that differences of successive rows still show the acceleration.
class TraceCsv {
 public:
  explicit TraceCsv(AxisSet axes) : axes_(axes) {}

  /// Appends the row of column names.
  void header(std::string& out) const;

  /// Appends one row; allocates nothing while `out` has room.
  void row(const TraceRow& row, std::string& out) const;

 private:
  AxisSet axes_;
};

}  // namespace kerf
