// Machine files: values, which axes a file leaves, and every kind of error with its place.

#include <gtest/gtest.h>
#include <string>

#include "machine/settings_file.hpp"
#include "machine_test_schema.hpp"

namespace kerf {
namespace {

using machine_test::errors_of;
using machine_test::mill_settings;
using Errors = std::vector<std::string>;

TEST(MachineFile, SetsEveryKindOfValue) {
  Settings settings = mill_settings();
  const Errors errors = errors_of(settings, R"(dialect = "mill"
[machine]
name = "Mill \"7\""
cycle_ms = 2
[axes.X]
number = 3
type = "linear"
limits = [-10, 250.5]
rapid = 8000
[axes.A]
start = 90
[offsets]
EXT = { X = 1.5 }
G54 = { X = 500, A = -45.0 }
[offsets.G59]
A = 7
[tools]
1.radius = 5.0
[tools.12]
length = -100
[motion]
law = "optimal"
look_ahead = 16
[mill]
decimal_point = "all"
optional_stop = true
[mill.axis.A]
time_constant = 50
[mill.work]
interference_check = 2
)");
  ASSERT_EQ(errors, Errors{});
  EXPECT_EQ(settings.text("machine.name"), "Mill \"7\"");
  EXPECT_EQ(settings.number("machine.cycle_ms"), 2.0);
  EXPECT_EQ(settings.integer("axes.X.number"), 3);
  EXPECT_EQ(settings.pair("axes.X.limits"), (std::array{-10.0, 250.5}));
  EXPECT_EQ(settings.number("axes.X.rapid"), 8000.0);
  EXPECT_EQ(settings.number("axes.A.start"), 90.0);
  EXPECT_EQ(settings.number("offsets.EXT.X"), 1.5);
  EXPECT_EQ(settings.number("offsets.EXT.A"), 0.0);
  EXPECT_EQ(settings.number("offsets.G54.X"), 500.0);
  EXPECT_EQ(settings.number("offsets.G54.A"), -45.0);
  EXPECT_EQ(settings.number("offsets.G59.A"), 7.0);
  EXPECT_EQ(settings.number("tools.1.radius"), 5.0);
  EXPECT_EQ(settings.number("tools.1.length"), 0.0);
  EXPECT_EQ(settings.number("tools.12.length"), -100.0);
  EXPECT_EQ(settings.text("motion.law"), "optimal");
  EXPECT_EQ(settings.integer("motion.look_ahead"), 16);
  EXPECT_EQ(settings.text("mill.decimal_point"), "all");
  EXPECT_TRUE(settings.boolean("mill.optional_stop"));
  EXPECT_EQ(settings.number("mill.axis.A.time_constant"), 50.0);
  EXPECT_EQ(settings.text("mill.work.interference_check"), "avoid");
}

TEST(MachineFile, AxisTablesReplaceTheAxesOfTheDefaults) {
  Settings settings = mill_settings();
  ASSERT_TRUE(apply_toml(settings, "[axes.Z]\n[axes.X]\nhome = 1\n[offsets.G54]\nZ = 3\n", "m.toml"));
  EXPECT_EQ(settings.axes(), (AxisSet{Axis::X, Axis::Z}));
  EXPECT_FALSE(settings.contains("axes.Y.rapid"));
  EXPECT_FALSE(settings.contains("offsets.G54.C"));
  // A key left out still has the dialect's default for that axis.
  EXPECT_EQ(settings.number("axes.X.rapid"), 20000.0);
  EXPECT_EQ(settings.tool_numbers(), (std::set<std::int32_t>{2}));
}

TEST(MachineFile, WithoutAxisTablesTheAxesStay) {
  Settings settings = mill_settings();
  ASSERT_TRUE(apply_toml(settings, "[axes]\n[tools.5]\n", "m.toml"));
  EXPECT_EQ(settings.axes(), (AxisSet{Axis::X, Axis::Y, Axis::C}));
  EXPECT_EQ(settings.tool_numbers(), (std::set<std::int32_t>{2, 5}));
  EXPECT_TRUE(apply_toml(settings, "", "m.toml"));
}

TEST(MachineFile, SectionsOfOtherDialectsArePassedOver) {
  EXPECT_EQ(errors_of("[lathe]\nanything = 1\n[lathe.deep.er]\nx = 1979-05-27\n[saw]\n"), Errors{});
  EXPECT_EQ(errors_of("[milk]\nanything = 1\n"),
            Errors{"m.toml:1:2: unknown key 'milk'; did you mean 'mill'?"});
  // Only at the top level.
  EXPECT_EQ(errors_of("[machine]\nlathe = 1\n").size(), 1U);
}

TEST(MachineFile, UnknownKeyWithTheNearest) {
  EXPECT_EQ(errors_of("[axes.X]\nrapid = 1\nrapit = 5\n"),
            Errors{"m.toml:3:1: unknown key 'axes.X.rapit'; did you mean 'axes.X.rapid'?"});
  EXPECT_EQ(errors_of("[axis.X]\nrapid = 5\n"),
            Errors{"m.toml:1:2: unknown key 'axis'; did you mean 'axes'?"});
  EXPECT_EQ(errors_of("[axes.X]\n  max_speed = 5\n"),
            Errors{"m.toml:2:3: unknown key 'axes.X.max_speed'; did you mean 'axes.X.max_feed'?"});
  EXPECT_EQ(errors_of("[axes.X]\naccel = 5\n"),
            Errors{"m.toml:2:1: unknown key 'axes.X.accel'; did you mean 'axes.X.acceleration'?"});
  EXPECT_EQ(errors_of("cycle_ms = 5\n"),
            Errors{"m.toml:1:1: unknown key 'cycle_ms'; did you mean 'machine.cycle_ms'?"});
  EXPECT_EQ(errors_of("[machine]\nvendor = 5\n"),
            Errors{"m.toml:2:1: unknown key 'machine.vendor'; known here: name, cycle_ms"});
  EXPECT_EQ(errors_of("[mill.axis.C]\ntime_constnat = 5\n"),
            Errors{"m.toml:2:1: unknown key 'mill.axis.C.time_constnat'; did you mean "
                   "'mill.axis.C.time_constant'?"});
  EXPECT_EQ(errors_of("[offsets]\nG54 = { X = 1, q = 2 }\n"),
            Errors{"m.toml:2:16: 'q' in 'offsets.G54.q' is no axis; axes are X Y Z A B C U V W"});
  EXPECT_EQ(errors_of("axes.X.\"rapid.mm\" = 1\n").at(0).substr(0, 45),
            "m.toml:1:8: unknown key 'axes.X.\"rapid.mm\"'; ");
}

TEST(MachineFile, AxisAndToolNames) {
  EXPECT_EQ(errors_of("[axes.x]\n"),
            Errors{"m.toml:1:7: 'x' in 'axes.x' is no axis; did you mean 'axes.X'?"});
  EXPECT_EQ(errors_of("[axes.Q]\n"),
            Errors{"m.toml:1:7: 'Q' in 'axes.Q' is no axis; axes are X Y Z A B C U V W"});
  EXPECT_EQ(errors_of("[tools.0]\nradius = 1\n"),
            Errors{"m.toml:1:8: tool number 0 cannot be set; compensation number 0 is always 0; number tools "
                   "from 1"});
  EXPECT_EQ(
      errors_of("[tools]\nradius = 1\n"),
      Errors{"m.toml:2:1: 'radius' in 'tools.radius' is no tool number; tool numbers are 1 to 9999, without "
             "leading zeros"});
  EXPECT_EQ(errors_of("[tools.10000]\n").size(), 1U);
  EXPECT_EQ(errors_of("[tools.07]\n").size(), 1U);
  EXPECT_EQ(errors_of("[tools.9999]\n").size(), 0U);
}

TEST(MachineFile, AxisTheMachineLacks) {
  EXPECT_EQ(errors_of("[offsets]\nG54 = { X = 1, B = 2 }\n"),
            Errors{"m.toml:2:16: 'offsets.G54.B': the machine has no axis B; its axes are X Y C; "
                   "add an [axes.B] table beside those of all other axes"});
  EXPECT_EQ(errors_of("[mill.axis.Z]\ntime_constant = 5\n").at(0).substr(0, 46),
            "m.toml:1:12: 'mill.axis.Z': the machine has no");
  // The order in the file does not matter.
  EXPECT_EQ(errors_of("[offsets.G54]\nB = 2\n[mill.axis.B]\n[axes.B]\n"), Errors{});
}

TEST(MachineFile, WrongTypes) {
  EXPECT_EQ(errors_of("[axes.X]\nrapid = \"fast\"\n"),
            Errors{"m.toml:2:9: 'axes.X.rapid' takes a number, not a text; for example 6000.0"});
  EXPECT_EQ(errors_of("[axes.X]\nrapid = 1979-05-27\n"),
            Errors{"m.toml:2:9: 'axes.X.rapid' takes a number, not a date; for example 6000.0"});
  EXPECT_EQ(errors_of("[motion]\nlook_ahead = 100.0\n"),
            Errors{"m.toml:2:14: 'motion.look_ahead' takes an integer, not a number; for example 1024"});
  EXPECT_EQ(errors_of("[motion]\nlaw = true\n"),
            Errors{"m.toml:2:7: 'motion.law' takes a word, not a boolean; choose controller or optimal"});
  EXPECT_EQ(
      errors_of("[machine]\nname = 7\n"),
      Errors{"m.toml:2:8: 'machine.name' takes a text in quotes, not an integer; write the text between "
             "double quotes"});
  EXPECT_EQ(
      errors_of("[mill]\noptional_stop = 1\n"),
      Errors{"m.toml:2:17: 'mill.optional_stop' takes true or false, not an integer; for example false"});
  EXPECT_EQ(errors_of("[axes.X]\nlimits = 5\n"),
            Errors{"m.toml:2:10: 'axes.X.limits' takes two numbers [low, high], not an integer; for example "
                   "[-9999.9999, 9999.9999]"});
  for (const char* limits : {"[]", "[1]", "[1, 2, 3]", "[1, \"2\"]", "[[1, 2], [3, 4]]", "{ low = 1 }"}) {
    const Errors errors = errors_of(std::string("[axes.X]\nlimits = ") + limits + "\n");
    ASSERT_EQ(errors.size(), 1U) << limits;
    EXPECT_EQ(errors[0].substr(0, 58), "m.toml:2:10: 'axes.X.limits' takes two numbers [low, high]")
        << limits;
  }
  EXPECT_EQ(errors_of("[[axes]]\nX = 1\n").size(), 1U);
  EXPECT_EQ(errors_of("[axes]\nX = 5\n"),
            Errors{"m.toml:2:5: 'axes.X' is a section and has no value of its own; set one of its keys"});
  EXPECT_EQ(errors_of("[axes]\nB = 5\n").size(), 1U);
  EXPECT_EQ(errors_of("motion = \"optimal\"\n"),
            Errors{"m.toml:1:10: 'motion' is a section and has no value of its own; set one of its keys"});
  EXPECT_EQ(errors_of("[machine.name]\nx = 1\n").size(), 1U);
}

TEST(MachineFile, ValuesOutOfRange) {
  EXPECT_EQ(errors_of("[machine]\ncycle_ms = 0.01\n"),
            Errors{"m.toml:2:12: 'machine.cycle_ms' = 0.01 is out of range; the range is 0.05 to 100 ms"});
  EXPECT_EQ(
      errors_of("[axes.X]\nrapid = 0\n"),
      Errors{"m.toml:2:9: 'axes.X.rapid' = 0.0 is out of range; the range is above 0, at most 1e12 mm/min"});
  EXPECT_EQ(errors_of("[motion]\nlook_ahead = 15\n"),
            Errors{"m.toml:2:14: 'motion.look_ahead' = 15 is out of range; the range is 16 to 1e6 blocks"});
  EXPECT_EQ(errors_of("[axes.X]\nrapid = 1e12\nacceleration = 1e12\n"), Errors{});
  for (const char* number : {"nan", "-nan", "inf", "-inf", "1e13", "-1"}) {
    EXPECT_EQ(errors_of(std::string("[axes.X]\nrapid = ") + number + "\n").size(), 1U) << number;
  }
  EXPECT_EQ(errors_of("[axes.X]\nlimits = [nan, 5]\n").size(), 1U);
  // An integer that no double holds exactly is still compared with the range.
  EXPECT_EQ(errors_of("[axes.X]\nlimits = [-9007199254740993, 5]\n").at(0).substr(0, 30),
            "m.toml:2:10: 'axes.X.limits' =");
}

TEST(MachineFile, BadWords) {
  EXPECT_EQ(errors_of("[motion]\nlaw = \"fast\"\n"),
            Errors{"m.toml:2:7: 'motion.law' cannot be \"fast\"; choose controller or optimal"});
  EXPECT_EQ(errors_of("[motion]\nlaw = 1\n"),
            Errors{"m.toml:2:7: 'motion.law' cannot be 1; choose controller or optimal"});
  EXPECT_EQ(
      errors_of("[mill.work]\ninterference_check = 3\n"),
      Errors{"m.toml:2:22: 'mill.work.interference_check' cannot be 3; choose alarm (0), invalid (1) or "
             "avoid (2)"});
}

TEST(MachineFile, Dialect) {
  EXPECT_EQ(errors_of("dialect = \"lathe\"\n"), Errors{});
  EXPECT_EQ(errors_of("dialect = \"milling\"\n"),
            Errors{"m.toml:1:11: unknown dialect 'milling'; dialects are mill, lathe, saw"});
  EXPECT_EQ(dialect_of("[axes.X]\nrapit = 1\n[a]\ndialect = \"x\"\n", "mill.toml").has_value(), false);
  EXPECT_EQ(dialect_of("# c\ndialect = \"saw\"\n[nonsense]\nx = 1\n", "mill.toml")->name, "saw");
  EXPECT_EQ(dialect_of("dialect = 5\n", "mill.toml").has_value(), false);
  EXPECT_EQ(dialect_of("dialect = \"saw\"\nnot toml", "mill.toml").has_value(), false);
}

TEST(MachineFile, RelationsBetweenKeys) {
  EXPECT_EQ(
      errors_of("[axes.X]\nlimits = [10, -10]\n"),
      Errors{"m.toml:2:10: 'axes.X.limits' = [10.0, -10.0]: the low value is not below the high value; write "
             "[low, high]"});
  EXPECT_EQ(errors_of("[axes.X]\nlimits = [10, 10]\n").size(), 1U);
  // A rotary axis with equal limits turns without end, so it may start anywhere.
  EXPECT_EQ(errors_of("[axes.C]\ntype = \"rotary\"\nlimits = [0, 0]\nstart = 90\n"), Errors{});
  EXPECT_EQ(errors_of("[axes.C]\ntype = \"rotary\"\nlimits = [1, 0]\n").size(), 1U);
  EXPECT_EQ(errors_of("[axes.X]\nlimits = [0, 10]\nstart = 10.5\n"),
            Errors{"m.toml:3:9: 'axes.X.start' = 10.5 lies outside 'axes.X.limits' = [0.0, 10.0]; give "
                   "'axes.X.start' a value within the limits"});
  EXPECT_EQ(errors_of("[axes.X]\nlimits = [0, 10]\nstart = 10\n"), Errors{});
  // The default start, 0, does not fit these limits.
  EXPECT_EQ(errors_of("[axes.X]\nlimits = [5, 10]\n").at(0).substr(0, 35),
            "m.toml:2:10: 'axes.X.start' = 0.0 l");
  EXPECT_EQ(
      errors_of("[axes.X]\nnumber = 2\n[axes.Z]\nnumber = 2\n"),
      Errors{"m.toml:4:10: 'axes.Z.number' and 'axes.X.number' are both 2; each axis has a servo number of "
             "its own"});
}

TEST(MachineFile, AMisunderstoodValueHasNoFollowingErrors) {
  // The start would lie outside the limits, had they been read.
  EXPECT_EQ(errors_of("[axes.X]\nlimits = [5, \"x\"]\nstart = 99999\n").size(), 1U);
}

TEST(MachineFile, SeveralErrorsInTheOrderOfTheFile) {
  Settings settings = mill_settings();
  const Errors errors = errors_of(settings, R"([motion]
law = "quick"
[axes.Y]
start = 20000
rapid = -1
[axes.X]
start = 20000
colour = "red"
[machine]
cycle_ms = 1000
[axes.C]
start = 20000
)");
  ASSERT_EQ(errors.size(), 5U);
  EXPECT_EQ(errors[0].substr(0, 13), "m.toml:2:7: '");
  EXPECT_EQ(errors[1].substr(0, 13), "m.toml:5:9: '");
  EXPECT_EQ(errors[2].substr(0, 20), "m.toml:8:1: unknown ");
  EXPECT_EQ(errors[3].substr(0, 15), "m.toml:10:12: '");
  EXPECT_EQ(errors[4].substr(0, 29), "m.toml:12:9: 'axes.C.start' =");
}

TEST(MachineFile, AFileWithErrorsChangesNothing) {
  Settings settings = mill_settings();
  ASSERT_EQ(errors_of(settings, "[machine]\nname = \"New\"\ncycle = 1\n[axes.Z]\n[tools.8]\n").size(), 1U);
  EXPECT_EQ(settings.text("machine.name"), "Machine");
  EXPECT_EQ(settings.axes(), (AxisSet{Axis::X, Axis::Y, Axis::C}));
  EXPECT_EQ(settings.tool_numbers(), (std::set<std::int32_t>{2}));
}

TEST(MachineFile, NumberOfErrorsIsBounded) {
  std::string text = "[machine]\n";
  for (int i = 0; i < 5000; ++i) text += "key" + std::to_string(i) + " = 1\n";
  EXPECT_EQ(errors_of(text).size(), 100U);
}

TEST(MachineFile, SyntaxErrors) {
  const auto place = [](std::string_view text) {
    Settings settings = mill_settings();
    const auto done = apply_toml(settings, text, "m.toml");
    if (done || done.error().size() != 1) return std::string("none");
    EXPECT_EQ(done.error()[0].message.substr(0, 16), "not valid TOML: ") << text;
    return std::to_string(done.error()[0].line) + ":" + std::to_string(done.error()[0].column);
  };
  EXPECT_EQ(place("[machine]\nname = \"a\"\nname = \"b\"\n"), "3:8");  // the second value
  EXPECT_EQ(place("[machine]\n[motion]\n[machine]\n"), "3:1");
  EXPECT_EQ(place("[machine]\ncycle_ms 5\n"), "2:10");  // where `=` is missing
  EXPECT_EQ(place("= 1\n"), "1:1");
  EXPECT_EQ(place("[machine]\nname = \"open\n"), "2:13");  // the end of the line
  EXPECT_EQ(place("[=]\n"), "1:2");
  EXPECT_EQ(place("\xFF"), "1:1");
  EXPECT_EQ(errors_of("[machine]\nname = \"a\"\nname = \"b\"\n"),
            Errors{"m.toml:3:8: not valid TOML: cannot redefine existing string 'name'"});
}

TEST(MachineFile, SizeIsBounded) {
  Settings settings = mill_settings();
  const std::string comment(kLargestMachineFile + 1, '#');
  EXPECT_EQ(errors_of(settings, comment),
            Errors{"m.toml: the file is larger than 16 MiB; a machine file is small text"});
  EXPECT_EQ(dialect_of(comment, "mill.toml").has_value(), false);
  EXPECT_TRUE(apply_toml(settings, std::string_view(comment).substr(0, 1000000), "m.toml"));
}

TEST(MachineFile, ErrorTextWithoutPlaceOrRemedy) {
  EXPECT_EQ(error_text({"", 0, 0, "no axis", "add one"}), "no axis; add one");
  EXPECT_EQ(error_text({"f", 0, 0, "too large", ""}), "f: too large");
  EXPECT_EQ(error_text({"f", 2, 3, "bad", "good"}), "f:2:3: bad; good");
}

}  // namespace
}  // namespace kerf
