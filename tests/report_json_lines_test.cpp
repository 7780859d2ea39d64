#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "report/json_lines.hpp"
#include "report_test_support.hpp"

namespace kerf {
namespace {

using report_test::arc_xy;
using report_test::at;
using report_test::golden;
using report_test::machine_with;
using report_test::origin_of;
using report_test::straight;

const Machine kMachine = machine_with({Axis::X, Axis::Y, Axis::Z, Axis::A});

Alarm alarm_at(const AlarmKind& kind, std::uint32_t line, std::uint32_t column) {
  Alarm alarm;
  alarm.kind = &kind;
  alarm.span.line = line;
  alarm.span.column = column;
  return alarm;
}

std::string written(const Action& action, const JsonLines& lines = JsonLines(kMachine)) {
  std::string out;
  lines.write(action, out);
  return out;
}

/// One action of every kind, as the golden file has them.
std::string every_event() {
  const JsonLines lines(kMachine, [](const Move& move) { return move.feed == 9999.0 ? 250.0 : move.feed; });
  std::string out;
  const auto write = [&](const Origin& origin, ActionVariant what) {
    lines.write({origin, std::move(what)}, out);
  };
  write(origin_of(2), ToolChange{2, 1.5});
  write(origin_of(3), Spindle{SpindleDirection::clockwise, 8000.0, 1.0});
  Move rapid = straight(MoveMode::rapid, at(0, -0.0, 5), at(10, -2.5, 5, 90), 500.0);
  rapid.commanded = at(10, 0, -5, 90);
  write(origin_of(4, 101, 30), rapid);
  Move line = straight(MoveMode::linear, at(0, 0, 0), at(0.1, 0.0001, 0.1 + 0.2), 9999.0);
  line.commanded = at(0.1, 0, 1.0 / 3.0);
  write(origin_of(5), line);
  write(origin_of(6, 0, 0), arc_xy(at(0, 0, 0), at(10, 0, 0), 5, 0, -180, 300));
  Move turns = arc_xy(at(0, 0, 0), at(0, 0, 0), 0, 0, 720, 100);
  turns.plane = kPlaneZX;
  turns.arc.center = {1.5, 2.0};
  turns.arc.radius = 2.5;
  write(origin_of(7), turns);
  write(origin_of(7), CornerArc{});
  write(origin_of(8), Dwell{0.5});
  write(origin_of(9), Auxiliary{100});
  Alarm warning = alarm_at(report_test::kFeedClamped, 10, 7);
  warning.message = "F9000 is above 6000 mm/min";
  write(origin_of(10), warning);
  write(origin_of(11), Spindle{});
  write(origin_of(12), Stop{true});
  Alarm alarm = alarm_at(report_test::kNumbered, 12, 5);
  alarm.remedy = "say \"R\" \\ here";
  write(origin_of(12), alarm);
  write(origin_of(20), End{});
  return out;
}

TEST(ReportJsonLines, EveryEventAsTheInterfaceWritesIt) {
  EXPECT_EQ(every_event(), golden("path.jsonl"));
}

TEST(ReportJsonLines, EveryLineIsOneJsonObject) {
  std::istringstream lines(every_event());
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    ASSERT_TRUE(nlohmann::json::accept(line)) << line;
    EXPECT_TRUE(nlohmann::json::parse(line).contains("event"));
  }
  EXPECT_EQ(count, 13);
}

TEST(ReportJsonLines, CornerArcIsNeverWritten) {
  EXPECT_EQ(written({origin_of(1), CornerArc{}}), "");
}

TEST(ReportJsonLines, AxesTheMachineLacksAreAbsent) {
  const JsonLines lines(machine_with({Axis::X, Axis::Z}));
  const auto event = nlohmann::json::parse(
      written({origin_of(1), straight(MoveMode::linear, at(1, 2, 3, 4), at(5, 6, 7, 8), 1)}, lines));
  EXPECT_EQ(event["end"], nlohmann::json::parse(R"({"X":5,"Z":7})"));
  EXPECT_EQ(event["start"].size(), 2U);
  EXPECT_EQ(event["commanded"].size(), 2U);
}

TEST(ReportJsonLines, AnArcNamesThePlaneInItsOwnOrder) {
  Move move = arc_xy(at(0, 0, 0), at(0, 0, 0), 1, 2, 360);
  move.plane = kPlaneYZ;
  const auto event = nlohmann::json::parse(written({origin_of(1), move}));
  EXPECT_EQ(event["plane"], "YZ");
  EXPECT_EQ(event["center"], nlohmann::json::parse(R"({"Y":1,"Z":2})"));
}

TEST(ReportJsonLines, MessagesWithAnyBytesStayJson) {
  Alarm alarm = alarm_at(report_test::kArcRadius, 1, 1);
  alarm.message = "unknown word '\x8F\x01\"'";
  const std::string line = written({origin_of(1), alarm});
  ASSERT_TRUE(nlohmann::json::accept(line));
  EXPECT_EQ(nlohmann::json::parse(line)["message"], "unknown word '\xEF\xBF\xBD\x01\"'");
}

TEST(ReportJsonLines, SpindleDirections) {
  const auto direction = [](SpindleDirection of) {
    return nlohmann::json::parse(written({origin_of(1), Spindle{of, 0.0, 0.0}}))["direction"]
        .get<std::string>();
  };
  EXPECT_EQ(direction(SpindleDirection::clockwise), "cw");
  EXPECT_EQ(direction(SpindleDirection::counterclockwise), "ccw");
  EXPECT_EQ(direction(SpindleDirection::off), "off");
  EXPECT_EQ(direction(SpindleDirection::orient), "orient");
}

}  // namespace
}  // namespace kerf
