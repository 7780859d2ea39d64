// The short way for blocks of coordinates must give what the whole way gives: random programs are executed as
// they are and with an L word, which changes nothing but the way, in every block of coordinates.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "short_way.hpp"

namespace kerf {
namespace {

std::string number(Random& random) {
  const double value = static_cast<double>(static_cast<int>(below(random, 400000)) - 200000) / 10000.0;
  switch (below(random, 5)) {
    case 0:
      return fmt::format("{:.0f}.", value);
    case 1:
      return fmt::format("{}", static_cast<int>(value * 10000.0));
    case 2:
      return fmt::format("{:.5f}", value);
    case 3:
      return fmt::format("[{:.1f}+1]", std::abs(value));
    default:
      return fmt::format("{:.3f}", value);
  }
}

std::string coordinates(Random& random) {
  std::string block;
  for (const char axis : {'X', 'Y', 'Z', 'C', 'X'}) {
    if (below(random, 5) < 2) block += fmt::format("{}{}", axis, number(random));
  }
  return block;
}

std::string change(Random& random) {
  constexpr const char* kChanges[] = {
      "G00",    "G01",   "G90",    "G91",   "G54",     "G55", "G61",    "G64",       "G61.1",      "G43H1",
      "G44XH1", "G49",   "G52Y3.", "F300.", "G68R30.", "G69", "G90X1.", "G53X5.Y5.", "G02X1.R50.", "M10",
      "G04P5",  "G41D1", "G42D2",  "G41D1", "G40",     "D2",  "G18",    "G17",       "G38X1."};
  const std::string chosen = kChanges[below(random, std::size(kChanges))];
  return chosen == "G44XH1" ? "G44X1.H1" : chosen;
}

ProgramPair random_programs(unsigned seed) {
  Random random(seed);
  ProgramPair programs;
  programs.plain = "%\nG90\n";
  if (below(random, 2) == 0) programs.plain += "F100.\n";
  programs.marked = programs.plain;
  for (int i = 0; i < 60; ++i) {
    if (below(random, 3) == 0) {
      const std::string block = change(random) + "\n";
      programs.add(block);
    } else if (const std::string block = coordinates(random); !block.empty()) {
      programs.plain += block + "\n";
      programs.marked += block + "L1\n";
    }
  }
  programs.add("M02\n%\n");
  return programs;
}

const ShortWayTest kTest{"melsec", "O001.gcd", 200, 20, random_programs};

TEST(MelsecShortWay, GivesWhatTheWholeWayGives) {
  expect_same(kTest, {"offsets.G55.X=12.3456", "tools.1.length=7", "tools.1.radius=3", "tools.2.radius=0.5",
                      "axes.Y.limits=[-30,30]"});
}

TEST(MelsecShortWay, GivesWhatTheWholeWayGivesWithOtherSettings) {
  expect_same(kTest,
              {"melsec.work.coordinate_rotation_type=1", "melsec.axis.C.rotation_axis_type=3",
               "tools.1.length=-2.5", "tools.1.radius=0", "tools.2.radius=-1", "axes.X.limits=[-40,100]"});
}

}  // namespace
}  // namespace kerf
