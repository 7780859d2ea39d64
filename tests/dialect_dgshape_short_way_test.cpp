// A block of coordinates goes the short way of coordinate_block.cpp; with a sequence number in front it goes
// the whole way of BlockRun. Both must give the same, whatever is in force and whatever is wrong with the
// block.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "short_way.hpp"

namespace kerf {
namespace {

using Random = std::mt19937;

int below(Random& random, int limit) {
  return static_cast<int>(random() % static_cast<unsigned>(limit));
}

std::string number(Random& random) {
  const int whole = below(random, 120) - 60;
  switch (below(random, 6)) {
    case 0:
      return fmt::format("{}", whole * 997);  // thousandths
    case 1:
      return fmt::format("{}.", whole);
    case 2:
      return fmt::format("{}.{:05}", whole, below(random, 100000));
    case 3:
      return below(random, 8) == 0 ? "123456789" : "0";  // too many digits, or no distance
    default:
      return fmt::format("{}.{:03}", whole, below(random, 1000));
  }
}

std::string coordinates(Random& random) {
  std::string block;
  for (const char axis : std::string_view("XYZAX")) {
    if (below(random, axis == 'A' ? 12 : 2) == 0) block += axis + number(random);
    if (axis == 'A' && below(random, 12) != 0) break;  // a second X word is rare
  }
  return block;
}

std::string change(Random& random) {
  constexpr std::array changes{"G90",     "G91",      "G00",   "G01",           "G54",          "G55",
                               "G59",     "M03",      "M05",   "F300.0",        "G41D1",        "G40",
                               "G43H1",   "G49",      "G50",   "G51X1.0P1500",  "G92X3.0Y-1.0", "G80",
                               "G02I1.0", "G18",      "G17",   "G10L2P2X1.125", "G53G00Z-10.0", "G04P100",
                               "G98",     "G91G28X0", "S2000", "G81Z-1.0R0.5",  "G51.5",        "G10P1R2.5"};
  return changes[static_cast<std::size_t>(below(random, static_cast<int>(changes.size())))];
}

ProgramPair random_programs(unsigned seed) {
  Random random(seed);
  ProgramPair programs;
  programs.plain = programs.marked = fmt::format("%\nG{}\nS1000F100.0\nM03\n", 20 + below(random, 2));
  for (int i = 0; i < 60; ++i) {
    if (below(random, 3) == 0) {
      const std::string block = change(random) + "\n";
      programs.add(block);
    } else if (const std::string block = coordinates(random); !block.empty()) {
      programs.plain += block + "\n";
      programs.marked += "N7" + block + "\n";
    }
  }
  programs.add("M02\n%\n");
  return programs;
}

const ShortWayTest kTest{"dgshape", "test", 150, 20, random_programs};

TEST(ShortWay, GivesWhatTheWholeWayGives) {
  expect_same(kTest, {"axes.X.limits=[-50,50]", "offsets.G55.X=12.3456", "offsets.G59.Z=-1",
                      "tools.1.radius=2", "tools.1.length=7"});
}

TEST(ShortWay, GivesWhatTheWholeWayGivesWithOtherSettings) {
  expect_same(kTest, {"axes.Y.limits=[-40,40]", "dgshape.rapid_axes=2", "dgshape.rapid_axes_over=split",
                      "dgshape.decimal_point=all", "tools.1.radius=1"});
  expect_same(kTest, {"axes.Y.limits=[-40,40]", "dgshape.rapid_axes=2", "dgshape.over_travel=clip"});
}

}  // namespace
}  // namespace kerf
