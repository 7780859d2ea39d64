#include "execute/feed_policy.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {

double FeedPolicy::effective(double programmed_mm_min) const {
  double feed = programmed_mm_min * (feed_override / 100.0);
  if (!(feed > 0.0)) feed = 0.0;
  if (resolution > 0.0) feed = std::round(feed / resolution) * resolution;
  return std::min(std::max(feed, minimum), maximum);
}

}  // namespace kerf
