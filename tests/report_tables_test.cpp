// The tables for people and for spreadsheets: executed path, trace, alarms.

#include <array>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "report/alarm_catalogue.hpp"
#include "report/path_table.hpp"
#include "report/trace_csv.hpp"
#include "report_test_support.hpp"

namespace kerf {
namespace {

using report_test::at;
using report_test::golden;
using report_test::machine_with;
using report_test::origin_of;

TEST(ReportPathTable, GoldenRows) {
  PathTable table(machine_with({Axis::X, Axis::Y, Axis::Z}),
                  [](const Move& move) { return move.feed > 1000.0 ? 300.0 : move.feed; });
  std::string text;
  table.header(text);
  const auto write = [&](const Origin& origin, ActionVariant what) {
    table.write({origin, std::move(what)}, text);
  };
  write(origin_of(1, 7, 10), report_test::straight(MoveMode::rapid, at(0, 0, 0), at(10, -20.5, 5)));
  write(origin_of(2, 7),
        report_test::straight(MoveMode::linear, at(0, 0, 0), at(10, -20.5, -1.23456), 5000.0));
  write(origin_of(3, 7, 30), report_test::arc_xy(at(0, 0, 0), at(0, 0, 0), -5, 0, 360, 120.5));
  write(origin_of(3, 7, 30), CornerArc{});
  write(origin_of(4, 7, 30), Dwell{0.25});
  write(origin_of(5, 7), Auxiliary{8});
  Alarm warning;
  warning.kind = &report_test::kFeedClamped;
  warning.message = "F9000 is above \x1b[31m 6000";
  write(origin_of(6, 7), warning);
  write(origin_of(7), End{});
  EXPECT_EQ(text, golden("path_table.txt"));
}

TEST(ReportTraceCsv, HeaderAndRow) {
  const TraceCsv trace({Axis::X, Axis::A});
  std::string text;
  trace.header(text);
  TraceRow row;
  row.time_s = 0.1 + 0.2;
  row.line = 17;
  row.feed_mm_min = 600.0;
  row.command = at(1.5, 9, 9, -0.0);
  row.actual = at(1.4999999994, 9, 9, 1e-10);
  row.velocity_per_min = at(600, 9, 9, -360.1234564);
  trace.row(row, text);
  EXPECT_EQ(text,
            "t_s,line,feed_mm_min,X_cmd,X_act,X_vel,A_cmd,A_act,A_vel\n"
            "0.3,17,600,1.5,1.499999999,600,0,0,-360.123456\n");
}

constexpr std::array<AlarmKind, 3> kKinds{{
    {"1FC3H", "0313H", "Arc radius", "Why a.", "Write \"a\".", Severity::alarm},
    {"1FC3H", "0314H", "Arc end", "Why b.", "Write b.", Severity::alarm},
    {"DGS", "feed-clamped", "Feed clamped", "Why c.", "Write c.", Severity::warning},
}};

TEST(ReportAlarmCatalogue, Table) {
  std::string text;
  append_alarm_table(text, kKinds);
  EXPECT_EQ(text,
            "code   detail        name\n"
            "1FC3H  0313H         Arc radius\n"
            "1FC3H  0314H         Arc end\n"
            "DGS    feed-clamped  Feed clamped (warning)\n");
}

TEST(ReportAlarmCatalogue, ExplainedIsWrapped) {
  constexpr AlarmKind kKind{"DGS", "arc-radius", "Arc", "one two three four five", "six", Severity::alarm};
  std::string text;
  append_alarm_explained(text, kKind, 24);
  EXPECT_EQ(text,
            "alarm arc-radius: Arc\n"
            "  code    DGS\n"
            "  detail  arc-radius\n"
            "  cause   one two three\n"
            "          four five\n"
            "  write   six\n");
}

TEST(ReportAlarmCatalogue, Json) {
  std::string text;
  append_alarms_json(text, kKinds);
  const auto array = nlohmann::json::parse(text);
  ASSERT_EQ(array.size(), 3U);
  EXPECT_EQ(array[0], nlohmann::json::parse(R"({"code":"1FC3H","detail":"0313H","name":"Arc radius",
      "severity":"alarm","cause":"Why a.","remedy":"Write \"a\"."})"));
  EXPECT_EQ(array[2]["severity"], "warning");
  text.clear();
  append_alarms_json(text, {});
  EXPECT_EQ(nlohmann::json::parse(text), nlohmann::json::array());
}

TEST(ReportAlarmCatalogue, FindsByDetailCodeOrBoth) {
  const auto details = [](std::string_view key) {
    std::string found;
    for (const AlarmKind* kind : find_alarms(kKinds, key)) found += std::string(kind->detail) + ";";
    return found;
  };
  EXPECT_EQ(details("feed-clamped"), "feed-clamped;");
  EXPECT_EQ(details("FEED-CLAMPED"), "feed-clamped;");
  EXPECT_EQ(details("1fc3h"), "0313H;0314H;");
  EXPECT_EQ(details("0314H"), "0314H;");
  EXPECT_EQ(details("1FC3H-0314H"), "0314H;");
  EXPECT_EQ(details("1FC3H 0313h"), "0313H;");
  EXPECT_EQ(details("1FC3H0313H"), "");
  EXPECT_EQ(details("1FC3H-"), "");
  EXPECT_EQ(details(""), "");
}

}  // namespace
}  // namespace kerf
