#include "motion/speed_chart.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf {

SpeedChart::SpeedChart(std::size_t capacity, double slot_s)
    : samples_(std::max(capacity, kSmallestCapacity)), slot_s_(slot_s) {}

void SpeedChart::add(const SpeedSample& sample) {
  if (size_ == samples_.size()) thin();
  place(sample);
}

std::vector<SpeedSample> SpeedChart::take() {
  samples_.resize(size_);
  size_ = 0;
  return std::move(samples_);
}

void SpeedChart::place(const SpeedSample& sample) {
  if (size_ == 0 || sample.time_s >= slot_end_) {
    slot_begin_ = size_;
    slot_end_ = (std::floor(sample.time_s / slot_s_) + 1.0) * slot_s_;
    samples_[size_++] = sample;
    return;
  }
  if (size_ - slot_begin_ == 1) {
    samples_[size_++] = sample;
    return;
  }
  // The slot holds its lowest and its highest sample in their order. The new one is the latest and may
  // replace either.
  SpeedSample& first = samples_[slot_begin_];
  SpeedSample& second = samples_[slot_begin_ + 1];
  const bool rising = second.feed_mm_min >= first.feed_mm_min;
  const SpeedSample& low = rising ? first : second;
  const SpeedSample& high = rising ? second : first;
  if (sample.feed_mm_min > high.feed_mm_min) {
    first = SpeedSample(low);
    second = sample;
  } else if (sample.feed_mm_min < low.feed_mm_min) {
    first = SpeedSample(high);
    second = sample;
  }
}

void SpeedChart::thin() {
  while (size_ > samples_.size() / 2) {
    slot_s_ *= 2.0;
    const std::size_t count = size_;
    size_ = 0;
    // In place: a sample never goes behind the one just read.
    for (std::size_t i = 0; i < count; ++i) place(SpeedSample(samples_[i]));
  }
}

}  // namespace kerf
