#include "execute/feed_policy.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {

double FeedPolicy::effective(double programmed_mm_min) const {
  const double programmed = programmed_mm_min > 0.0 ? programmed_mm_min : 0.0;
  double feed = std::min(std::max(programmed, minimum), maximum) * (feed_override / 100.0);
  if (resolution > 0.0) feed = std::round(feed / resolution) * resolution;
  return std::min(std::max(feed, minimum), maximum);
}

}  // namespace kerf
