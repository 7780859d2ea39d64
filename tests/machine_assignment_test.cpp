// `--set KEY=VALUE`.

#include <array>
#include <gtest/gtest.h>
#include <string>

#include "machine_test_schema.hpp"

namespace kerf {
namespace {

using machine_test::mill_settings;

std::string error_of(Settings& settings, std::string_view option) {
  const auto done = apply_assignment(settings, option);
  return done ? "" : error_text(done.error());
}

std::string error_of(std::string_view option) {
  Settings settings = mill_settings();
  return error_of(settings, option);
}

TEST(MachineAssignment, EveryKindOfValue) {
  Settings settings = mill_settings();
  for (const std::string_view option :
       {"axes.X.rapid=8000", "offsets.G54.X=10", "tools.1.radius=5", "mill.decimal_point=all",
        "axes.X.limits=[-10,100]", "machine.name=Mill 7", "motion.look_ahead=64", "mill.optional_stop=true",
        "mill.axis.C.time_constant=20.5", "mill.work.interference_check=2", "motion.law=\"optimal\""}) {
    EXPECT_EQ(error_of(settings, option), "") << option;
  }
  EXPECT_EQ(settings.number("axes.X.rapid"), 8000.0);
  EXPECT_EQ(settings.number("offsets.G54.X"), 10.0);
  EXPECT_EQ(settings.number("tools.1.radius"), 5.0);
  EXPECT_EQ(settings.text("mill.decimal_point"), "all");
  EXPECT_EQ(settings.pair("axes.X.limits"), (std::array{-10.0, 100.0}));
  EXPECT_EQ(settings.text("machine.name"), "Mill 7");
  EXPECT_EQ(settings.integer("motion.look_ahead"), 64);
  EXPECT_TRUE(settings.boolean("mill.optional_stop"));
  EXPECT_EQ(settings.number("mill.axis.C.time_constant"), 20.5);
  EXPECT_EQ(settings.text("mill.work.interference_check"), "avoid");
  EXPECT_EQ(settings.text("motion.law"), "optimal");
  EXPECT_EQ(settings.find("axes.X.rapid")->origin.kind, ValueOrigin::Kind::assignment);
}

TEST(MachineAssignment, BlanksQuotesAndEqualsSigns) {
  Settings settings = mill_settings();
  EXPECT_EQ(error_of(settings, " axes.X.limits = [ -1.5 , 2e1 ] "), "");
  EXPECT_EQ(settings.pair("axes.X.limits"), (std::array{-1.5, 20.0}));
  EXPECT_EQ(error_of(settings, "machine.name=\"a = b\""), "");
  EXPECT_EQ(settings.text("machine.name"), "a = b");
  EXPECT_EQ(error_of(settings, "machine.name=5"), "");
  EXPECT_EQ(settings.text("machine.name"), "5");
  EXPECT_EQ(error_of(settings, "machine.name="), "");
  EXPECT_EQ(settings.text("machine.name"), "");
}

TEST(MachineAssignment, OnlyAddsAxes) {
  Settings settings = mill_settings();
  EXPECT_EQ(error_of(settings, "axes.B.rapid=3600"), "");
  EXPECT_EQ(settings.axes(), (AxisSet{Axis::X, Axis::Y, Axis::B, Axis::C}));
  EXPECT_EQ(settings.number("axes.B.rapid"), 3600.0);
  EXPECT_EQ(settings.text("axes.B.type"), "rotary");
  EXPECT_EQ(error_of(settings, "offsets.G54.B=1"), "");
  EXPECT_EQ(error_of(settings, "mill.axis.B.time_constant=1"), "");
}

TEST(MachineAssignment, LaterOptionsWin) {
  Settings settings = mill_settings();
  ASSERT_TRUE(apply_toml(settings, "[tools.1]\nradius = 2\n", "m.toml"));
  EXPECT_EQ(error_of(settings, "tools.1.radius=3"), "");
  EXPECT_EQ(error_of(settings, "tools.1.radius=4"), "");
  EXPECT_EQ(settings.number("tools.1.radius"), 4.0);
}

TEST(MachineAssignment, ErrorsNameTheOption) {
  EXPECT_EQ(error_of("axes.X.rapid=fast"),
            "--set axes.X.rapid=fast: 'axes.X.rapid' takes a number, not a text; for example 6000.0");
  EXPECT_EQ(error_of("axes.X.rapid="),
            "--set axes.X.rapid=: 'axes.X.rapid' takes a number, not nothing; for example 6000.0");
  EXPECT_EQ(error_of("axes.X.rapid=-1"),
            "--set axes.X.rapid=-1: 'axes.X.rapid' = -1.0 is out of range; the range is above 0, at most "
            "1e12 mm/min");
  EXPECT_EQ(error_of("axes.X.rapit=1"),
            "--set axes.X.rapit=1: unknown key 'axes.X.rapit'; did you mean 'axes.X.rapid'?");
  EXPECT_EQ(error_of("axis.X.rapid=1"),
            "--set axis.X.rapid=1: unknown key 'axis.X.rapid'; did you mean 'axes.X.rapid'?");
  EXPECT_EQ(error_of("rapid=1"), "--set rapid=1: unknown key 'rapid'; did you mean 'axes.X.rapid'?");
  EXPECT_EQ(error_of("axes.x.rapid=1"),
            "--set axes.x.rapid=1: 'x' in 'axes.x.rapid' is no axis; did you mean 'axes.X.rapid'?");
  EXPECT_EQ(error_of("motion.law=fast"),
            "--set motion.law=fast: 'motion.law' cannot be \"fast\"; choose controller or optimal");
  EXPECT_EQ(error_of("axes.X.rapid"), "--set axes.X.rapid: no '='; write --set KEY=VALUE");
  EXPECT_EQ(error_of("axes.X=1"),
            "--set axes.X=1: 'axes.X' is a section and has no value of its own; set one of its keys");
  EXPECT_EQ(
      error_of("tools.0.radius=1"),
      "--set tools.0.radius=1: tool number 0 cannot be set; compensation number 0 is always 0; number tools "
      "from 1");
  EXPECT_EQ(error_of("offsets.G54.B=1"),
            "--set offsets.G54.B=1: 'offsets.G54.B': the machine has no axis B; its axes are X Y C; "
            "--set with any key of 'axes.B' adds the axis");
  EXPECT_EQ(error_of("lathe.chuck=1"),
            "--set lathe.chuck=1: 'lathe.chuck' is a setting of another dialect; leave it out");
  EXPECT_EQ(error_of("machine.name.x=1").substr(0, 58),
            "--set machine.name.x=1: unknown key 'machine.name.x'; did ");
}

TEST(MachineAssignment, MalformedOptions) {
  for (const std::string_view option :
       {"", "=", "=1", ".", ".=1", "axes.=1", "axes..rapid=1", "axes.X.limits=[", "axes.X.limits=[]",
        "axes.X.limits=[1,2,3]", "axes.X.limits=1,2", "mill.optional_stop=yes",
        "motion.look_ahead=99999999999999999999"}) {
    EXPECT_NE(error_of(option), "") << option;
  }
}

TEST(MachineAssignment, RefusedOptionsChangeNothing) {
  Settings settings = mill_settings();
  EXPECT_NE(error_of(settings, "axes.B.rapid=0"), "");
  EXPECT_NE(error_of(settings, "tools.7.radius=big"), "");
  EXPECT_EQ(settings.axes(), (AxisSet{Axis::X, Axis::Y, Axis::C}));
  EXPECT_EQ(settings.tool_numbers(), (std::set<std::int32_t>{2}));
}

TEST(MachineAssignment, TheDialectIsChosenElsewhere) {
  EXPECT_EQ(error_of("dialect=mill"), "");
  EXPECT_EQ(error_of("dialect=lathe"),
            "--set dialect=lathe: the dialect decides which settings there are; use the option --dialect");
}

}  // namespace
}  // namespace kerf
