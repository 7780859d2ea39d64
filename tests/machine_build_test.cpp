// From settings to the machine of the stages below.

#include <gtest/gtest.h>

#include "machine/build_machine.hpp"
#include "machine_test_schema.hpp"

namespace kerf {
namespace {

using machine_test::mill_settings;

TEST(MachineBuild, Defaults) {
  const auto machine = build_machine(mill_settings());
  ASSERT_TRUE(machine);
  EXPECT_EQ(machine->name, "Machine");
  EXPECT_EQ(machine->cycle_s, 0.001);
  EXPECT_EQ(machine->axes, (AxisSet{Axis::X, Axis::Y, Axis::C}));
  const AxisSettings& c = (*machine)[Axis::C];
  EXPECT_EQ(c.number, 3);
  EXPECT_EQ(c.type, AxisType::rotary);
  EXPECT_EQ(c.lower_limit, -9999.9999);
  EXPECT_EQ(c.upper_limit, 9999.9999);
  EXPECT_EQ(c.rapid, 6000.0);
  EXPECT_EQ(c.max_feed, 7200.0);
  EXPECT_EQ(c.acceleration, 500.0);
  EXPECT_EQ(c.jerk, 8000.0);
  EXPECT_EQ((*machine)[Axis::X].type, AxisType::linear);
  EXPECT_EQ(machine->motion.law, "controller");
  EXPECT_EQ(machine->motion.junction_deviation, 0.01);
  EXPECT_EQ(machine->motion.servo_gain, 60.0);
  EXPECT_EQ(machine->motion.look_ahead, 1024);
}

TEST(MachineBuild, EveryValueFindsItsPlace) {
  Settings settings = mill_settings();
  ASSERT_TRUE(apply_toml(settings, R"([machine]
name = "Test"
cycle_ms = 0.5
[axes.Z]
number = 7
limits = [-300, 1]
rapid = 11
max_feed = 12
acceleration = 13
jerk = 14
home = -15
start = -16
[axes.A]
[offsets]
EXT.Z = 1
G54.Z = 2
G55.Z = 3
G56.Z = 4
G57.Z = 5
G58.Z = 6
G59 = { Z = 7, A = 8 }
[tools]
30 = { radius = 3.5 }
4 = { length = 40 }
[motion]
law = "optimal"
junction_deviation = 0
servo_gain = 33
look_ahead = 17
)",
                         "m.toml"));
  const auto machine = build_machine(settings);
  ASSERT_TRUE(machine);
  EXPECT_EQ(machine->name, "Test");
  EXPECT_EQ(machine->cycle_s, 0.0005);
  EXPECT_EQ(machine->axes, (AxisSet{Axis::Z, Axis::A}));
  const AxisSettings& z = (*machine)[Axis::Z];
  EXPECT_EQ(z.number, 7);
  EXPECT_EQ(z.lower_limit, -300.0);
  EXPECT_EQ(z.upper_limit, 1.0);
  EXPECT_EQ(z.rapid, 11.0);
  EXPECT_EQ(z.max_feed, 12.0);
  EXPECT_EQ(z.acceleration, 13.0);
  EXPECT_EQ(z.jerk, 14.0);
  EXPECT_EQ(z.home, -15.0);
  EXPECT_EQ(z.start, -16.0);
  for (std::size_t i = 0; i < kWorkOffsetCount; ++i) {
    EXPECT_EQ(machine->work_offsets[i][Axis::Z], static_cast<double>(i + 1));
  }
  EXPECT_EQ(machine->work_offsets[6][Axis::A], 8.0);
  EXPECT_EQ(machine->work_offsets[5][Axis::A], 0.0);
  EXPECT_EQ(machine->work_offsets[6][Axis::X], 0.0);
  ASSERT_EQ(machine->tools.size(), 3U);
  EXPECT_EQ(machine->tools[0].number, 2);
  EXPECT_EQ(machine->tools[0].radius, 3.0);
  EXPECT_EQ(machine->tools[1].number, 4);
  EXPECT_EQ(machine->tools[1].length, 40.0);
  EXPECT_EQ(machine->tools[2].number, 30);
  EXPECT_EQ(machine->tools[2].radius, 3.5);
  EXPECT_EQ(machine->motion.law, "optimal");
  EXPECT_EQ(machine->motion.junction_deviation, 0.0);
  EXPECT_EQ(machine->motion.servo_gain, 33.0);
  EXPECT_EQ(machine->motion.look_ahead, 17);
}

TEST(MachineBuild, LimitsAreCheckedWhenAllOptionsAreKnown) {
  Settings settings = mill_settings();
  ASSERT_TRUE(apply_assignment(settings, "axes.X.limits=[5,10]"));
  ASSERT_TRUE(apply_assignment(settings, "axes.X.start=6"));
  EXPECT_TRUE(build_machine(settings));
  ASSERT_TRUE(apply_assignment(settings, "axes.X.start=11"));
  const auto machine = build_machine(settings);
  ASSERT_FALSE(machine);
  ASSERT_EQ(machine.error().size(), 1U);
  EXPECT_EQ(error_text(machine.error()[0]),
            "--set axes.X.start: 'axes.X.start' = 11.0 lies outside 'axes.X.limits' = [5.0, 10.0]; give "
            "'axes.X.start' "
            "a value within the limits");
}

TEST(MachineBuild, ContradictionsNameTheFile) {
  Settings settings = mill_settings();
  ASSERT_TRUE(apply_toml(
      settings, "[axes.X]\nnumber = 1\nlimits = [-9, 9]\nstart = 9\n[axes.Y]\nnumber = 2\n", "m.toml"));
  ASSERT_TRUE(apply_assignment(settings, "axes.X.limits=[-8,8]"));
  ASSERT_TRUE(apply_assignment(settings, "axes.Y.number=1"));
  const auto machine = build_machine(settings);
  ASSERT_FALSE(machine);
  ASSERT_EQ(machine.error().size(), 2U);
  EXPECT_EQ(error_text(machine.error()[0]).substr(0, 28), "m.toml:4:9: 'axes.X.start' =");
  EXPECT_EQ(error_text(machine.error()[1]),
            "--set axes.Y.number: 'axes.Y.number' and 'axes.X.number' are both 1; each axis has a servo "
            "number of its "
            "own");
}

TEST(MachineBuild, NeedsAnAxis) {
  const auto machine = build_machine(Settings::defaults(Schema{common_parameters(), {}, {}, {}}));
  ASSERT_FALSE(machine);
  EXPECT_EQ(error_text(machine.error()[0]), "the machine has no axis; give at least one [axes.X] table");
}

}  // namespace
}  // namespace kerf
