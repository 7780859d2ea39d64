// kerf check on a folder of programs: the table, JUnit and SARIF.

#include <nlohmann/json.hpp>

#include "shell_test.hpp"

namespace kerf {
namespace {

class CheckFolder : public ShellTest {
 protected:
  void SetUp() override {
    ShellTest::SetUp();
    fs::create_directory(folder_ / "store");
  }

  void program(const std::string& name, const std::string& blocks) {
    file("store/" + name, "%\n" + blocks + "%\n");
  }

  /// Runs kerf inside the folder.
  Outcome kerf(const std::string& arguments) {
    return shell("cd " + folder_.string() + " && " + KERF_BINARY + " " + arguments);
  }
};

constexpr const char* kGood = "G90G00X10.\nM98P10\nM02\n";
constexpr const char* kSubprogram = "G01X20.F500.\nM99\n";

TEST_F(CheckFolder, GivesATableWithSubprogramsLeftToTheirCallers) {
  program("O001.gcd", kGood);
  program("O002.gcd", "G90G00X10.\nG02X20.R1.F100.\nG00X99999999.\nM02\n");
  program("O010.gcd", kSubprogram);
  program("O020.gcd", "G01X#1\nM99\n");
  const Outcome outcome = kerf("check store");
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  const std::size_t table = outcome.out.find("program ");
  ASSERT_NE(table, std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.substr(table),
            "program           alarms warnings     blocks  result\n"
            "store/O001.gcd         0        0          5  good\n"
            "store/O002.gcd         2        0          4  alarms\n"
            "store/O010.gcd         -        -          -  subprogram of store/O001.gcd\n"
            "store/O020.gcd         -        -          -  subprogram, not called: only read\n"
            "4 programs, 1 with alarms, 1 only read\n");
  EXPECT_NE(outcome.out.find("store/O002.gcd:3:"), std::string::npos);
  EXPECT_NE(outcome.out.find("0313H"), std::string::npos);
}

TEST_F(CheckFolder, TheOrderIsThatOfTheNamesHoweverManyThreads) {
  for (int i = 1; i <= 60; ++i) {
    std::string name = std::to_string(i);
    name.insert(0, 3 - name.size(), '0');
    program("O" + name + ".gcd", "G90G00X10.\nG05\nM02\n");
  }
  const Outcome first = kerf("check store");
  EXPECT_EQ(first.status, 1);
  EXPECT_LT(first.out.find("store/O001.gcd:3:1"), first.out.find("store/O002.gcd:3:1"));
  EXPECT_LT(first.out.find("store/O059.gcd:3:1"), first.out.find("store/O060.gcd:3:1"));
  EXPECT_EQ(kerf("check store").out, first.out);
}

TEST_F(CheckFolder, AnAlarmInASubprogramNamesItsOwnFile) {
  program("O001.gcd", kGood);
  program("O010.gcd", "G01X20.F500.\nG01Y5.5.\nM99\n");
  const Outcome outcome = kerf("check store --sarif check.sarif");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("store/O010.gcd:3:"), std::string::npos) << outcome.out;
  const auto log = nlohmann::json::parse(contents(folder_ / "check.sarif"));
  const auto& place = log["runs"][0]["results"][0]["locations"][0]["physicalLocation"];
  EXPECT_EQ(place["artifactLocation"]["uri"], "store/O010.gcd");
  EXPECT_EQ(place["region"]["startLine"], 3);
}

TEST_F(CheckFolder, WritesJUnitAndSarif) {
  program("O001.gcd", kGood);
  program("O002.gcd", "G90G05\nM02\n");
  program("O010.gcd", kSubprogram);
  const Outcome outcome = kerf("check store --junit check.xml --sarif check.sarif");
  EXPECT_EQ(outcome.status, 1);
  const std::string xml = contents(folder_ / "check.xml");
  EXPECT_NE(xml.find("<testsuite name=\"kerf check\" tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\">"),
            std::string::npos)
      << xml;
  EXPECT_NE(xml.find("<failure type=\"1FC3H 0307H\""), std::string::npos) << xml;
  const auto log = nlohmann::json::parse(contents(folder_ / "check.sarif"));
  EXPECT_EQ(log["version"], "2.1.0");
  const auto& run = log["runs"][0];
  EXPECT_EQ(run["tool"]["driver"]["name"], "kerf");
  ASSERT_EQ(run["results"].size(), 1U);
  EXPECT_EQ(run["results"][0]["ruleId"], "1FC3H 0307H");
  EXPECT_EQ(run["results"][0]["level"], "error");
  EXPECT_EQ(run["tool"]["driver"]["rules"][0]["id"], "1FC3H 0307H");
}

TEST_F(CheckFolder, AProgramThatReturnsToItselfIsCheckedOnce) {
  program("O001.gcd", kSubprogram);
  const Outcome outcome = kerf("check store/O001.gcd");
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_NE(outcome.out.find("2 blocks executed"), std::string::npos) << outcome.out;
}

TEST_F(CheckFolder, ALoopOfLinksAndAnEndlessNameAreNoCrash) {
  program("O001.gcd", "M98P2\nM02\n");
  fs::create_symlink("O002.gcd", folder_ / "store" / "O002.gcd");
  for (const char* command : {"check store/O001.gcd", "path store/O001.gcd", "check store"}) {
    const Outcome outcome = kerf(command);
    EXPECT_EQ(outcome.status, 1) << command << outcome.err;
    EXPECT_NE((outcome.out + outcome.err).find("031FH"), std::string::npos) << command;
  }
  const std::string name(5000, 'x');
  EXPECT_EQ(kerf("check " + name).status, 2);
  EXPECT_EQ(kerf("check --program-dir " + name + " store/O001.gcd").status, 2);
}

TEST_F(CheckFolder, OneMistakeGivesOneAlarm) {
  // The end, the return, the move and the centre of a refused block still count.
  program("O001.gcd", "G90G01X10.\nM98P10\nG01X[1/0]\nM02\n");
  program("O010.gcd", "X999999. M99\n");
  program("O002.gcd", "G90G01X10. M02\n");
  const Outcome outcome = kerf("check store --set axes.X.limits=[-100,100]");
  EXPECT_EQ(outcome.out.find("0309H"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("0319H"), std::string::npos) << outcome.out;
  program("O003.gcd", "G90G00X0.Y0.Z0.\nG68X90.Y0.R0.D99\nZ0.\nG91X20.\nG90G53X90.D99\nG91G00X5.\nM02\n");
  const Outcome centre = kerf("check store/O003.gcd --set axes.X.limits=[-100,100]");
  EXPECT_EQ(centre.out.find("0221H"), std::string::npos) << centre.out;
}

TEST_F(CheckFolder, EachAxisThatLeavesItsTravelIsTold) {
  program("O001.gcd", "G90G00X200.\nY500.\nX0.\nY600.\nM02\n");
  const Outcome outcome =
      kerf("check store/O001.gcd --set axes.X.limits=[-100,100] --set axes.Y.limits=[-100,100]");
  EXPECT_NE(outcome.out.find("X would reach 200"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Y would reach 500"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("Y would reach 600"), std::string::npos) << outcome.out;
}

TEST_F(CheckFolder, SarifNamesPlacesAsItsReadersCount) {
  std::ofstream(folder_ / "store" / "my #1 part.nc", std::ios::binary)
      << "%\n(\xC3\xA9\xC3\xA9) G999\nM02\n%\n";
  EXPECT_EQ(kerf("check store --dialect dgshape --sarif check.sarif").status, 1);
  const auto log = nlohmann::json::parse(contents(folder_ / "check.sarif"));
  const auto& place = log["runs"][0]["results"][0]["locations"][0]["physicalLocation"];
  EXPECT_EQ(place["artifactLocation"]["uri"], "store/my%20%231%20part.nc");
  EXPECT_EQ(place["region"]["startColumn"], 6);
  EXPECT_EQ(log["runs"][0]["columnKind"], "unicodeCodePoints");
}

TEST_F(CheckFolder, AFileIsTheSameHoweverItIsSpelled) {
  program("O001.gcd", kGood);
  program("O010.gcd", kSubprogram);
  for (const char* command : {"check store//", "check store --program-dir ./store"}) {
    EXPECT_NE(kerf(command).out.find("subprogram of"), std::string::npos) << command;
  }
  EXPECT_EQ(kerf("check store/O001.gcd --junit store/O010.gcd").status, 2) << "it is called by O001";
}

TEST_F(CheckFolder, RefusesAFolderWithoutProgramsAndOutputsOverInputs) {
  const Outcome empty = kerf("check store");
  EXPECT_EQ(empty.status, 2);
  EXPECT_NE(empty.err.find("no NC program"), std::string::npos) << empty.err;
  program("O001.gcd", kGood);
  EXPECT_EQ(kerf("check store --junit store/O001.gcd").status, 2);
  EXPECT_EQ(contents(folder_ / "store" / "O001.gcd"), "%\n" + std::string(kGood) + "%\n");
  EXPECT_EQ(kerf("check store --junit same --sarif same").status, 2);
  EXPECT_EQ(kerf("check store --junit missing/check.xml").status, 2);
}

// MPF-228, MMA-386
TEST_F(CheckFolder, AllProgramsTogetherHaveRoomInTheController) {
  const std::string comment = "(" + std::string(98, 'x') + "\n";
  std::string filling;
  while (filling.size() < 510000) filling += comment;
  for (const char* name : {"O001.gcd", "O002.gcd", "O003.gcd", "O004.gcd"}) program(name, filling + "M02\n");
  EXPECT_EQ(kerf("check store").status, 0);
  program("O005.gcd", filling + "M02\n");
  program("O006.gcd", "M02\n");
  const Outcome outcome = kerf("check store");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out.find("0041H"), outcome.out.rfind("0041H")) << outcome.out;
  EXPECT_NE(outcome.out.find("store/O005.gcd:1:1"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("6 programs, 1 with alarms"), std::string::npos) << outcome.out;
}

TEST_F(CheckFolder, ACalledSubprogramThatHasNoRoomCountsWithItsAlarm) {
  const std::string comment = "(" + std::string(98, 'x') + "\n";
  std::string filling;
  while (filling.size() < 510000) filling += comment;
  for (const char* name : {"O001.gcd", "O002.gcd", "O003.gcd"}) program(name, filling + "M02\n");
  program("O004.gcd", filling + "M98P5\nM02\n");
  program("O005.gcd", filling + "M99\n");
  const Outcome outcome = kerf("check store");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("5 programs, 1 with alarms"), std::string::npos) << outcome.out;
}

// MPF-230, MMA-384
TEST_F(CheckFolder, ACalledFileThatCannotBeReadIsNoMissingProgram) {
  program("O001.gcd", "M98P2\nM98P3\nM02\n");
  fs::create_directory(folder_ / "store" / "O002.gcd");
  const Outcome outcome = kerf("check store/O001.gcd");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("store/O002.gcd:1:1"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1FC0H 0040H"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1FC3H 031FH"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("2 alarms"), std::string::npos) << outcome.out;
}

TEST_F(CheckFolder, ABadMachineFileIsToldOnce) {
  program("O001.gcd", kGood);
  program("O002.gcd", kGood);
  const Outcome outcome = kerf("check --set axes.X.rapid=-1 store");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("axes.X.rapid"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("kerf: "), outcome.err.rfind("kerf: ")) << outcome.err;
}

TEST_F(CheckFolder, WhatNobodyCallsIsReadAllTheSame) {
  program("O001.gcd", "G00X1.\nIF[0EQ0]GOTO10\nM98P5\nN10M02\n");
  program("O005.gcd", "QQQ GARBAGE ((\nG00X#1\nGOTO\nG05\nM99\n");
  program("O006.gcd", "G01X#1\nM99\n");
  const Outcome outcome = kerf("check --junit j.xml store");
  EXPECT_EQ(outcome.status, 1);
  for (const char* place : {"store/O005.gcd:2:", "store/O005.gcd:4:", "store/O005.gcd:5:"})
    EXPECT_NE(outcome.out.find(place), std::string::npos) << outcome.out;
  EXPECT_NE(
      outcome.out.find("store/O005.gcd         3        -          -  subprogram, not called: only read\n"),
      std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("3 programs, 1 with alarms, 2 only read\n"), std::string::npos) << outcome.out;
  const std::string junit = contents(folder_ / "j.xml");
  EXPECT_NE(junit.find("tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\""), std::string::npos) << junit;
  EXPECT_EQ(junit.find("<skipped"), junit.rfind("<skipped"));
}

TEST_F(CheckFolder, AFileThatIsNoProgramIsNamedInEveryOutput) {
  program("O001.gcd", kGood);
  program("O010.gcd", kSubprogram);
  file("store/O005.gcd", "");
  EXPECT_EQ(kerf("check --junit j.xml --sarif s.sarif store").status, 2);
  EXPECT_NE(contents(folder_ / "j.xml").find("<error message=\"not checked: store/O005.gcd is empty"),
            std::string::npos);
  const auto run = nlohmann::json::parse(contents(folder_ / "s.sarif")).at("runs").at(0);
  const auto& invocation = run.at("invocations").at(0);
  EXPECT_FALSE(invocation.at("executionSuccessful").get<bool>());
  EXPECT_EQ(invocation.at("toolExecutionNotifications").size(), 1U);
}

TEST_F(CheckFolder, AProgramThatGoesBackIsCheckedUntilItEnds) {
  program("O001.gcd", "#100=#100+1\nIF[#100EQ3]GOTO10\nG04P1\nM99\nN10G28X0.\nM02\n");
  const Outcome outcome = kerf(
      "check --set melsec.system.common_system_points=100 "
      "--set melsec.system.common_system_start_device=D2000 store/O001.gcd");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("O001.gcd:6:4: alarm 1FC3H 0307H"), std::string::npos) << outcome.out;
}

TEST_F(CheckFolder, AnAlarmInALoopIsToldOnce) {
  program("O001.gcd", "WHILE[#1LT1000]DO1\nG04P1Q5.\n#1=#1+1\nEND1\nG28\nM02\n");
  const Outcome outcome = kerf("check --set melsec.system.local_start_device=D7000 store");
  EXPECT_NE(outcome.out.find("O001.gcd: 2 alarms"), std::string::npos) << outcome.out;
}

TEST_F(CheckFolder, NamesThatTheControllerDoesNotKnowAreTold) {
  program("O001.gcd", "G04P1\nM02\n");
  program("O257.gcd", "G04P1\nM02\n");
  program("O002.GCD", "G04P1\nM02\n");
  const Outcome outcome = kerf("check --set melsec.system.arc_deviation=0.02 store");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("good; not one of O001.gcd to O256.gcd"), outcome.out.find("good; not one"))
      << outcome.out;
  EXPECT_NE(outcome.out.find("store/O257.gcd         0        0          2  good; not one of"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("store/O002.GCD         0        0          2  good; not one of"),
            std::string::npos)
      << outcome.out;
}

TEST_F(CheckFolder, AZeroByteIsNoEndOfABlock) {
  using namespace std::string_literals;
  program("O001.gcd", "M98P2\nM02\n");
  program("O002.gcd", "G91G00X1.\0G28\nM99\n"s);
  EXPECT_NE(kerf("check store/O001.gcd").out.find("1FC0H 0040H"), std::string::npos);
  const std::string long_comment = "(" + std::string(5000, 'x') + "\n";
  program("O003.gcd", long_comment + "G91G00X1.\0G28\nM02\n"s);
  EXPECT_NE(kerf("check store/O003.gcd").out.find("O003.gcd:3:10: alarm 1FC3H 0305H"), std::string::npos);
}

}  // namespace
}  // namespace kerf
