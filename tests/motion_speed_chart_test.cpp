#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "motion/speed_chart.hpp"

namespace kerf {
namespace {

TEST(SpeedChart, KeepsEverySampleWhileThereIsRoom) {
  SpeedChart chart(100, 0.001);
  for (int i = 0; i < 100; ++i) chart.add({0.001 * i + 0.0005, 1.0 * i, 7});
  const std::vector<SpeedSample> samples = chart.take();
  ASSERT_EQ(samples.size(), 100U);
  EXPECT_EQ(samples[42].feed_mm_min, 42.0);
  EXPECT_EQ(samples[42].line, 7U);
}

TEST(SpeedChart, ThinningKeepsPeaksAndStopsInOrder) {
  SpeedChart chart(64, 0.001);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(400.0, 600.0);
  const int count = 100000;
  for (int i = 0; i < count; ++i) {
    double feed = noise(random);
    if (i == 31234) feed = 1000.0;
    if (i == 77777) feed = 0.0;
    chart.add({0.001 * (i + 0.5), feed, static_cast<std::uint32_t>(i)});
  }
  const std::vector<SpeedSample> samples = chart.take();
  EXPECT_LE(samples.size(), 64U);
  EXPECT_GT(samples.size(), 16U);
  const auto by_feed = [](const SpeedSample& a, const SpeedSample& b) {
    return a.feed_mm_min < b.feed_mm_min;
  };
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end(), by_feed);
  EXPECT_EQ(low->feed_mm_min, 0.0);
  EXPECT_EQ(low->line, 77777U);
  EXPECT_NEAR(low->time_s, 77.7775, 1e-9);
  EXPECT_EQ(high->feed_mm_min, 1000.0);
  EXPECT_EQ(high->line, 31234U);
  EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end(),
                             [](const SpeedSample& a, const SpeedSample& b) { return a.time_s < b.time_s; }));
  // Spread over the whole time, not crowded at one end.
  double widest = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    widest = std::max(widest, samples[i].time_s - samples[i - 1].time_s);
  EXPECT_LT(widest, 15.0);
}

TEST(SpeedChart, ManySamplesAtOneTimeStayWithinTheRoom) {
  SpeedChart chart(8, 0.001);
  for (int i = 0; i < 1000; ++i) chart.add({5.0, 1.0 * i, 0});
  EXPECT_LE(chart.take().size(), 8U);
}

}  // namespace
}  // namespace kerf
