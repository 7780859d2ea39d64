#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>

#include "report/number_text.hpp"

namespace kerf {
namespace {

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

TEST(ReportNumberText, ShortestDecimalThatReadsBack) {
  EXPECT_EQ(number(0.0), "0");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(number(10.0), "10");
  EXPECT_EQ(number(-12.5), "-12.5");
  EXPECT_EQ(number(0.0001), "0.0001");
  EXPECT_EQ(number(0.00012), "0.00012");
  EXPECT_EQ(number(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(number(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(number(1e20), "1e+20");
  EXPECT_EQ(number(123456789.0001), "123456789.0001");
}

TEST(ReportNumberText, WhatIsNotFiniteIsNull) {
  EXPECT_EQ(number(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(number(-std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN()), "null");
}

// The quick way for multiples of 0.0001 must give the very digits of the general algorithm.
TEST(ReportNumberText, QuickWayAgreesWithShortestAlgorithm) {
  std::mt19937_64 random(4711);
  std::uniform_int_distribution<std::int64_t> counts(-99'999'999'999, 99'999'999'999);
  std::uniform_real_distribution<double> anything(-1000.0, 1000.0);
  for (int i = 0; i < 20'000; ++i) {
    const double multiple = static_cast<double>(counts(random)) / 1e4;
    ASSERT_EQ(number(multiple), fmt::format("{}", multiple));
    const double value = anything(random);
    ASSERT_EQ(std::stod(number(value)), value);
  }
}

TEST(ReportNumberText, RoundedAndFixedPlaces) {
  EXPECT_EQ(rounded_text(1.5, 3), "1.5");
  EXPECT_EQ(rounded_text(2.0, 3), "2");
  EXPECT_EQ(rounded_text(-0.0004, 3), "0");
  EXPECT_EQ(rounded_text(-1.05, 9), "-1.05");
  EXPECT_EQ(rounded_text(0.001, 3), "0.001");
  EXPECT_EQ(fixed_text(1.5, 3), "1.500");
  EXPECT_EQ(fixed_text(-0.05, 1), "-0.1");
  EXPECT_EQ(fixed_text(-0.04, 1), "0.0");
  EXPECT_EQ(fixed_text(12.0, 0), "12");
  EXPECT_EQ(fixed_text(0.000001, 9), "0.000001000");
}

TEST(ReportNumberText, ClockRoundsBeforeItSplits) {
  EXPECT_EQ(clock_text(0.0), "0:00:00.0");
  EXPECT_EQ(clock_text(59.94), "0:00:59.9");
  EXPECT_EQ(clock_text(59.96), "0:01:00.0");
  EXPECT_EQ(clock_text(3599.96), "1:00:00.0");
  EXPECT_EQ(clock_text(36000.0 + 23.0 * 60.0 + 4.5), "10:23:04.5");
  EXPECT_EQ(clock_text(-1.0), "0:00:00.0");
  EXPECT_EQ(clock_text(std::nan("")), "0:00:00.0");
}

TEST(ReportNumberText, GroupsOfThree) {
  EXPECT_EQ(grouped_text(0), "0");
  EXPECT_EQ(grouped_text(999), "999");
  EXPECT_EQ(grouped_text(1000), "1 000");
  EXPECT_EQ(grouped_text(1234567), "1 234 567");
}

}  // namespace
}  // namespace kerf
