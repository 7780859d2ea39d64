// The kerf command as a user's shell sees it: exit status, standard output, standard error, files.

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "shell_test.hpp"

namespace kerf {
namespace {

using CommandLine = ShellTest;

constexpr std::string_view kGood = "%\nG21G90S5000M03F600.0\nG00X10.0\nG01X20.0Y5.0\nM02\n%\n";
constexpr std::string_view kBad = "%\nG21G90S5000M03F600.0\nG00X10.0\nG05X1.0\nG01X20.0\nG41X5.0\nM02\n%\n";

TEST_F(CommandLine, AGoodProgramPasses) {
  const Outcome outcome = kerf("check " + file("good.nc", kGood));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("no alarms, no warnings, 4 blocks executed"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(CommandLine, CheckFindsSeveralAlarmsInOnePass) {
  const Outcome outcome = kerf("check " + file("bad.nc", kBad));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("bad.nc:4:1"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("unknown-code"), std::string::npos);
  EXPECT_NE(outcome.out.find("bad.nc:6:1"), std::string::npos);
  EXPECT_NE(outcome.out.find("missing-word"), std::string::npos);
  EXPECT_NE(outcome.out.find("2 alarms"), std::string::npos);
}

TEST_F(CommandLine, MaxAlarmsEndsTheCheck) {
  const Outcome outcome = kerf("check --max-alarms 1 " + file("bad.nc", kBad));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out.find("missing-word"), std::string::npos);
}

TEST_F(CommandLine, PathStopsAtTheFirstAlarm) {
  const Outcome outcome = kerf("path --json " + file("bad.nc", kBad));
  EXPECT_EQ(outcome.status, 1);
  std::istringstream lines(outcome.out);
  std::string line;
  std::vector<nlohmann::json> events;
  while (std::getline(lines, line)) events.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0]["event"], "spindle");
  EXPECT_EQ(events[1]["event"], "move");
  EXPECT_EQ(events[1]["mode"], "rapid");
  EXPECT_EQ(events[1]["end"]["X"], 10.0);
  EXPECT_TRUE(events[1]["feed"].is_null());
  EXPECT_EQ(events[2]["event"], "alarm");
  EXPECT_EQ(events[2]["code"], "DGS");
  EXPECT_EQ(events[2]["detail"], "unknown-code");
  EXPECT_EQ(events[2]["line"], 4);
}

TEST_F(CommandLine, AnAlarmOfTheOffsetEndsTheProgramToo) {
  // The arc of radius 2 is too small for the tool of radius 3 on its inside.
  const std::string name =
      file("inner.nc",
           "%\nG21G90G17S1000M03F300.\nG01G42D1X0Y0\nX20.\nG02X22.Y-2.R2.\nG01Y-30.\nG40X40.\nM02\n%\n");
  const std::string machine = " --set tools.1.radius=3 --set axes.X.start=-20";
  const Outcome path = kerf("path --json " + name + machine);
  EXPECT_EQ(path.status, 1);
  EXPECT_EQ(path.out.find("\"end\"}"), std::string::npos) << path.out;
  EXPECT_EQ(path.out.find("\"line\":6"), std::string::npos) << path.out;
  EXPECT_NE(path.out.rfind("inner-arc-radius"), std::string::npos);
  const Outcome run = kerf("run --json " + name + machine);
  EXPECT_EQ(run.status, 1);
  // From X-20 to the point beside X0, and no farther than the start of the arc.
  EXPECT_LE(nlohmann::json::parse(run.out)["moves"], 2);
}

TEST_F(CommandLine, RunPrintsTheTimes) {
  const Outcome outcome = kerf("run --json --set axes.X.acceleration=1e9 --set axes.Y.acceleration=1e9 " +
                               file("good.nc", kGood));
  EXPECT_EQ(outcome.status, 0);
  const auto summary = nlohmann::json::parse(outcome.out);
  // 10 mm at 6000 mm/min, then the way of 10 and 5 mm at 600 mm/min.
  EXPECT_NEAR(summary["rapid_s"].get<double>(), 0.1, 1e-6);
  EXPECT_NEAR(summary["cutting_s"].get<double>(), std::hypot(10.0, 5.0) / 10.0, 1e-6);
  EXPECT_EQ(summary["blocks"], 4);
}

TEST_F(CommandLine, RunWritesItsFiles) {
  const Outcome outcome = kerf("run " + file("good.nc", kGood) + " --plot " + path("p.svg") + " --report " +
                               path("r.html") + " --trace " + path("t.csv"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(contents(folder_ / "p.svg").find("<svg"), std::string::npos);
  EXPECT_NE(contents(folder_ / "r.html").find("<html"), std::string::npos);
  const std::string trace = contents(folder_ / "t.csv");
  EXPECT_EQ(trace.substr(0, trace.find('\n')).find("t_s,line,feed_mm_min,X_cmd,X_act,X_vel"), 0U);
}

TEST_F(CommandLine, NoOutputFileIsLeftWhenItCannotBeWritten) {
  const Outcome outcome = kerf("run " + file("good.nc", kGood) + " --plot " + path("missing/p.svg"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_FALSE(outcome.err.empty());
  EXPECT_FALSE(fs::exists(folder_ / "missing"));
}

TEST_F(CommandLine, WhatIsNoProgramIsRefused) {
  fs::create_directory(folder_ / "folder");
  const std::string binary(
      "\x7f"
      "ELF\0\0\0\0%\nG1\n",
      14);
  for (const std::string& name : {path("missing.nc"), path("folder"), file("empty.nc", ""),
                                  file("blank.nc", "\n \n"), file("binary.nc", binary)}) {
    for (const char* command : {"check ", "path ", "run "}) {
      const Outcome outcome = kerf(command + name);
      EXPECT_EQ(outcome.status, 2) << command << name;
      EXPECT_NE(outcome.err.find("kerf: "), std::string::npos) << command << name;
    }
  }
}

TEST_F(CommandLine, OddTextsGiveAnAlarm) {
  EXPECT_EQ(kerf("check " + file("cr.nc", "%\rG21\rM02\r%\r")).status, 1);
  EXPECT_EQ(kerf("check " +
                 file("nul.nc", std::string("%\n", 2) + std::string(5000, ' ') + std::string("G\0\n", 3)))
                .status,
            1);
  EXPECT_EQ(kerf("check " + file("text.nc", "Dear machinist,\nplease drill a hole.\n")).status, 1);
  EXPECT_EQ(kerf("check " + file("crlf.nc", "%\r\nG21\r\nM02\r\n%\r\n")).status, 0);
  EXPECT_EQ(kerf("check " + file("bom.nc", "\xEF\xBB\xBF%\nG21\nM02\n%\n")).status, 0);
}

TEST_F(CommandLine, ProgramsAreConvertedToIntermediateCode) {
  const std::string program = file("1000.nc", "N01 G04 P100\nN02 M99 // End of subprogram\n");
  const Outcome shown = kerf("convert --to pmc " + program);
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.out, "open subprog 1000\nN1 G04 P100 M999.002\nN2 M99 M999.002\nreturn\nclose\n");
  const std::string written = file("out.pmc", "old");
  EXPECT_EQ(kerf("convert --to pmc --number 7 " + program + " -o " + written).status, 0);
  EXPECT_EQ(contents(written), "open prog 7\nN1 G04 P100 M999.002\nN2 M99 M999.002\nreturn\nclose\n");

  // What is wrong is told, and an older result stays.
  const Outcome faulty = kerf("convert --to pmc " + file("bad.nc", "G01 X\n") + " -o " + written);
  EXPECT_EQ(faulty.status, 1);
  EXPECT_NE(faulty.err.find("bad.nc:1:6"), std::string::npos) << faulty.err;
  EXPECT_EQ(contents(written).substr(0, 11), "open prog 7");
  EXPECT_EQ(kerf("convert --to xyz " + program).status, 2);
  EXPECT_EQ(kerf("convert --to pmc " + file("good.nc", kGood)).status, 2);
  EXPECT_EQ(kerf("convert --to pmc " + program + " -o " + program).status, 2);
}

TEST_F(CommandLine, BlockSkipsByNumber) {
  const std::string program = file("skip.nc", "G01 F100\n/1 X1\n/2 X2\nM30\n");
  EXPECT_NE(kerf("path --quiet " + program).out.find("moves 2"), std::string::npos);
  EXPECT_NE(kerf("path --quiet --block-skip=2 " + program).out.find("moves 1"), std::string::npos);
  EXPECT_NE(kerf("path --quiet --block-skip=1 --block-skip=2 " + program).out.find("moves 0"),
            std::string::npos);
  EXPECT_NE(kerf("path --quiet --block-skip " + program).out.find("moves 0"), std::string::npos);
  EXPECT_EQ(kerf("path --block-skip=32 " + program).status, 2);
  EXPECT_EQ(kerf("path --block-skip=2 " + file("good.nc", kGood)).status, 2);
}

TEST_F(CommandLine, WrongUsage) {
  EXPECT_EQ(kerf("").status, 2);
  const Outcome typo = kerf("chekc x.nc");
  EXPECT_EQ(typo.status, 2);
  EXPECT_NE(typo.err.find("kerf check"), std::string::npos) << typo.err;
  EXPECT_EQ(kerf("check").status, 2);
  EXPECT_EQ(kerf("path --json --quiet " + file("good.nc", kGood)).status, 2);
  const Outcome key = kerf("check --set axes.X.rapit=1 " + file("good.nc", kGood));
  EXPECT_EQ(key.status, 2);
  EXPECT_NE(key.err.find("axes.X.rapid"), std::string::npos) << key.err;
}

TEST_F(CommandLine, NearMissesGetAProposal) {
  const std::string good = file("good.nc", kGood);
  const auto says = [&](const std::string& arguments, std::string_view proposal) {
    const Outcome outcome = kerf(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.err.find(proposal), std::string::npos) << outcome.err;
  };
  says("check --dialekt dgshape " + good, "--dialect");
  says("check --dialect dgshap " + good, "did you mean dgshape?");
  says("machine shwo", "`kerf machine show`");
  says("alarms arc-radus", "did you mean arc-radius?");
  says("check --color sometimes " + good, "auto, always or never");
  says("check --program-dir " + path("missing") + " " + good, "no folder");
}

TEST_F(CommandLine, AnOutputNeverOverwritesAnInputOrAnotherOutput) {
  const std::string good = file("good.nc", kGood);
  const std::string mill = file("mill.toml", "dialect = \"dgshape\"\n");
  fs::create_symlink(good, folder_ / "link.nc");
  fs::create_hard_link(good, folder_ / "hard.nc");
  for (const std::string& arguments :
       {"run " + good + " --plot " + good, "run " + good + " --report " + path("link.nc"),
        "run " + path("link.nc") + " --trace " + good, "run " + good + " --trace " + path("hard.nc"),
        "run --machine " + mill + " " + good + " --plot " + mill,
        "run " + good + " --plot " + path("new") + " --report " + path("./new"),
        "run " + good + " --plot -"}) {
    const Outcome outcome = kerf(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(contents(good), kGood) << arguments;
    EXPECT_EQ(contents(mill), "dialect = \"dgshape\"\n") << arguments;
    EXPECT_FALSE(fs::exists(folder_ / "new")) << arguments;
  }
  EXPECT_EQ(kerf("run " + good + " --plot /dev/null --report /dev/null").status, 0);
}

TEST_F(CommandLine, ALinkThatLeadsNowhereYetIsFollowed) {
  fs::create_symlink("real.svg", folder_ / "link.svg");
  EXPECT_EQ(kerf("run " + file("good.nc", kGood) + " --plot " + path("link.svg")).status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.svg"));
  EXPECT_NE(contents(folder_ / "real.svg").find("<svg"), std::string::npos);
}

TEST_F(CommandLine, ALineOfYearsIsRunInNoTime) {
  // 9000 mm at 0.001 mm/min and back.
  const Outcome outcome = kerf("run --json --set dgshape.feed_min=0.001 " +
                               file("slow.nc", "%\nG21G90S5M03\nG01X9000.0F0.001\nX0\nM02\n%\n"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NEAR(nlohmann::json::parse(outcome.out)["time_s"].get<double>() / (2.0 * 9000.0 / 0.001 * 60.0), 1.0,
              1e-6);
}

TEST_F(CommandLine, TheLetterOForADigitIsNamed) {
  const Outcome outcome = kerf("check " + file("letter.nc", "%\nG21G90\nGO1X5.0\nM02\n%\n"));
  EXPECT_NE(outcome.out.find("letter O"), std::string::npos) << outcome.out;
}

TEST_F(CommandLine, AnInterruptedRunLeavesNoFile) {
  // A dwell of nine hours, paced by the clock.
  const std::string slow = file("slow.nc", "%\nG21G90\nG04X32400.0\nM02\n%\n");
  const Outcome outcome =
      shell(std::string(KERF_BINARY) + " run --realtime " + slow + " --trace " + path("t.csv") +
            " & pid=$!; until ls -A " + folder_.string() + " | grep -q tmp; do sleep 0.01; done;" +
            " kill -TERM $pid; wait $pid; status=$?; ls -A " + folder_.string() + "; exit $status");
  EXPECT_EQ(outcome.status, 143) << outcome.err;
  EXPECT_EQ(outcome.out.find(".tmp"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("t.csv"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
}

TEST_F(CommandLine, ALineOfManyMegabytesIsShownInPart) {
  std::string text = "%\nG21G90S5000M03F600.0\n";
  text += std::string(std::size_t{20} << 20, ' ') + "G05" + std::string(std::size_t{20} << 20, ' ');
  const Outcome outcome = kerf("check " + file("long.nc", text + "\nM02\n%\n"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("G05"), std::string::npos);
  EXPECT_LT(outcome.out.size(), 2000U);
}

TEST_F(CommandLine, HelpAndVersionAreNoErrors) {
  for (const char* command : {"", "check ", "path ", "run ", "codes ", "alarms ", "machine ", "machine init ",
                              "machine check ", "machine show "}) {
    const Outcome outcome = kerf(std::string(command) + "--help");
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_NE(outcome.out.find("Example"), std::string::npos) << command;
    EXPECT_NE(outcome.out.find("  kerf " + std::string(command)), std::string::npos) << command;
  }
  EXPECT_EQ(kerf("--version").out.substr(0, 5), "kerf ");
}

TEST_F(CommandLine, StandardInput) {
  EXPECT_EQ(kerf("check - <" + file("good.nc", kGood)).status, 0);
}

TEST_F(CommandLine, OptionalStopAndBlockSkip) {
  const std::string name = file("skip.nc", "%\nG21G90\n/G00X1.0\nM01\nM02\n%\n");
  EXPECT_NE(kerf("path --json " + name).out.find("\"move\""), std::string::npos);
  EXPECT_EQ(kerf("path --json --block-skip " + name).out.find("\"move\""), std::string::npos);
  EXPECT_EQ(kerf("path --json " + name).out.find("\"stop\""), std::string::npos);
  EXPECT_NE(kerf("path --json --optional-stop " + name).out.find("\"stop\""), std::string::npos);
}

TEST_F(CommandLine, AlarmsAndCodes) {
  EXPECT_NE(kerf("alarms").out.find("arc-radius"), std::string::npos);
  EXPECT_EQ(kerf("alarms arc-radius").status, 0);
  EXPECT_EQ(kerf("alarms no-such-alarm").status, 2);
  // Without a dialect asked for, that of any controller.
  EXPECT_EQ(kerf("alarms 0313H").status, 0);
  EXPECT_EQ(kerf("alarms --dialect dgshape 0313H").status, 2);
  EXPECT_NE(kerf("codes").out.find("G83"), std::string::npos);
  std::istringstream lines(kerf("codes --json").out);
  std::string line;
  while (std::getline(lines, line)) EXPECT_TRUE(nlohmann::json::accept(line)) << line;
}

TEST_F(CommandLine, MachineFiles) {
  EXPECT_EQ(kerf("machine init " + path("mill.toml")).status, 0);
  EXPECT_EQ(kerf("machine init " + path("mill.toml")).status, 2) << "an existing file stays";
  EXPECT_EQ(kerf("machine check " + path("mill.toml")).status, 0);
  EXPECT_EQ(kerf("check --machine " + path("mill.toml") + " " + file("good.nc", kGood)).status, 0);
  const Outcome bad = kerf("machine check " + file("bad.toml", "[axes.X]\nrapid = \"fast\"\n"));
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.err.find("bad.toml:2:"), std::string::npos) << bad.err;
  EXPECT_NE(kerf("machine show --set axes.X.rapid=8000").out.find("8000"), std::string::npos);
}

}  // namespace
}  // namespace kerf
