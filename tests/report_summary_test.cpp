#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "report/summary.hpp"
#include "report_test_support.hpp"

namespace kerf {
namespace {

using report_test::golden;
using report_test::machine_with;

Alarm raised(const AlarmKind& kind) {
  Alarm alarm;
  alarm.kind = &kind;
  alarm.span.line = 3;
  alarm.span.column = 4;
  return alarm;
}

RunSummary sample() {
  RunSummary summary;
  summary.time_s = 3662.5;
  summary.cutting_s = 2700.0;
  summary.rapid_s = 900.0;
  summary.dwell_s = 60.0;
  summary.tool_change_s = 2.5;
  summary.cutting_mm = 1234567.8912;
  summary.rapid_mm = 250.5;
  summary.blocks = 12345;
  summary.moves = 999;
  summary.cycles = 3662500;
  summary.axes = {Axis::X, Axis::A};
  summary.bounds[index(Axis::X)] = {-10.0, 120.5};
  summary.bounds[index(Axis::A)] = {0.0, 360.0};
  summary.peak[index(Axis::X)] = {4500.0, 250.0, 3.5, 5000.0};
  summary.peak[index(Axis::A)] = {3600.0, 0.0, 0.0};
  summary.alarms = {raised(report_test::kFeedClamped), raised(report_test::kFeedClamped),
                    raised(report_test::kArcRadius)};
  return summary;
}

Machine sample_machine() {
  Machine machine = machine_with({Axis::X, Axis::A});
  machine.axis[index(Axis::X)].rapid = 6000.0;
  machine.axis[index(Axis::X)].max_feed = 3000.0;
  machine.axis[index(Axis::X)].acceleration = 500.0;
  machine.axis[index(Axis::A)].rapid = 1800.0;
  machine.axis[index(Axis::A)].max_feed = 3600.0;
  return machine;
}

TEST(ReportSummary, GoldenText) {
  std::string text;
  append_summary(text, sample(), sample_machine());
  EXPECT_EQ(text, golden("summary.txt"));
}

TEST(ReportSummary, AnEmptyRunDividesByNothing) {
  std::string text;
  append_summary(text, RunSummary{}, Machine{});
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  EXPECT_NE(text.find("time               0:00:00.0"), std::string::npos);
}

TEST(ReportSummary, JsonObjectHasTheKeysOfTheInterface) {
  std::string text;
  append_summary_json(text, sample());
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  const auto object = nlohmann::json::parse(text);
  EXPECT_EQ(object["time_s"], 3662.5);
  EXPECT_EQ(object["cutting_s"], 2700.0);
  EXPECT_EQ(object["rapid_s"], 900.0);
  EXPECT_EQ(object["dwell_s"], 60.0);
  EXPECT_EQ(object["tool_change_s"], 2.5);
  EXPECT_EQ(object["spindle_wait_s"], 0.0);
  EXPECT_EQ(object["cutting_mm"], 1234567.8912);
  EXPECT_EQ(object["rapid_mm"], 250.5);
  EXPECT_EQ(object["blocks"], 12345);
  EXPECT_EQ(object["moves"], 999);
  EXPECT_EQ(object["cycles"], 3662500);
  EXPECT_EQ(object["bounds"], nlohmann::json::parse(R"({"X":[-10,120.5],"A":[0,360]})"));
  EXPECT_EQ(object["peak"]["X"],
            nlohmann::json::parse(R"({"velocity":4500,"acceleration":250,"corner_step":3.5,"jerk":5000})"));
  ASSERT_EQ(object["alarms"].size(), 3U);
  EXPECT_EQ(object["alarms"][0]["event"], "warning");
  EXPECT_EQ(object["alarms"][2]["event"], "alarm");
  EXPECT_EQ(object["alarms"][2]["detail"], "arc-radius");
  EXPECT_EQ(object["alarms"][2]["line"], 3);
}

TEST(ReportSummary, JsonStaysValidWhateverTheNumbers) {
  RunSummary summary = sample();
  summary.time_s = std::numeric_limits<double>::quiet_NaN();
  summary.peak[index(Axis::X)].jerk = std::numeric_limits<double>::infinity();
  std::string text;
  append_summary_json(text, summary);
  ASSERT_TRUE(nlohmann::json::accept(text));
  EXPECT_TRUE(nlohmann::json::parse(text)["time_s"].is_null());
}

}  // namespace
}  // namespace kerf
