// Lines of plain words are read from the text when they are reached, and blocks of coordinates take a short
// way. Both must give what the others give: random programs are executed as they are and with a jerk time,
// which changes nothing here but the way, in every block of coordinates.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "short_way.hpp"

namespace kerf {
namespace {

std::string number(Random& random) {
  const double value = static_cast<double>(static_cast<int>(below(random, 400000)) - 200000) / 10000.0;
  switch (below(random, 6)) {
    case 0:
      return fmt::format("{:.0f}.", value);
    case 1:
      return fmt::format("{:+.2f}", value);
    case 2:
      return fmt::format("{:.14f}", value / 30.0);
    case 3:
      return fmt::format("-.{}", below(random, 1000));
    case 4:
      return fmt::format("{:.12f}", value);
    default:
      return fmt::format("{:.3f}", value);
  }
}

std::string coordinates(Random& random) {
  std::string block;
  for (const char axis : {'X', 'Y', 'Z', 'A', 'X'}) {
    if (below(random, 5) < 2) block += fmt::format("{}{} ", axis, number(random));
  }
  return block;
}

std::string change(Random& random) {
  constexpr const char* kChanges[] = {
      "G00",           "G01",         "G90",  "G91",        "G54",      "G55",       "G61",
      "G64",           "G43",         "G44",  "G49",        "G52 Y3",   "F300",      "G68 X0 Y0 R30",
      "G69",           "G51 P2",      "G50",  "G51.1 X0",   "G50.1",    "G53 X5",    "G02 X1 R50",
      "M10",           "G04 P5",      "G41",  "G42",        "G40",      "G20",       "G21",
      "G500 P1",       "G501 P99",    "G09",  "G84 R2 Z-3", "G80 S100", "G18",       "G17",
      "M100 VA1 // t", "G31 X3",      "L1=2", "X[L1]",      "/3 X1",    "M98 P1000", "G28 X0",
      "A10 F20",       "if(L1<1) X1", "",     "F90000"};
  return kChanges[below(random, std::size(kChanges))];
}

ProgramPair random_programs(unsigned seed) {
  Random random(seed);
  ProgramPair programs;
  programs.plain = "G90 ts0\n";
  if (below(random, 2) == 0) programs.plain += "F100\n";
  programs.marked = programs.plain;
  // Sometimes long stretches of coordinates, sometimes short ones.
  const unsigned changes = below(random, 2) == 0 ? 3 : 25;
  for (int i = 0; i < 100; ++i) {
    if (below(random, changes) == 0) {
      const std::string block = change(random) + "\n";
      programs.add(block);
    } else if (const std::string block = coordinates(random); !block.empty()) {
      const std::string front = below(random, 4) == 0 ? fmt::format("N{:04} ", i) : "";
      programs.plain += front + block + (below(random, 4) == 0 ? "\r\n" : "\n");
      programs.marked += front + block + "ts0\n";
    }
  }
  programs.plain += "M30";
  programs.marked += "M30\n";
  return programs;
}

ProgramText called_program(std::int32_t) {
  std::string text = "G91\n";
  for (int i = 0; i < 20; ++i) text += "X0.5 Y-0.25\n";
  return {Source::from_text("1000.nc", text + "G90\n")};
}

const ShortWayTest kTest{"omron", "main.nc", 300, 30, random_programs, called_program};

TEST(OmronShortWay, GivesWhatTheWholeWayGives) {
  expect_same(kTest, {"offsets.G55.X=12.3456", "tools.1.length=7", "tools.1.radius=3",
                      "axes.Y.limits=[-60,60]", "omron.extended_1.maximum_feedrate=50"});
}

TEST(OmronShortWay, GivesWhatTheWholeWayGivesWithOtherSettings) {
  expect_same(kTest, {"omron.cnc_version=1.01", "omron.command_unit=inch", "omron.block_skip=3",
                      "axes.X.limits=[-400,1000]", "tools.1.length=-2.5", "omron.jerk_time=0"});
}

// Every block counts, has its own line, and is found by its place.
TEST(OmronShortWay, PlainLinesAreBlocksOfTheirOwn) {
  SetupOptions options;
  options.dialect = "omron";
  const auto controller = make_controller(options);
  ASSERT_TRUE(controller.has_value());
  std::string text = "G91 G01 F100\n{ N7  X1\n\n";
  for (int i = 0; i < 30; ++i) text += " N8 Y1 X2 \n\n";
  text += "}\nM30\n";
  Interpreter program(controller->rules, Source::from_text("main.nc", text), controller->interpreter_options);
  std::uint32_t moves = 0;
  while (const Action* action = program.next()) {
    if (!std::holds_alternative<Move>(action->what)) continue;
    ++moves;
    EXPECT_EQ(action->origin.block, moves + 1);
    EXPECT_EQ(action->origin.span.line, moves * 2);
    EXPECT_EQ(action->origin.sequence_number, static_cast<std::int32_t>(moves * 2));
    EXPECT_EQ(action->origin.span.column, moves == 1 ? 3U : 2U);
    EXPECT_EQ(text.substr(action->origin.span.offset, action->origin.span.length),
              moves == 1 ? "N7  X1" : "N8 Y1 X2");
  }
  EXPECT_EQ(moves, 31U);
  EXPECT_EQ(program.blocks(), 33U);
}

}  // namespace
}  // namespace kerf
