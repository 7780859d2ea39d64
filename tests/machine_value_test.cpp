// Values: how they are written, ranges in words, and which text fits which declaration.

#include <gtest/gtest.h>

#include "base/edit_distance.hpp"
#include "machine/nearest_key.hpp"
#include "machine/value.hpp"

namespace kerf {
namespace {

constexpr Parameter kPercent{.key = "m.percent",
                             .type = ValueType::number,
                             .default_value = "100.0",
                             .unit = "percent",
                             .minimum = 0.0,
                             .maximum = 327.0,
                             .help = "Override."};
constexpr Parameter kCheck{.key = "m.check",
                           .type = ValueType::word,
                           .default_value = "\"alarm\"",
                           .choices = "0=alarm|1=invalid|2=avoid",
                           .help = "Check."};

TEST(MachineValue, WritesToml) {
  EXPECT_EQ(toml_text(true), "true");
  EXPECT_EQ(toml_text(std::int64_t{-3}), "-3");
  EXPECT_EQ(toml_text(10000.0), "10000.0");
  EXPECT_EQ(toml_text(0.1), "0.1");
  EXPECT_EQ(toml_text(1e300), "1e+300");
  EXPECT_EQ(toml_text(std::array{-10.0, 0.5}), "[-10.0, 0.5]");
  EXPECT_EQ(toml_text(std::string("a \"b\" \\ \n\x01")), "\"a \\\"b\\\" \\\\ \\n\\u0001\"");
}

TEST(MachineValue, RangesInWords) {
  EXPECT_EQ(range_text(kPercent), "0 to 327");
  EXPECT_EQ(range_text({.key = "k", .minimum = 0.0, .maximum = 1e12, .above_minimum = true}),
            "above 0, at most 1e12");
  EXPECT_EQ(range_text({.key = "k", .minimum = -9999.9999}), "at least -9999.9999");
  EXPECT_EQ(range_text({.key = "k", .maximum = 1e9}), "at most 1e9");
  EXPECT_EQ(range_text({.key = "k"}), "");
  EXPECT_EQ(range_text({.key = "k", .type = ValueType::word, .choices = "a|b|c"}), "a, b or c");
  EXPECT_EQ(range_text(kCheck), "alarm (0), invalid (1) or avoid (2)");
}

TEST(MachineValue, LimitsOfARangeBelongToIt) {
  EXPECT_TRUE(checked_value(kPercent, "m.percent", 0.0));
  EXPECT_TRUE(checked_value(kPercent, "m.percent", std::int64_t{327}));
  EXPECT_FALSE(checked_value(kPercent, "m.percent", 327.0001));
  EXPECT_FALSE(checked_value(kPercent, "m.percent", -1e-9));
  const Parameter above{.key = "k", .minimum = 0.0, .above_minimum = true};
  EXPECT_FALSE(checked_value(above, "k", 0.0));
  EXPECT_TRUE(checked_value(above, "k", 1e-12));
}

TEST(MachineValue, NumberFromText) {
  EXPECT_EQ(value_from_text(kPercent, "k", " +50 ").value(), Value(50.0));
  EXPECT_EQ(value_from_text(kPercent, "k", "1.5e2").value(), Value(150.0));
  for (const std::string_view text :
       {"", "fast", "5 5", "--5", "+-5", "5mm", "[1,2]", "\"5\"", "0x10", "true"}) {
    const auto value = value_from_text(kPercent, "k", text);
    ASSERT_FALSE(value) << text;
    EXPECT_NE(value.error().message.find("takes a number"), std::string::npos) << text;
  }
  for (const std::string_view text : {"nan", "inf", "-inf", "400"}) {
    const auto value = value_from_text(kPercent, "k", text);
    ASSERT_FALSE(value) << text;
    EXPECT_NE(value.error().message.find("out of range"), std::string::npos) << text;
    EXPECT_EQ(value.error().remedy, "the range is 0 to 327 percent") << text;
  }
}

TEST(MachineValue, WordFromTextOrNumber) {
  EXPECT_EQ(value_from_text(kCheck, "k", "avoid").value(), Value(std::string("avoid")));
  EXPECT_EQ(value_from_text(kCheck, "k", "\"avoid\"").value(), Value(std::string("avoid")));
  EXPECT_EQ(value_from_text(kCheck, "k", "2").value(), Value(std::string("avoid")));
  EXPECT_EQ(checked_value(kCheck, "k", std::int64_t{1}).value(), Value(std::string("invalid")));
  EXPECT_FALSE(value_from_text(kCheck, "k", "3"));
  EXPECT_FALSE(value_from_text(kCheck, "k", "Avoid"));
  EXPECT_FALSE(value_from_text(kCheck, "k", "true"));
  EXPECT_FALSE(value_from_text(kCheck, "k", "1.0"));
}

TEST(MachineValue, UserTextIsMadePrintable) {
  EXPECT_EQ(printable("a\nb\x7F"), "a?b?");
  EXPECT_EQ(printable(std::string(81, 'x')), std::string(80, 'x') + "...");
  // The cut falls inside the two bytes of the 80th character, which goes as a whole.
  EXPECT_EQ(printable(std::string(79, 'x') + "\xC3\xA9yy"), std::string(79, 'x') + "...");
}

TEST(MachineNearestKey, EditDistance) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("rapid", ""), 5U);
  EXPECT_EQ(edit_distance("rapid", "rapit"), 1U);
  EXPECT_EQ(edit_distance("rapid", "RAPID"), 0U);
  EXPECT_EQ(edit_distance("rapid", "arpid"), 1U);  // neighbours swapped
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("max_speed", "max_feed"), 2U);
}

}  // namespace
}  // namespace kerf
