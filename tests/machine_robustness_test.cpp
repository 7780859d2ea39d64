// Machine files of any bytes: never a crash, and every error has a place within the text.

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <random>
#include <string>

#include "machine/machine_text.hpp"
#include "machine_test_schema.hpp"

namespace kerf {
namespace {

using machine_test::mill;
using machine_test::mill_settings;

void apply(const std::string& text) {
  Settings settings = mill_settings();
  const auto done = apply_toml(settings, text, "m.toml");
  if (done) return;
  ASSERT_FALSE(done.error().empty());
  const auto lines = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n') + 1);
  for (const SettingsError& error : done.error()) {
    EXPECT_FALSE(error.message.empty());
    EXPECT_LE(error.line, lines + 1);
    EXPECT_EQ(error_text(error).find('\n'), std::string::npos);
  }
}

TEST(MachineRobustness, ChangedFiles) {
  const std::string original = init_text(mill(), "mill");
  constexpr std::string_view kPieces = "[]{}=.,\"'#\n\\-+0123456789eXn_ \t\r\x00\x80\xFF\xC3";
  std::mt19937 random(20240611);
  const auto below = [&](std::size_t bound) { return static_cast<std::size_t>(random()) % bound; };
  for (int round = 0; round < 600; ++round) {
    std::string text = original;
    for (std::size_t change = below(6); change < 6; ++change) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text[at] = kPieces[below(kPieces.size())];
          break;
        case 1:
          text.erase(at, below(40));
          break;
        case 2:
          text.insert(at, 1, kPieces[below(kPieces.size())]);
          break;
        default:
          text.insert(at, original.substr(below(original.size()), below(60)));
          break;
      }
      if (text.empty()) text = "x";
    }
    apply(text);
  }
}

TEST(MachineRobustness, RandomBytes) {
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    std::string text(random() % 80, '\0');
    for (char& c : text) c = static_cast<char>(random() & 0xFFU);
    apply(text);
  }
}

TEST(MachineRobustness, DeepNesting) {
  const auto repeated = [](std::string_view piece, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += piece;
    return text;
  };
  Settings settings = mill_settings();
  const auto refused = [&](const std::string& text) { return !apply_toml(settings, text, "m.toml"); };
  EXPECT_TRUE(refused(repeated("a.", 1000000) + "a = 1\n"));
  EXPECT_TRUE(refused("[" + repeated("a.", 1000000) + "a]\n"));
  EXPECT_TRUE(refused("a = " + repeated("[", 1000000)));
  EXPECT_TRUE(refused("a = " + repeated("{a = ", 1000000)));
  EXPECT_TRUE(refused("a = " + repeated("{" + repeated("a.", 100) + "a = [\n", 10000)));
  EXPECT_EQ(dialect_of(repeated("a.", 1000000) + "a = 1\n", "mill.toml").has_value(), false);

  const auto done = apply_toml(settings, "\n" + repeated("a.", 101) + "a = 1\n", "m.toml");
  ASSERT_FALSE(done);
  EXPECT_EQ(error_text(done.error()[0]), "m.toml:2:202: more than 100 dots in one line");
}

TEST(MachineRobustness, LongKeysAreCutInMessages) {
  const std::string key(1000000, 'k');
  Settings settings = mill_settings();
  const auto done = apply_toml(settings, "[machine]\n" + key + " = 1\n", "m.toml");
  ASSERT_FALSE(done);
  EXPECT_LT(error_text(done.error()[0]).size(), 300U);
  const auto option = apply_assignment(settings, key + "=1");
  ASSERT_FALSE(option);
  EXPECT_LT(error_text(option.error()).size(), 400U);
}

}  // namespace
}  // namespace kerf
