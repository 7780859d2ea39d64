#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/html_report.hpp"
#include "report_test_support.hpp"

namespace kerf {
namespace {

using report_test::at;
using report_test::count_of;
using report_test::machine_with;
using report_test::straight;

const Machine kMachine = machine_with({Axis::X, Axis::Y, Axis::Z, Axis::A});

/// A program of four lines; the second is an attack, the third a cycle of two moves, the last raises an
/// alarm.
struct Sample {
  std::string source =
      "G0 X10\n"
      "M8 (</script><script>alert(1)</script><!-- \x8F)\n"
      "G81 Z-2.5\n"
      "G2 X<5>\n";
  RunRecord record;

  Origin origin(std::uint32_t line, std::size_t offset, std::size_t length) const {
    Origin origin;
    origin.span = {offset, line, 1, static_cast<std::uint32_t>(length)};
    origin.block = line;
    return origin;
  }
  void add(const Origin& from, ActionVariant what, double start_s, double duration_s, double length_mm,
           double feed) {
    TimedAction action;
    action.action = {from, std::move(what)};
    action.start_s = start_s;
    action.duration_s = duration_s;
    action.length_mm = length_mm;
    action.peak_feed_mm_min = feed;
    record.actions.push_back(action);
  }

  Sample() {
    const std::size_t second = source.find("M8");
    const std::size_t third = source.find("G81");
    const std::size_t fourth = source.find("G2 ");
    add(origin(1, 0, 6), straight(MoveMode::rapid, at(0, 0, 0), at(10, 0, 0)), 0.0, 0.5, 10.0, 6000.0);
    add(origin(2, second, third - second - 1), Auxiliary{8}, 0.5, 0.0, 0.0, 0.0);
    const Origin cycle = origin(3, third, 9);
    add(cycle, straight(MoveMode::linear, at(10, 0, 0), at(10, 0, -2.5), 300), 0.5, 0.25, 2.5, 300.5);
    add(cycle, straight(MoveMode::rapid, at(10, 0, -2.5), at(10, 0, 0)), 0.75, 0.25, 2.5, 6000.0);
    Alarm alarm;
    alarm.kind = &report_test::kArcRadius;
    alarm.span = {fourth + 3, 4, 4, 4};
    alarm.message = "<b>no radius</b>";
    add(origin(4, fourth, 7), alarm, 1.0, 0.0, 0.0, 0.0);
    record.summary.axes = kMachine.axes;
    record.summary.time_s = 1.0;
    record.summary.alarms = {alarm};
    record.speed = {{0.0, 0.0, 1}, {0.25, 6000.0, 1}, {1.0, 0.0, 3}};
  }

  std::string page(std::string title = "") const {
    return html_report({std::move(title), "part.nc", "DGSHAPE", "kerf test", source, {}, record, kMachine});
  }
};

std::string between(const std::string& text, std::string_view begin, std::string_view end) {
  const std::size_t from = text.find(begin) + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

nlohmann::json data_of(const std::string& page) {
  return nlohmann::json::parse(between(page, "id=\"data\">", "</script>"));
}

/// Adds up differences as the page's script does.
std::vector<std::int64_t> restored(const nlohmann::json& differences) {
  std::vector<std::int64_t> values;
  std::int64_t sum = 0;
  for (const auto& difference : differences) values.push_back(sum += difference.get<std::int64_t>());
  return values;
}

using Values = std::vector<std::int64_t>;

TEST(ReportHtml, IsSelfContained) {
  const std::string page = Sample().page();
  EXPECT_EQ(page.find("http://"), std::string::npos);
  EXPECT_EQ(page.find("https://"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_EQ(page.find("url("), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_NE(page.find("<title>part.nc – kerf run report</title>"), std::string::npos);
  EXPECT_NE(page.find("function readData"), std::string::npos);
  EXPECT_NE(page.find("prefers-color-scheme: dark"), std::string::npos);
}

TEST(ReportHtml, TextOfTheProgramCannotBecomeCode) {
  const std::string page = Sample().page("<img onerror=x>");
  // The two scripts of the page are the only ones, and each ends once.
  EXPECT_EQ(count_of(page, "<script"), 2U);
  EXPECT_EQ(count_of(page, "</script"), 2U);
  EXPECT_EQ(page.find("<!-- "), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(page.find("<b>no radius"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;no radius&lt;/b&gt;"), std::string::npos);
}

TEST(ReportHtml, AlarmStandsWithItsLineAndCaret) {
  const std::string page = Sample().page();
  EXPECT_NE(page.find("G2 X&lt;5&gt;\n"), std::string::npos);
  EXPECT_NE(page.find("   <span class=\"caret\">^~~~</span>"), std::string::npos);
  EXPECT_NE(page.find("line 4, column 4"), std::string::npos);
}

TEST(ReportHtml, RowsAreBlocks) {
  const auto data = data_of(Sample().page());
  EXPECT_EQ(restored(data["rows"]["line"]), (Values{1, 2, 3, 4}));
  EXPECT_EQ(restored(data["rows"]["count"]), (Values{1, 1, 2, 1}));
  EXPECT_EQ(restored(data["rows"]["text"]), (Values{0, 1, 2, 3}));
  EXPECT_EQ(data["texts"][0], "G0 X10");
  EXPECT_EQ(data["texts"][1], "M8 (</script><script>alert(1)</script><!-- \xEF\xBF\xBD)");
  EXPECT_EQ(data["actions"]["kinds"], "rolrx");
  EXPECT_EQ(data["actions"]["notes"], nlohmann::json::parse(R"({"1":"M8","4":"alarm arc-radius"})"));
}

TEST(ReportHtml, NumbersAreDifferencesOfFixedUnits) {
  const auto data = data_of(Sample().page());
  EXPECT_EQ(data["axes"], "XYZ");
  EXPECT_EQ(restored(data["actions"]["start"]), (Values{0, 5000, 5000, 7500, 10000}));
  EXPECT_EQ(restored(data["moves"]["length"]), (Values{10000, 2500, 2500}));
  EXPECT_EQ(restored(data["moves"]["peak"]), (Values{60000, 3005, 60000}));
  EXPECT_EQ(restored(data["moves"]["end"]["X"]), (Values{10000, 10000, 10000}));
  EXPECT_EQ(restored(data["moves"]["end"]["Z"]), (Values{0, -2500, 0}));
  EXPECT_EQ(data["moves"]["jumps"], nlohmann::json::parse("[[0,0,0,0]]"));
  EXPECT_EQ(restored(data["holes"]["bottom"]), (Values{-2500}));
  EXPECT_EQ(restored(data["speed"]["time"]), (Values{0, 2500, 10000}));
  EXPECT_EQ(restored(data["speed"]["feed"]), (Values{0, 60000, 0}));
  EXPECT_EQ(data["limits"]["all"], nlohmann::json::parse("[[0,10000],[0,0],[-2500,0]]"));
}

TEST(ReportHtml, ArcsAndJumpsAndTurningAxes) {
  Sample sample;
  const Origin origin = sample.origin(1, 0, 6);
  sample.add(origin, report_test::arc_xy(at(20, 0, 0, 30), at(30, 10, 0, 30), 20, 10, 90), 1.0, 1.0, 15.708,
             500.0);
  const auto data = data_of(sample.page());
  EXPECT_EQ(data["axes"], "XYZA");
  EXPECT_EQ(data["moves"]["jumps"], nlohmann::json::parse("[[0,0,0,0,0],[3,20000,0,0,30000]]"));
  EXPECT_EQ(
      data["moves"]["arcs"],
      nlohmann::json::parse(R"({"move":[3],"plane":[0],"first":[20000],"second":[10000],"sweep":[90000]})"));
  EXPECT_EQ(data["actions"]["kinds"], "rolrxa");
}

// A compensated corner: tool beside it by 2 mm, then a rapid, then the same tool again.
TEST(ReportHtml, WhatCompensationDoes) {
  Sample sample;
  sample.record.actions.clear();
  const Origin origin = sample.origin(1, 0, 6);
  const auto beside = [&](MoveMode mode, AxisVector start, AxisVector end) {
    Move move = straight(mode, start, end, 300);
    move.compensation = {Side::right, -2.0};
    sample.add(origin, move, 0.0, 1.0, 10.0, 300.0);
  };
  beside(MoveMode::linear, at(0, 2, 0), at(8, 2, 0));
  beside(MoveMode::linear, at(8, 2, 0), at(8, 10, 0));
  beside(MoveMode::rapid, at(8, 10, 0), at(8, 20, 0));
  beside(MoveMode::linear, at(8, 20, 0), at(8, 30, 0));
  ProgrammedPath programmed;
  Move contour = straight(MoveMode::linear, at(0, 0, 0), at(10, 0, 0));
  contour.compensation = {Side::right, -2.0};
  programmed.add({origin, contour});
  contour.start = at(10, 0, 0);
  contour.end = at(10, 30, 0);
  programmed.add({origin, contour});
  const auto data = data_of(html_report(
      {"", "part.nc", "", "", sample.source, {}, sample.record, kMachine, {&programmed, std::nullopt}}));
  EXPECT_EQ(restored(data["swept"]["move"]), (Values{0, 3}));
  EXPECT_EQ(restored(data["swept"]["count"]), (Values{2, 1}));
  EXPECT_EQ(restored(data["swept"]["radius"]), (Values{2000, 2000}));
  EXPECT_EQ(restored(data["swept"]["plane"]), (Values{0, 0}));
  EXPECT_EQ(restored(data["programmed"]["end"]["X"]), (Values{10000, 10000}));
  EXPECT_EQ(restored(data["programmed"]["end"]["Y"]), (Values{0, 30000}));
  EXPECT_EQ(restored(data["programmed"]["plane"]), (Values{0, 0}));
  EXPECT_EQ(data["programmed"]["jumps"], nlohmann::json::parse("[[0,0,0,0]]"));
  EXPECT_TRUE(data["pointing"].is_null());
  // The pictures reach as far as the tool and the contour: X from -2 to 10, Y from 0 to 32.
  EXPECT_EQ(data["limits"]["all"], nlohmann::json::parse("[[-2000,10000],[0,32000],[0,0]]"));
}

TEST(ReportHtml, WhereTheToolPoints) {
  Sample sample;
  Move move = straight(MoveMode::linear, at(10, 0, 0, 120), at(20, 0, 0, 120), 300);
  move.normal_line = Side::left;
  move.normal_zero = 30.0;
  sample.add(sample.origin(1, 0, 6), move, 1.0, 1.0, 10.0, 300.0);
  const ReportInput input{"",       "part.nc",         "", "", sample.source, {}, sample.record,
                          kMachine, {nullptr, Axis::A}};
  const auto data = data_of(html_report(input));
  EXPECT_EQ(data["axes"], "XYZA");
  EXPECT_EQ(data["pointing"]["axis"], "A");
  EXPECT_EQ(restored(data["pointing"]["move"]), (Values{3}));
  EXPECT_EQ(restored(data["pointing"]["count"]), (Values{1}));
  EXPECT_EQ(restored(data["pointing"]["zero"]), (Values{30000}));
  EXPECT_EQ(restored(data["moves"]["end"]["A"]), (Values{0, 0, 0, 120000}));
  EXPECT_TRUE(data["programmed"].is_null());
  EXPECT_EQ(data["swept"]["move"].size(), 0U);
}

TEST(ReportHtml, SubprogramsQuoteTheirOwnText) {
  Sample sample;
  const std::string subprogram = "G1 Y7\n";
  Origin origin = sample.origin(1, 0, 5);
  origin.program = 200;
  sample.add(origin, Auxiliary{1}, 1.0, 0.0, 0.0, 0.0);
  const std::string main_text = sample.source;
  const ReportInput input{
      "",
      "part.nc",
      "",
      "",
      main_text,
      [&](std::int32_t program) { return std::string_view(program == 200 ? subprogram : main_text); },
      sample.record,
      kMachine};
  const auto data = data_of(html_report(input));
  EXPECT_EQ(data["texts"][0], "G0 X10");
  EXPECT_EQ(data["texts"][4], "G1 Y7");
}

TEST(ReportHtml, AnEmptyRunIsAPageToo) {
  const RunRecord record;
  const Machine machine;
  const std::string page = html_report({"", "empty.nc", "", "", "", {}, record, machine});
  const auto data = data_of(page);
  EXPECT_EQ(data["texts"].size(), 0U);
  EXPECT_TRUE(data["limits"]["feed"].is_null());
  EXPECT_EQ(page.find("Alarms and warnings"), std::string::npos);
}

// A span that lies outside the text (another file's) gives no text and reads nothing behind it.
TEST(ReportHtml, SpansOutsideTheTextAreHarmless) {
  Sample sample;
  sample.source = "G0";
  const auto data = data_of(sample.page());
  EXPECT_EQ(data["texts"][0], "G0");
  EXPECT_EQ(data["texts"][2], "");
}

}  // namespace
}  // namespace kerf
