// The commented default machine file and the list of effective values.

#include "machine/machine_text.hpp"

#include <gtest/gtest.h>
#include <string>

#include "machine_test_schema.hpp"

namespace kerf {
namespace {

using machine_test::errors_of;
using machine_test::mill;
using machine_test::mill_settings;

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// Both hold the same keys with the same values.
void expect_same_values(const Settings& a, const Settings& b) {
  const auto left = a.in_order();
  const auto right = b.in_order();
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_EQ(left[i]->key, right[i]->key);
    EXPECT_EQ(left[i]->value, right[i]->value) << left[i]->key;
  }
}

TEST(MachineText, InitTextReadsBackToTheDefaults) {
  Settings settings = mill_settings();
  EXPECT_EQ(errors_of(settings, init_text(mill(), "mill")), std::vector<std::string>{});
  expect_same_values(settings, mill_settings());
  for (const Setting* setting : settings.in_order()) EXPECT_TRUE(setting->is_explicit()) << setting->key;
  EXPECT_EQ(dialect_of(init_text(mill(), "mill"), "mill.toml")->name, "mill");
}

TEST(MachineText, InitTextExplainsEveryKey) {
  const std::string text = init_text(mill(), "mill");
  for (const std::span<const Parameter> table : {mill().common, mill().dialect}) {
    for (const Parameter& parameter : table) EXPECT_TRUE(has(text, parameter.help)) << parameter.key;
  }
  EXPECT_TRUE(has(text,
                  "# Rapid traverse speed. (above 0, at most 1e12 mm/min; default 20000.0)\n"
                  "rapid        = 20000.0\n"));
  EXPECT_TRUE(has(text, "\n[axes.Y]\nnumber       = 2\ntype         = \"linear\"\n"));
  EXPECT_TRUE(has(text, "G54 = { X = 0.0, Y = 0.0, C = 0.0 }\n"));
  EXPECT_TRUE(has(text, "\n2 = { radius = 3.0, length = 0.0 }\n"));
  EXPECT_TRUE(has(
      text, "# What happens on interference. (alarm (0), invalid (1) or avoid (2); default \"alarm\")\n"));
}

TEST(MachineText, InitTextOfAMachineWithoutTools) {
  const std::array axis{DefaultOverride{"axes.Z.start", "0.0"}};
  const Schema schema{common_parameters(), {}, axis, {}};
  const std::string text = init_text(schema, "plain");
  EXPECT_TRUE(has(text, "\n[tools]\n"));
  EXPECT_TRUE(has(text, "\n# 1 = { radius = 0.0, length = 0.0 }\n"));
  Settings settings = Settings::defaults(schema);
  ASSERT_TRUE(apply_toml(settings, text, "m.toml"));
  EXPECT_TRUE(settings.tool_numbers().empty());
  EXPECT_EQ(settings.text("dialect"), "plain");
}

TEST(MachineText, TablesDeclaredInPiecesAreWrittenOnce) {
  const std::array parameters{
      Parameter{.key = "m.system.a", .default_value = "1.0", .help = "A."},
      Parameter{.key = "m.axis.*.b", .default_value = "2.0", .help = "B."},
      Parameter{.key = "m.system.c", .default_value = "3.0", .help = "C."},
  };
  const std::array axis{DefaultOverride{"axes.Z.start", "0.0"}};
  const Schema schema{common_parameters(), parameters, axis, {}};
  Settings settings = Settings::defaults(schema);
  EXPECT_EQ(errors_of(settings, init_text(schema, "m")), std::vector<std::string>{});
  EXPECT_TRUE(has(show_text(settings), "[m.system]\na = 1.0  # m.toml:"));
}

TEST(MachineText, ShowTextTellsWhereValuesCameFrom) {
  Settings settings = mill_settings();
  ASSERT_TRUE(
      apply_toml(settings, "[axes.X]\nrapid = 9000\n[axes.C]\n[tools.10]\nradius = 1.25\n", "m.toml"));
  ASSERT_TRUE(apply_assignment(settings, "offsets.G54.C=45"));
  ASSERT_TRUE(apply_assignment(settings, "machine.name=A \"B\""));
  const std::string text = show_text(settings);
  EXPECT_TRUE(has(text, "dialect = \"mill\"  # default\n\n[machine]\n"));
  EXPECT_TRUE(has(text, "name     = \"A \\\"B\\\"\"  # --set\ncycle_ms = 1.0        # ms, default\n"));
  EXPECT_TRUE(has(text, "rapid        = 9000.0                   # mm/min, m.toml:2\n"));
  EXPECT_TRUE(has(text, "max_feed     = 7200.0                   # degree/min, default\n"));
  EXPECT_TRUE(has(text, "G54.C = 45.0  # degree, --set\n"));
  EXPECT_TRUE(has(text, "[tools]\n2.radius  = 3.0   # mm, default\n"));
  EXPECT_TRUE(has(text, "10.radius = 1.25  # mm, m.toml:5\n"));
  EXPECT_TRUE(has(text, "[mill.axis.C]\ntime_constant = 100.0  # ms, default\n"));
}

TEST(MachineText, ShowTextIsAMachineFileToo) {
  Settings settings = mill_settings();
  for (const std::string_view option :
       {"axes.B.limits=[-1.1,1e9]", "tools.7.length=0.1", "offsets.EXT.B=-0.3", "mill.decimal_point=all",
        "machine.name=tab\there \\ \"q\""}) {
    ASSERT_TRUE(apply_assignment(settings, option)) << option;
  }
  Settings copy = mill_settings();
  EXPECT_EQ(errors_of(copy, show_text(settings)), std::vector<std::string>{});
  expect_same_values(copy, settings);
}

}  // namespace
}  // namespace kerf
