#include <gtest/gtest.h>
#include <string>

#include "report/diagnostic.hpp"
#include "report/source_excerpt.hpp"
#include "report/text_escape.hpp"
#include "report_test_support.hpp"

namespace kerf {
namespace {

using report_test::golden;
using report_test::kArcRadius;
using report_test::kFeedClamped;

Alarm alarm_at(const AlarmKind& kind, std::string_view source, std::string_view word) {
  Alarm alarm;
  alarm.kind = &kind;
  const std::size_t offset = source.find(word);
  const std::size_t line_begin = source.rfind('\n', offset) + 1;  // npos + 1 is the first line's 0
  alarm.span.offset = offset;
  alarm.span.line = 1;
  for (std::size_t i = 0; i < offset; ++i) alarm.span.line += source[i] == '\n' ? 1U : 0U;
  alarm.span.column = static_cast<std::uint32_t>(offset - line_begin + 1);
  alarm.span.length = static_cast<std::uint32_t>(word.size());
  return alarm;
}

TEST(ReportDiagnostic, GoldenTexts) {
  const std::string source = "%\r\nN20 G2 X10 Y0 I5 J1\r\n\tG1 F9000\t(ｆ\a\xFF)\r\n";
  AlarmKind numbered = kFeedClamped;
  numbered.code = "1FC3H";
  numbered.detail = "0313H";
  const DiagnosticStyle style{false, 74};
  Alarm arc = alarm_at(kArcRadius, source, "X10");
  arc.message = "the end point is 0.2 mm off the arc";
  const Alarm feed = alarm_at(numbered, source, "G1");
  Alarm nowhere;
  nowhere.kind = &kArcRadius;
  nowhere.message = "no end of program";
  std::string text;
  for (const Alarm& alarm : {arc, feed, nowhere}) append_diagnostic(text, "part.nc", source, alarm, style);
  EXPECT_EQ(text, golden("diagnostics.txt"));
}

TEST(ReportDiagnostic, ColoursOnlyWhenAsked) {
  const std::string source = "G2 X10\n";
  const Alarm alarm = alarm_at(kArcRadius, source, "X10");
  EXPECT_EQ(diagnostic_text("a.nc", source, alarm, {false, 80}).find('\x1b'), std::string::npos);
  const std::string colored = diagnostic_text("a.nc", source, alarm, {true, 80});
  EXPECT_NE(colored.find("\x1b[1;31m"), std::string::npos);
  // Every colour is switched off again at the end of its line.
  std::size_t begin = 0;
  for (std::size_t end = colored.find('\n'); end != std::string::npos; end = colored.find('\n', begin)) {
    const std::string line = colored.substr(begin, end - begin);
    const std::size_t last = line.rfind("\x1b[");
    if (last != std::string::npos) {
      EXPECT_EQ(line.substr(last, 4), "\x1b[0m") << line;
    }
    begin = end + 1;
  }
}

TEST(ReportDiagnostic, SourceOfAnotherFileIsNotQuoted) {
  const Alarm alarm = alarm_at(kArcRadius, "G90\nG2 X10\n", "X10");
  EXPECT_EQ(diagnostic_text("a.nc", "G0", alarm).find('^'), std::string::npos);
  EXPECT_EQ(diagnostic_text("a.nc", "G90 G54 G17 G40", alarm).find('^'), std::string::npos);
}

TEST(ReportSourceExcerpt, TabsCountToTheNextStop) {
  const std::string source = "A\tB\tC";
  const Excerpt excerpt = excerpt_of(source, alarm_at(kArcRadius, source, "C").span, 80);
  EXPECT_EQ(excerpt.text, "A   B   C");
  EXPECT_EQ(excerpt.indent, 8);
  EXPECT_EQ(excerpt.width, 1);
}

TEST(ReportSourceExcerpt, WideCharactersTakeTwoColumns) {
  const std::string source = "(加工) X1";
  const Excerpt excerpt = excerpt_of(source, alarm_at(kArcRadius, source, "X1").span, 80);
  EXPECT_EQ(excerpt.indent, 7);  // bracket, two wide characters, bracket, space
  EXPECT_EQ(excerpt.width, 2);
}

TEST(ReportSourceExcerpt, PlaceBehindTheLastCharacter) {
  SourceSpan span;
  span.offset = 3;
  span.line = 1;
  span.column = 4;
  const Excerpt excerpt = excerpt_of("G90\nX1", span, 80);
  EXPECT_EQ(excerpt.text, "G90");
  EXPECT_EQ(excerpt.indent, 3);
  EXPECT_EQ(excerpt.width, 1);
}

TEST(ReportSourceExcerpt, LongLinesAreCutAroundTheMark) {
  const std::string source = std::string(300, 'A') + "WORD" + std::string(300, 'B');
  const Excerpt excerpt = excerpt_of(source, alarm_at(kArcRadius, source, "WORD").span, 40);
  EXPECT_EQ(visible_width(excerpt.text), 40);
  EXPECT_EQ(excerpt.text.rfind("…", 0), 0U);
  EXPECT_EQ(excerpt.text.substr(excerpt.text.size() - 3), "…");
  // Without the ellipsis of three bytes and one column the indent is a byte offset.
  EXPECT_EQ(excerpt.text.substr(static_cast<std::size_t>(excerpt.indent) + 2, 4), "WORD");
  EXPECT_EQ(excerpt.width, 4);
}

TEST(ReportSourceExcerpt, MarkNearTheEndsOfALongLine) {
  const std::string head = "WORD" + std::string(300, 'B');
  const Excerpt at_head = excerpt_of(head, alarm_at(kArcRadius, head, "WORD").span, 40);
  EXPECT_EQ(at_head.text, "WORD" + std::string(35, 'B') + "…");
  EXPECT_EQ(at_head.indent, 0);
  const std::string tail = std::string(300, 'A') + "WORD";
  const Excerpt at_tail = excerpt_of(tail, alarm_at(kArcRadius, tail, "WORD").span, 40);
  EXPECT_EQ(at_tail.text, "…" + std::string(35, 'A') + "WORD");
  EXPECT_EQ(at_tail.indent, 36);
}

}  // namespace
}  // namespace kerf
