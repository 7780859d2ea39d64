// What single blocks of the MELSEC dialect leave behind: promises that no statement of the manual names.

#include <gtest/gtest.h>

#include "dialect/setup.hpp"
#include "execute/interpreter.hpp"

namespace kerf {
namespace {

Controller controller() {
  SetupOptions options;
  options.dialect = "melsec";
  options.assignments = {"melsec.system.common_system_points=400",
                         "melsec.system.common_system_start_device=D2000"};
  auto made = make_controller(options);
  EXPECT_TRUE(made.has_value());
  return std::move(*made);
}

/// Runs to the end or the first alarm; the details code of the alarm, empty without one.
std::string run_to_end(Interpreter& program) {
  while (const Action* action = program.next()) {
    if (const auto* alarm = std::get_if<Alarm>(&action->what)) return std::string(alarm->kind->detail);
  }
  return {};
}

Interpreter interpreter(const Controller& c, const std::string& blocks) {
  return Interpreter(c.rules, Source::from_text("O001.gcd", "%\n" + blocks + "%\n"), c.interpreter_options);
}

TEST(MelsecBlocks, EachComputedWordHasAnExpressionOfItsOwn) {
  const Controller c = controller();
  std::string text = "#100=3\nG90G00";
  for (int i = 0; i < 100; ++i) text += " X[#100+1]";
  Interpreter program = interpreter(c, text + "\nM02\n");
  EXPECT_EQ(run_to_end(program), "");
  EXPECT_DOUBLE_EQ(program.state().registers.position[Axis::X], 4.0);
}

TEST(MelsecBlocks, ALongSumNeedsLittleStack) {
  const Controller c = controller();
  std::string text = "#100=1\n#101=#100";
  for (int i = 0; i < 200; ++i) text += "+#100";
  Interpreter program = interpreter(c, text + "\nM02\n");
  EXPECT_EQ(run_to_end(program), "");
}

TEST(MelsecBlocks, ARefusedBlockLeavesTheLocalSystemAlone) {
  const Controller c = controller();
  Interpreter program = interpreter(c, "G90G52X100. M98P999\nM02\n");
  EXPECT_EQ(run_to_end(program), "0308H");
  EXPECT_EQ(program.state().tables.local_offsets[1], AxisVector{});
}

TEST(CodeTable, ReadsCodesAsTheyAreWritten) {
  EXPECT_EQ(code_named("G90"), code(90));
  EXPECT_EQ(code_named("G40.1"), code(40, 1));
  EXPECT_EQ(code_named("G1"), code(1));
  for (const std::string_view wrong : {"", "G", "G-1", "G1.", "G1.23", "G1x", "G1000", "Gx"})
    EXPECT_EQ(code_named(wrong), kNoCode) << wrong;
}

}  // namespace
}  // namespace kerf
