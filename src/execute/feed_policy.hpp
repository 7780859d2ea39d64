#pragma once
// How a programmed feed becomes the feed the machine tries to reach.

#include <limits>

namespace kerf {

/// Limits, resolution and overrides of the cutting feed, and the override of the rapid rates. Source of the
/// order of the steps: DGSHAPE manual 1-4 and 2-5 (a feed outside the machine's range is replaced by the
/// limit, without an error; a feed is used in steps of the machine's resolution).
struct FeedPolicy {
  double minimum = 0.0;                                      ///< mm/min
  double maximum = std::numeric_limits<double>::infinity();  ///< mm/min
  double resolution = 0.0;                                   ///< mm/min; 0: none
  double feed_override = 100.0;                              ///< percent; 0 stands still when minimum is 0
  double rapid_override = 100.0;                             ///< percent of the axes' rapid rates, up to 100

  /// The feed used for a programmed one, mm/min: kept between minimum and maximum, then the override, rounded
  /// to the nearest multiple of the resolution, and kept between minimum and maximum again, so that 50 % of a
  /// feed over the maximum is half the maximum. A feed that is not a number counts as 0.
  double effective(double programmed_mm_min) const;
};

}  // namespace kerf
