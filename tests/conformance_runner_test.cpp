// The conformance runner itself: case files, matching of events, coverage.

#include <gtest/gtest.h>
#include <string>

#include "conformance/runner/case_parser.hpp"
#include "conformance/runner/coverage.hpp"
#include "conformance/runner/entry.hpp"
#include "conformance/runner/event_match.hpp"
#include "conformance/runner/foreach.hpp"
#include "conformance/runner/run_case.hpp"
#include "conformance/runner/statements.hpp"

namespace kerf::conformance {
namespace {

Entry entry(std::string_view text) {
  const auto parsed = parse_entry(text, 1);
  EXPECT_TRUE(parsed) << text;
  return parsed.value_or(Entry{});
}

std::vector<Entry> entries(const std::vector<std::string>& lines) {
  std::vector<Entry> result;
  for (const std::string& line : lines) result.push_back(entry(line));
  return result;
}

/// The only error of a file, as FILE:LINE: MESSAGE.
std::string only_error(std::string_view text) {
  const CaseFile file = parse_cases("x.case", text);
  if (file.errors.size() != 1) return std::to_string(file.errors.size()) + " errors";
  return error_text(file.errors.front());
}

constexpr std::string_view kSmallCase =
    "=== A title\n"
    "ids: DGS-001 DGS-002\n"
    "--- body\n"
    "G21\n"
    "--- expect\n"
    "end\n";

TEST(ConformanceCaseParser, BodyStandsBetweenTheDataMarks) {
  const CaseFile file = parse_cases("x.case", kSmallCase);
  ASSERT_TRUE(file.errors.empty());
  ASSERT_EQ(file.cases.size(), 1U);
  const Case& test = file.cases[0];
  EXPECT_EQ(test.title, "A title");
  EXPECT_EQ(test.line, 1U);
  EXPECT_EQ(test.ids, (std::vector<std::string>{"DGS-001", "DGS-002"}));
  ASSERT_EQ(test.programs.size(), 1U);
  EXPECT_EQ(test.programs[0].text, "%\nG21\nM02\n%\n");
  EXPECT_EQ(test.watched.count("warning"), 0U);
  EXPECT_EQ(test.watched.count("moves"), 1U);
}

TEST(ConformanceCaseParser, ProgramStandsAsItIsWritten) {
  const CaseFile file = parse_cases("x.case",
                                    "# a remark\n\n=== A\nids: A\n# another\n--- program\n# no remark\n\n%\n"
                                    "--- expect\nend\n");
  ASSERT_TRUE(file.errors.empty());
  EXPECT_EQ(file.cases.at(0).programs.at(0).text, "# no remark\n\n%\n");
}

TEST(ConformanceCaseParser, ReadsEveryHeader) {
  const CaseFile file = parse_cases(
      "x.case",
      "=== A\nids: A\nset: axes.X.limits=[-1, 2]\nset: a=b\nideal: yes\nrecover: yes\nwatch: moves warning\n"
      "eol: crlf\noptions: optional-stop block-skip\nduring: t=0.5 feed_override=50\n"
      "during: t=1 rapid_override=25\ntol: 0.01\n--- body\n--- expect\nrapid X=+1.5 line=2\n--- after\nW "
      "X=1\n");
  ASSERT_TRUE(file.errors.empty()) << error_text(file.errors[0]);
  const Case& test = file.cases.at(0);
  EXPECT_EQ(test.settings, (std::vector<std::string>{"axes.X.limits=[-1, 2]", "a=b"}));
  EXPECT_TRUE(test.ideal && test.recover && test.optional_stop && test.block_skip);
  EXPECT_EQ(test.watched, (std::set<std::string>{"moves", "warning"}));
  EXPECT_EQ(test.line_end, LineEnd::crlf);
  EXPECT_EQ(test.tolerance, 0.01);
  ASSERT_EQ(test.changes.size(), 2U);
  EXPECT_EQ(test.changes[0].time_s, 0.5);
  EXPECT_EQ(test.changes[0].feed_percent, 50.0);
  EXPECT_FALSE(test.changes[0].rapid_percent);
  EXPECT_EQ(test.changes[1].rapid_percent, 25.0);
  EXPECT_EQ(entry_text(test.programs[0].expected.at(0)), "rapid X=1.5 line=2");
  EXPECT_EQ(entry_text(test.programs[0].facts.at(0)), "W X=1");
}

TEST(ConformanceCaseParser, SeveralProgramsHaveTheirOwnExpectations) {
  const CaseFile file =
      parse_cases("x.case",
                  "=== A\nids: A\n--- body\nG00\n--- expect\nend\n--- body\nG01\n--- expect\n"
                  "end line=3\n--- after\nsame\n");
  ASSERT_TRUE(file.errors.empty());
  const Case& test = file.cases.at(0);
  ASSERT_EQ(test.programs.size(), 2U);
  EXPECT_EQ(test.programs[0].expected.size(), 1U);
  EXPECT_EQ(test.programs[1].text, "%\nG01\nM02\n%\n");
  EXPECT_EQ(test.programs[1].facts.size(), 1U);
}

TEST(ConformanceCaseParser, AlternativesReplaceNamesEverywhere) {
  const CaseFile file =
      parse_cases("x.case",
                  "=== A\nids: DGS-$n\nforeach: $n $nn = 1 a~b\n| 2 c\nforeach: $k = G00 | G01\n"
                  "--- body\n$k$nn\n--- expect\nend line=$n\n");
  ASSERT_TRUE(file.errors.empty());
  ASSERT_EQ(file.cases.size(), 4U);
  EXPECT_EQ(file.cases[1].ids.at(0), "DGS-1");
  EXPECT_EQ(file.cases[1].programs.at(0).text, "%\nG01a b\nM02\n%\n");
  EXPECT_EQ(file.cases[1].alternative, "$n=1 $nn=a b $k=G01");
  EXPECT_EQ(entry_text(file.cases[2].programs.at(0).expected.at(0)), "end line=2");
}

TEST(ConformanceCaseParser, ErrorsHaveAPlace) {
  EXPECT_EQ(only_error("=== A\nids: A\nsets: x\n--- body\n--- expect\nend\n"),
            "x.case:3: unknown header 'sets'");
  EXPECT_EQ(only_error("=== A\nids: A\n--- body\n--- expect\nend\nrapit X=1\n"),
            "x.case:6: 'rapit' is no event");
}

TEST(ConformanceCaseParser, NamesOfAlternativesMustFit) {
  const std::string tail = "--- body\nG00X$x\n--- expect\nend\n";
  EXPECT_EQ(only_error("=== A\nids: A\nforeach: $x = 1 | 2\n" + tail), "0 errors");
  EXPECT_EQ(only_error("=== A\nids: A\n" + tail), "x.case:4: no foreach names '$x'");
  EXPECT_EQ(only_error("=== A\nids: A\nforeach: $x $xy = 1 2\n" + tail), "x.case:1: nothing uses '$xy'");
}

TEST(ConformanceCaseParser, RefusesWhatProvesNothing) {
  EXPECT_EQ(only_error("=== A\n--- body\n--- expect\nend\n"), "x.case:1: the case proves nothing: no ids");
  EXPECT_EQ(only_error("=== A\nids: A\n"), "x.case:1: the case has no program");
  EXPECT_EQ(only_error("=== A\nids: A\n--- body\nG00\n"), "x.case:3: the program has no expectation");
  EXPECT_EQ(only_error("=== A\nids: A\n--- body\nG00\n--- after\nW X=1\n"),
            "x.case:3: the program has no expectation");
  EXPECT_EQ(only_error("=== A\nids: A\n--- body\nG00\n--- expect\n"),
            "x.case:3: the program has no expectation");
  EXPECT_EQ(only_error("=== A\nids: A\nwatch: end\n--- body\n--- expect\nrapid X=1\nend\n"),
            "x.case:6: 'rapid' is not watched");
  EXPECT_EQ(only_error(""), "x.case: the file has no case");
  EXPECT_EQ(only_error("G00\n=== A\nids: A\n--- body\n--- expect\nend\n"),
            "x.case:1: text before the first ===");
}

TEST(ConformanceCaseParser, RefusesMalformedLines) {
  const std::string head = "=== A\nids: A\n";
  const std::string tail = "--- body\n--- expect\nend\n";
  EXPECT_EQ(only_error(head + "foreach: $a $b = 1 | 2 3\n" + tail), "x.case:3: '1' has 1 values for 2 names");
  EXPECT_EQ(only_error(head + "foreach: a = 1\n" + tail),
            "x.case:3: 'a' is no name: $ and lower-case letters");
  EXPECT_EQ(only_error(head + "during: feed_override=50\n" + tail),
            "x.case:3: during: t=SECONDS feed_override=PERCENT");
  EXPECT_EQ(only_error(head + "ideal: no\n" + tail), "x.case:3: ideal can only be yes");
  EXPECT_EQ(only_error(head + "tol: 0\n" + tail), "x.case:3: tol needs a positive number");
  EXPECT_EQ(only_error(head + "ids\n" + tail), "x.case:3: 'ids' is no header line");
  EXPECT_EQ(only_error(head + "--- expectation\n" + tail), "x.case:3: unknown section 'expectation'");
  EXPECT_EQ(only_error(head + "--- expect\n" + tail), "x.case:3: '--- expect' stands before any program");
  EXPECT_EQ(only_error(head + tail + "--- after\nat X=1\n"), "x.case:7: 'at' needs t=");
  EXPECT_EQ(only_error(head + tail + "--- after\nW\n"), "x.case:7: 'W' states nothing");
  EXPECT_EQ(only_error(head + tail + "--- after\nsame\n"),
            "x.case:7: 'same' needs a program before this one");
}

TEST(ConformanceEntry, KnowsWhatMayStandInAnEvent) {
  EXPECT_EQ(
      event_fault(entry("cw X=1 mY=2 cZ=3 sA=4 centerX=5 radius=6 sweep=-90 plane=XY F=600 line=2 n=1")), "");
  EXPECT_EQ(event_fault(entry("rapid X=1 plane=XY")), "'rapid' has no 'plane'");
  EXPECT_EQ(event_fault(entry("rapid x=1")), "'rapid' has no 'x'");
  EXPECT_EQ(event_fault(entry("cw plane=1")), "the value of 'plane' in 'cw' has the wrong type");
  EXPECT_EQ(event_fault(entry("linear X=far")), "the value of 'X' in 'linear' has the wrong type");
  EXPECT_EQ(event_fault(entry("spindle")), "'spindle' has 0 words where 1 to 1 are allowed");
  EXPECT_EQ(event_fault(entry("spindle on")), "'spindle' cannot be 'on'");
  EXPECT_EQ(event_fault(entry("m twelve")), "'m' cannot be 'twelve'");
  EXPECT_EQ(event_fault(entry("alarm no-feed line=3 column=1")), "");
  EXPECT_EQ(fact_fault(entry("radius 1=3")), "");
  EXPECT_EQ(fact_fault(entry("output 12=on")), "");
  EXPECT_EQ(fact_fault(entry("offset G53 X=1")), "'offset' cannot be 'G53'");
  EXPECT_FALSE(parse_entry("rapid X=", 1));
  EXPECT_FALSE(parse_entry("rapid X=1 X=2", 1));
  EXPECT_FALSE(parse_entry("alarm line=1 no-feed", 1));
}

TEST(ConformanceMatch, ComparesOnlyWrittenFieldsWithinTheTolerance) {
  const Entry observed = entry("linear X=10.0004 Y=2 F=600 line=3");
  EXPECT_TRUE(fits(entry("linear X=10"), observed, 0.0006));
  EXPECT_FALSE(fits(entry("linear X=10"), observed, 0.0001));
  EXPECT_FALSE(fits(entry("rapid X=10"), observed, 0.0006));
  EXPECT_FALSE(fits(entry("linear Z=0"), observed, 0.0006)) << "a field that was not observed does not fit";
  EXPECT_FALSE(fits(entry("linear line=4"), observed, 2.0)) << "line numbers are exact";
}

TEST(ConformanceMatch, WordsMustBeTheSameExceptForAnyAlarm) {
  EXPECT_FALSE(fits(entry("stop"), entry("stop optional"), 0.1));
  EXPECT_FALSE(fits(entry("spindle off"), entry("spindle cw rpm=1"), 0.1));
  EXPECT_TRUE(fits(entry("alarm"), entry("alarm no-feed line=3"), 0.1));
  EXPECT_FALSE(fits(entry("alarm arc-words"), entry("alarm no-feed line=3"), 0.1));
  EXPECT_FALSE(fits(entry("alarm"), entry("warning no-feed"), 0.1));
}

TEST(ConformanceMatch, WatchesMovesTogether) {
  const auto all = entries({"rapid X=1", "dwell s=1", "cw X=1", "refused a", "end"});
  EXPECT_EQ(watched_events(all, {"moves"}).size(), 3U) << "refused is always watched";
  EXPECT_EQ(watched_events(all, {"dwell", "end"}).size(), 3U);
}

TEST(ConformanceMatch, DifferenceIsEmptyOnlyForEqualLists) {
  const auto expected = entries({"rapid X=1", "end"});
  EXPECT_EQ(event_difference(expected, entries({"rapid X=1 Y=2", "end line=3"}), 0.0006), "");
  EXPECT_NE(event_difference(expected, entries({"rapid X=1"}), 0.0006), "");
  EXPECT_NE(event_difference(expected, entries({"rapid X=1", "end", "end"}), 0.0006), "");
  EXPECT_NE(event_difference({}, entries({"end"}), 0.0006), "");
}

TEST(ConformanceMatch, DifferenceAlignsAndNamesWhatDiffers) {
  const auto expected = entries({"rapid X=1", "linear X=2 F=600", "end"});
  EXPECT_EQ(event_difference(expected, entries({"rapid X=1", "linear X=2 F=300", "end"}), 0.0006),
            "  rapid X=1\n- linear X=2 F=600\n+ linear X=2 F=300   (not as expected: F=300)\n  end\n");
  EXPECT_EQ(event_difference(expected, entries({"rapid X=1", "end"}), 0.0006),
            "  rapid X=1\n- linear X=2 F=600\n  end\n");
  EXPECT_EQ(
      event_difference(expected, entries({"rapid X=1", "dwell s=1", "linear X=2 F=600", "end"}), 0.0006),
      "  rapid X=1\n+ dwell s=1\n  linear X=2 F=600\n  end\n");
}

TEST(ConformanceMatch, SameLeavesPlacesOut) {
  const auto stripped = without_place(entries({"rapid X=1 mX=5 line=3 n=4", "alarm a line=1 column=2"}));
  EXPECT_EQ(entry_text(stripped[0]), "rapid X=1");
  EXPECT_EQ(entry_text(stripped[1]), "alarm a");
}

TEST(ConformanceStatements, IdsComeFromTheFirstColumn) {
  const auto table = parse_statements("dir/dgshape.tsv", "id\tsection\tstatement\nDGS-001\t1\tA fact\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->name, "dgshape");
  EXPECT_EQ(table->statements.at(0).id, "DGS-001");
  EXPECT_EQ(table->statements.at(0).text, "A fact");
  const auto words = parse_statements("dgshape_codes.tsv", "word\tgroup\nX\ta\nG00\tb\nX\tc\nX\td\n");
  ASSERT_TRUE(words);
  EXPECT_EQ(words->dialect, "dgshape");
  EXPECT_EQ(words->statements.at(0).id, "DGC-X");
  EXPECT_EQ(words->statements.at(1).id, "DGC-G00");
  EXPECT_EQ(words->statements.at(2).id, "DGC-X-2");
  EXPECT_EQ(words->statements.at(3).id, "DGC-X-3");
  EXPECT_EQ(parse_statements("k.tsv", "code\trpm\n01\t1.12\n")->statements.at(0).id, "DGK-01");
}

TEST(ConformanceStatements, RefusesBrokenTables) {
  EXPECT_EQ(parse_statements("a.tsv", "id\tstatement\nDGS-001\n").error().line, 2U);
  EXPECT_EQ(parse_statements("a.tsv", "id\nA\nA\n").error().message, "the id A stands there twice");
  EXPECT_EQ(parse_statements("a.tsv", "name\nA\n").error().line, 1U);
  EXPECT_FALSE(parse_statements("a.tsv", ""));
}

std::vector<Claim> claims(std::string_view rows) {
  const auto parsed = parse_claims("c.tsv", "id\thow\ttext\n" + std::string(rows));
  EXPECT_TRUE(parsed);
  return parsed.value_or(std::vector<Claim>{});
}

TEST(ConformanceCoverage, CountsEveryStatementOnce) {
  const StatementTable table{"t", "t", {{"A", ""}, {"B", ""}, {"C", ""}, {"D", ""}, {"E", "text"}}};
  const TableCoverage coverage =
      coverage_of(table, {{"A", "B"}, {"B"}}, claims("A\tunit\tS.T\nC\tunit\tS.T\nD\treason\thardware\n"));
  EXPECT_EQ(
      summary_line(coverage),
      "t: 5 statements: 1 by a case, 1 by a unit test, 1 by a reason, 0 for later, 1 failed, 1 missing");
  ASSERT_EQ(coverage.missing.size(), 2U);
  EXPECT_EQ(coverage.missing[0].id, "B");
  EXPECT_EQ(coverage.missing[1].id, "E");
}

TEST(ConformanceCoverage, RefusesWrongClaims) {
  const auto errors = claim_errors({"A", "B"}, {{"A"}, {}},
                                   claims("A\treason\twhy\nB\tunit\tS.T\nB\tunit\tS.T\nC\tunit\tS.T\n"));
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(error_text(errors[0]), "c.tsv:2: A is said not to be provable or not yet, but a case proves it");
  EXPECT_EQ(error_text(errors[1]), "c.tsv:4: B is claimed twice");
  EXPECT_EQ(error_text(errors[2]), "c.tsv:5: there is no statement C");
  EXPECT_FALSE(parse_claims("c.tsv", "id\thow\ttext\nA\tperhaps\tx\n"));
  EXPECT_FALSE(parse_claims("c.tsv", "id\thow\ttext\nA\tunit\t\n"));
  EXPECT_FALSE(parse_claims("c.tsv", "A\tunit\tx\n"));
}

TEST(ConformanceCoverage, UnitClaimsNameTestsThatExist) {
  const std::string source = "TEST(Suite, First) {}\nTEST_F(Other,\n   Second) {}\n";
  const auto tests = tests_defined_in(source);
  EXPECT_EQ(tests, (std::set<std::string>{"Suite.First", "Other.Second"}));
  EXPECT_TRUE(unit_test_errors(claims("A\tunit\tSuite.First and Other.Second.\n"), tests).empty());
  const auto errors =
      unit_test_errors(claims("A\tunit\tSuite.Third\nB\tunit\tsomewhere\nC\treason\tno. 1\n"), tests);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(error_text(errors[0]), "c.tsv:2: there is no test Suite.Third");
  EXPECT_EQ(error_text(errors[1]), "c.tsv:3: the claim names no unit test (Suite.Test)");
}

/// Runs the only case of a text on the DGSHAPE controller.
std::string outcome(const std::string& text) {
  const CaseFile file = parse_cases("x.case", text);
  EXPECT_TRUE(file.errors.empty()) << error_text(file.errors.at(0));
  EXPECT_EQ(file.cases.size(), 1U);
  return run_case(file.cases.at(0), "dgshape");
}

TEST(ConformanceRun, PassesAndFailsByTheEvents) {
  const std::string head = "=== A\nids: A\n--- body\nG90G00X10.0\n--- expect\n";
  EXPECT_EQ(outcome(head + "rapid X=10 Y=0\nend\n"), "");
  EXPECT_NE(outcome(head + "rapid X=11 Y=0\nend\n"), "");
  EXPECT_NE(outcome(head + "end\n"), "");
  EXPECT_NE(outcome(head + "rapid X=10\n"), "");
}

TEST(ConformanceRun, FactsAreCompared) {
  const std::string head =
      "=== A\nids: A\nset: offsets.G54.X=2\nset: tools.1.radius=3\nideal: yes\n--- "
      "body\nG90F600.0G01X10.0\nM12\n"
      "--- expect\nlinear X=10 mX=12\nm 12\nend\n--- after\n";
  EXPECT_EQ(
      outcome(head + "W X=10\nM X=12\nmodal G01 G90 G54\nfeed=600\nspindle off\ntool=0\noffset G54 X=2\n"
                     "radius 1=3\noutput 12=off\ntime=1.2\nmotion_time=1.2\nat t=0.6 X=4\n"),
      "");
  for (const char* wrong :
       {"W X=12", "M X=10", "modal G00", "feed=300", "spindle on", "tool=1", "offset G54 X=0", "radius 1=2",
        "output 12=on", "time=1.3", "motion_time=1", "at t=0.6 X=5", "at t=9 X=10", "shift X=1", "n=1",
        "program=1", "register rpm=1", "length 1=1"}) {
    EXPECT_NE(outcome(head + wrong + "\n"), "") << wrong;
  }
}

TEST(ConformanceRun, ProgramsFollowEachOtherOnOneController) {
  const std::string text =
      "=== A\nids: A\n--- body\nG10L2P1X5.0\nG90G00X1.0\n--- expect\nrapid X=1 mX=6\nend\n"
      "--- body\nG90G00X2.0\n--- expect\nrapid X=2 sX=1 mX=7\nend\n";
  EXPECT_EQ(outcome(text), "");
  EXPECT_NE(outcome(text + "--- after\nsame\n"), "");
}

TEST(ConformanceRun, RefusedSettingsAreAnEvent) {
  const std::string text = "=== A\nids: A\nset: dgshape.decimal_point=maybe\n--- body\nG00\n--- expect\n";
  EXPECT_EQ(outcome(text + "refused dgshape.decimal_point\n"), "");
  EXPECT_NE(outcome(text + "end\n"), "");
  const std::string two =
      "=== A\nids: A\nset: axes.X.limits=[1,0]\nset: axes.Y.limits=[1,0]\n--- body\nG00\n";
  EXPECT_EQ(outcome(two + "--- expect\nrefused axes.X.limits\nrefused axes.Y.limits\n"), "");
  EXPECT_NE(outcome(two + "--- expect\nrefused axes.X.limits\n"), "");
}

TEST(ConformanceRun, ARefusalIsNamedByTheAlarmOfTheController) {
  const std::string text = "=== A\nids: A\nset: axes.X.limits=[1,0]\n--- body\nG00\n--- expect\n";
  const CaseFile file = parse_cases("x.case", text + "refused 0024H\n");
  ASSERT_EQ(file.cases.size(), 1U);
  EXPECT_EQ(run_case(file.cases.at(0), "melsec"), "");
}

TEST(ConformanceRun, OverridesChangeDuringTheRun) {
  const std::string text =
      "=== A\nids: A\nideal: yes\nduring: t=0.5 feed_override=50\n--- body\nG01X10.0F600.0\n--- "
      "expect\nlinear\nend\n"
      "--- after\n";
  EXPECT_EQ(outcome(text + "time=1.5\nat t=1.0 X=7.5\n"), "") << "5 mm at 10 mm/s, 5 mm at 5 mm/s";
  EXPECT_NE(outcome(text + "time=1.0\n"), "");
}

}  // namespace
}  // namespace kerf::conformance
