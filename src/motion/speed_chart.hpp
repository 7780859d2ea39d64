#pragma once
// Path speed over time in a bounded number of samples.

#include <cstddef>
#include <vector>

#include "motion/run_record.hpp"

namespace kerf {

/// Keeps every sample while there is room. Then time is divided into slots, each of which keeps its lowest
/// and its highest sample in their order; whenever the room is used up the slots become twice as long. So no
/// peak and no stop is ever lost, and the samples are spread evenly over time. Allocates in the constructor
/// only.
class SpeedChart {
 public:
  static constexpr std::size_t kSmallestCapacity = 8;

  /// A smaller capacity is raised to the smallest. `slot_s`: length of the first slots, seconds, > 0.
  SpeedChart(std::size_t capacity, double slot_s);

  /// Times must not fall.
  void add(const SpeedSample& sample);

  /// The samples so far, in the order of time. The chart is empty afterwards.
  std::vector<SpeedSample> take();

 private:
  void place(const SpeedSample& sample);
  void thin();

  std::vector<SpeedSample> samples_;  ///< of the full capacity; the first `size_` count
  std::size_t size_ = 0;
  double slot_s_;
  double slot_end_ = 0.0;
  std::size_t slot_begin_ = 0;  ///< first sample of the present slot, which holds one or two
};

}  // namespace kerf
