// The effective settings: defaults of a dialect, axes and tools that exist, typed reading.

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <limits>

#include "machine/settings.hpp"
#include "machine_test_schema.hpp"

namespace kerf {
namespace {

using machine_test::mill;
using machine_test::mill_settings;

TEST(MachineSettings, CommonDeclarationsAreSound) {
  const std::array axis{DefaultOverride{"axes.X.start", "0.0"}};
  EXPECT_EQ(schema_faults(Schema{common_parameters(), {}, axis, {}}), std::vector<std::string>{});
  EXPECT_EQ(schema_faults(mill()), std::vector<std::string>{});
}

TEST(MachineSettings, FaultyDeclarationsAreFound) {
  const std::array parameters{
      Parameter{.key = "m.a", .default_value = "1.0", .help = "A."},
      Parameter{.key = "m.a", .default_value = "1.0", .help = "A."},
      Parameter{.key = "m.b", .default_value = "5.0", .maximum = 4.0, .help = "B."},
      Parameter{
          .key = "m.c", .type = ValueType::word, .default_value = "\"x\"", .choices = "y|z", .help = "C."},
      Parameter{.key = "m.d", .type = ValueType::boolean, .default_value = "true"},
  };
  const std::array overrides{DefaultOverride{"axes.Q.rapid", "1.0"}, DefaultOverride{"axes.X.rapid", "-1.0"},
                             DefaultOverride{"axes.*.rapid", "\"fast\""}};
  const std::vector<std::string> faults =
      schema_faults(Schema{common_parameters(), parameters, overrides, {}});
  const std::vector<std::string> expected{
      "m.a is declared twice",
      "default of m.b: 'm.b' = 5.0 is out of range",
      "default of m.c: 'm.c' cannot be \"x\"",
      "m.d has no help",
      "override of axes.Q.rapid: no such key",
      "default of axes.X.rapid: 'axes.X.rapid' = -1.0 is out of range",
      "default of axes.*.rapid: 'axes.*.rapid' takes a number, not a text",
  };
  EXPECT_EQ(faults, expected);
}

TEST(MachineSettings, DefaultsNameAxesAndTools) {
  const Settings settings = mill_settings();
  EXPECT_EQ(settings.axes(), (AxisSet{Axis::X, Axis::Y, Axis::C}));
  EXPECT_EQ(settings.tool_numbers(), (std::set<std::int32_t>{2}));
  EXPECT_TRUE(settings.contains("axes.C.rapid"));
  EXPECT_TRUE(settings.contains("offsets.G59.C"));
  EXPECT_TRUE(settings.contains("mill.axis.C.time_constant"));
  EXPECT_TRUE(settings.contains("tools.2.length"));
  EXPECT_FALSE(settings.contains("axes.Z.rapid"));
  EXPECT_FALSE(settings.contains("offsets.G54.Z"));
  EXPECT_FALSE(settings.contains("mill.axis.Z.time_constant"));
  EXPECT_FALSE(settings.contains("tools.1.radius"));
  EXPECT_FALSE(settings.contains("axes.*.rapid"));
}

TEST(MachineSettings, OverridesComeBeforeDeclaredDefaults) {
  const Settings settings = mill_settings();
  EXPECT_EQ(settings.number("axes.X.rapid"), 20000.0);
  EXPECT_EQ(settings.number("axes.Y.rapid"), 15000.0);
  EXPECT_EQ(settings.number("axes.C.rapid"), 6000.0);
  EXPECT_EQ(settings.number("axes.C.max_feed"), 7200.0);
  EXPECT_EQ(settings.number("axes.Y.jerk"), 8000.0);
  EXPECT_EQ(settings.text("axes.X.type"), "linear");
  EXPECT_EQ(settings.text("axes.C.type"), "rotary");
  EXPECT_EQ(settings.number("tools.2.radius"), 3.0);
  EXPECT_EQ(settings.number("tools.2.length"), 0.0);
}

TEST(MachineSettings, ReadsEveryType) {
  const Settings settings = mill_settings();
  EXPECT_FALSE(settings.boolean("mill.optional_stop"));
  EXPECT_EQ(settings.integer("motion.look_ahead"), 1024);
  EXPECT_EQ(settings.number("motion.look_ahead"), 1024.0);
  EXPECT_EQ(settings.number("machine.cycle_ms"), 1.0);
  EXPECT_EQ(settings.text("mill.decimal_point"), "none");
  EXPECT_EQ(settings.text("machine.name"), "Machine");
  EXPECT_EQ(settings.pair("axes.X.limits"), (std::array{-9999.9999, 9999.9999}));
}

TEST(MachineSettingsDeathTest, UndeclaredKeyOrWrongTypeIsABug) {
  const Settings settings = mill_settings();
  EXPECT_DEATH(settings.number("axes.X.speed"), "no such key");
  EXPECT_DEATH(settings.boolean("axes.X.rapid"), "another type");
}

TEST(MachineSettings, ServoNumbersAreTheLowestLeft) {
  Settings settings = mill_settings();
  EXPECT_EQ(settings.integer("axes.X.number"), 1);
  EXPECT_EQ(settings.integer("axes.Y.number"), 2);
  EXPECT_EQ(settings.integer("axes.C.number"), 3);
  ASSERT_TRUE(apply_assignment(settings, "axes.C.number=1"));
  EXPECT_EQ(settings.integer("axes.X.number"), 2);
  EXPECT_EQ(settings.integer("axes.Y.number"), 3);
  ASSERT_TRUE(apply_assignment(settings, "axes.Z.rapid=100"));
  EXPECT_EQ(settings.integer("axes.Z.number"), 4);
}

TEST(MachineSettings, ServoNumberOfTheDialectIsPreferred) {
  const std::array overrides{DefaultOverride{"axes.X.number", "4"}, DefaultOverride{"axes.Y.start", "0.0"}};
  Settings settings = Settings::defaults(Schema{common_parameters(), {}, overrides, {}});
  EXPECT_EQ(settings.integer("axes.X.number"), 4);
  EXPECT_EQ(settings.integer("axes.Y.number"), 1);
  ASSERT_TRUE(apply_assignment(settings, "axes.Y.number=4"));
  EXPECT_EQ(settings.integer("axes.X.number"), 1);
}

TEST(MachineSettings, OrderIsThatOfTheDeclarations) {
  Settings settings = mill_settings();
  ASSERT_TRUE(apply_assignment(settings, "tools.10.radius=1"));
  std::vector<std::string> keys;
  for (const Setting* setting : settings.in_order()) keys.push_back(setting->key);
  const std::vector<std::string> expected_start{
      "dialect",       "machine.name", "machine.cycle_ms", "axes.X.number",       "axes.X.type",
      "axes.X.limits", "axes.X.rapid", "axes.X.max_feed",  "axes.X.acceleration", "axes.X.jerk",
      "axes.X.home",   "axes.X.start", "axes.Y.number"};
  ASSERT_GT(keys.size(), expected_start.size());
  EXPECT_TRUE(std::equal(expected_start.begin(), expected_start.end(), keys.begin()));
  const auto place = [&](std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) - keys.begin();
  };
  EXPECT_EQ(place("offsets.EXT.Y"), place("offsets.EXT.X") + 1);
  EXPECT_EQ(place("offsets.G54.X"), place("offsets.EXT.C") + 1);
  EXPECT_EQ(place("tools.2.length"), place("tools.2.radius") + 1);
  EXPECT_EQ(place("tools.10.radius"), place("tools.2.length") + 1);
  EXPECT_EQ(place("mill.axis.Y.time_constant"), place("mill.axis.X.time_constant") + 1);
  // 1 + 2 + 3 axes of 9 + 7 offsets of 3 axes + 2 tools of 2 + 4 motion + 2 + 3 + 1 of the dialect.
  EXPECT_EQ(keys.size(), 65U);
}

TEST(MachineSettings, TellsWhatWasSetExplicitly) {
  Settings settings = mill_settings();
  ASSERT_TRUE(apply_toml(settings, "[machine]\ncycle_ms = 1.0\n", "m.toml"));
  ASSERT_TRUE(apply_assignment(settings, "machine.name=Machine"));
  const Setting* cycle = settings.find("machine.cycle_ms");
  EXPECT_TRUE(cycle->is_explicit());
  EXPECT_EQ(cycle->origin.kind, ValueOrigin::Kind::file);
  EXPECT_EQ(cycle->origin.file, "m.toml");
  EXPECT_EQ(cycle->origin.line, 2U);
  EXPECT_EQ(cycle->origin.column, 12U);
  EXPECT_EQ(settings.find("machine.name")->origin.kind, ValueOrigin::Kind::assignment);
  EXPECT_FALSE(settings.find("motion.law")->is_explicit());
}

TEST(MachineSettings, SettingsAreValues) {
  Settings first = mill_settings();
  Settings second = first;
  ASSERT_TRUE(apply_assignment(second, "axes.X.rapid=1"));
  EXPECT_EQ(first.number("axes.X.rapid"), 20000.0);
  EXPECT_EQ(second.number("axes.X.rapid"), 1.0);
}

}  // namespace
}  // namespace kerf
