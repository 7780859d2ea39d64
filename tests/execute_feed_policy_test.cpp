#include <gtest/gtest.h>
#include <limits>

#include "execute/feed_policy.hpp"

namespace kerf {
namespace {

TEST(FeedPolicy, WithoutLimitsTheProgrammedFeedIsUsed) {
  EXPECT_DOUBLE_EQ(FeedPolicy{}.effective(123.456), 123.456);
}

TEST(FeedPolicy, RoundsToTheNearestStepOfTheResolution) {
  FeedPolicy policy;
  policy.resolution = 6.0;
  EXPECT_DOUBLE_EQ(policy.effective(100.0), 102.0);  // 16.67 steps
  EXPECT_DOUBLE_EQ(policy.effective(98.0), 96.0);    // 16.33 steps
}

TEST(FeedPolicy, FeedsOutsideTheRangeBecomeTheLimit) {
  FeedPolicy policy;
  policy.minimum = 6.0;
  policy.maximum = 1800.0;
  EXPECT_DOUBLE_EQ(policy.effective(6000.0), 1800.0);
  EXPECT_DOUBLE_EQ(policy.effective(0.6), 6.0);
  EXPECT_DOUBLE_EQ(policy.effective(0.0), 6.0);
  EXPECT_DOUBLE_EQ(policy.effective(-100.0), 6.0);
  EXPECT_DOUBLE_EQ(policy.effective(std::numeric_limits<double>::quiet_NaN()), 6.0);
}

TEST(FeedPolicy, TheOverrideActsOnTheLimitedFeedAndComesBeforeTheResolution) {
  FeedPolicy policy;
  policy.resolution = 10.0;
  policy.maximum = 1000.0;
  policy.feed_override = 50.0;
  // 50 % of 113 is 56.5, which rounds to 60; rounding first would give 110 and then 55.
  EXPECT_DOUBLE_EQ(policy.effective(113.0), 60.0);
  // 50 % of the limit 1000; the override acting on the programmed 1800 would give 900.
  EXPECT_DOUBLE_EQ(policy.effective(1800.0), 500.0);
}

TEST(FeedPolicy, AnOverrideDoesNotLiftTheFeedOverTheLimit) {
  FeedPolicy policy;
  policy.maximum = 1000.0;
  policy.feed_override = 200.0;
  EXPECT_DOUBLE_EQ(policy.effective(400.0), 800.0);
  EXPECT_DOUBLE_EQ(policy.effective(900.0), 1000.0);
}

TEST(FeedPolicy, AnOverrideOfZeroStandsStillUnlessThereIsAMinimum) {
  FeedPolicy policy;
  policy.feed_override = 0.0;
  EXPECT_DOUBLE_EQ(policy.effective(600.0), 0.0);
  policy.minimum = 6.0;
  EXPECT_DOUBLE_EQ(policy.effective(600.0), 6.0);
}

}  // namespace
}  // namespace kerf
