// Walks every cell of the manual's two tables of combinations (5.6). Cells that depend on which code of the
// group it is carry a note in words; they are listed here with the codes that the note means.

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

#include "dialect/melsec/combinations.hpp"
#include "dialect/setup.hpp"
#include "execute/interpreter.hpp"

namespace kerf::melsec {
namespace {

using Codes = std::vector<std::string>;

const std::map<std::string, Codes>& groups() {
  static const std::map<std::string, Codes> kGroups{
      {"01", {"G00", "G01", "G02", "G03"}},
      {"02", {"G17", "G18", "G19"}},
      {"03", {"G90", "G91"}},
      {"07", {"G40", "G41", "G42"}},
      {"08", {"G43", "G44", "G49"}},
      {"12", {"G54", "G55", "G56", "G57", "G58", "G59"}},
      {"13", {"G61", "G61.1", "G62", "G64"}},
      {"15", {"G40.1", "G41.1", "G42.1"}},
      {"16", {"G68", "G69"}},
      {"21", {"G12.1", "G13.1"}},
  };
  return kGroups;
}

/// A row of a table: what becomes of a code with the codes of a group.
struct Cell {
  std::string commanded;
  std::string group;
  std::string result;
  std::string note;
  std::string alarm;
};

std::vector<Cell> read_table(const std::string& name) {
  std::ifstream file(std::string(KERF_SOURCE_DIR) + "/tests/data/" + name);
  std::vector<Cell> cells;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream columns(line);
    Cell cell;
    std::getline(columns, cell.commanded, '\t');
    std::getline(columns, cell.group, '\t');
    std::getline(columns, cell.result, '\t');
    std::getline(columns, cell.note, '\t');
    std::getline(columns, cell.alarm, '\t');
    cells.push_back(cell);
  }
  return cells;
}

/// The codes of a group that the alarm of a cell is about; all of them when it has no condition.
using Conditions = std::map<std::pair<std::string, std::string>, std::map<std::string, std::string>>;

/// The details code that is expected; empty: none. `conditions` overrule the cell.
std::string expected_alarm(const Cell& cell, const std::string& other, const Conditions& conditions) {
  const auto found = conditions.find({cell.commanded, cell.group});
  if (found != conditions.end()) {
    const auto alarm = found->second.find(other);
    return alarm == found->second.end() ? "" : alarm->second;
  }
  if (cell.result != "no" || cell.alarm == "-") return "";
  return cell.alarm;
}

/// "0306H or 0324H" allows either.
bool agrees(const std::string& expected, std::string_view got) {
  if (expected.empty() || got.empty()) return expected.empty() && got.empty();
  return expected.find(got) != std::string::npos;
}

CodeSet set_of_word(const std::string& word) {
  return set_of(code_named(word));
}

Conditions same_block_conditions() {
  Conditions conditions;
  const std::map<std::string, std::string> arcs{{"G02", "0315H"}, {"G03", "0315H"}};
  conditions[{"G38", "01"}] = {{"G02", "0306H"}, {"G03", "0306H"}};
  for (const char* radius : {"G40", "G41", "G42"}) conditions[{radius, "01"}] = arcs;
  for (const char* plane : {"G17", "G18", "G19"}) conditions[{plane, "16"}] = {{"G69", "0326H"}};
  for (const char* polar : {"G12.1", "G13.1"}) {
    conditions[{polar, "16"}] = {{"G68", "0324H"}, {"G69", "0306H"}};
    // The rows of the other codes name 0306H or 0324H; both are printed for group 07.
  }
  // The G65 row says that both are executed; the rule that G12.1 stands alone wins (MGC-060).
  conditions[{"G65", "21"}] = {{"G12.1", "0306H"}, {"G13.1", "0306H"}};
  return conditions;
}

TEST(MelsecCombinations, EveryCellOfTheSameBlockTable) {
  const auto cells = read_table("melsec_combination_same_block.tsv");
  ASSERT_EQ(cells.size(), 400U);
  const Conditions conditions = same_block_conditions();
  std::size_t refused = 0;
  for (const Cell& cell : cells) {
    for (const std::string& other : groups().at(cell.group)) {
      if (other == cell.commanded) continue;
      const bool same_group = cell.result == "last";
      const CodeSet codes =
          same_group ? set_of_word(other) : set_of_word(cell.commanded) | set_of_word(other);
      const std::string_view got = refused_in_block(codes).detail;
      const std::string expected = expected_alarm(cell, other, conditions);
      EXPECT_TRUE(agrees(expected, got))
          << cell.commanded << " with " << other << ": '" << got << "' instead of '" << expected << "'";
      refused += got.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 100U);
}

/// The codes of a modal group that are in force when the cell's note speaks of the group as active.
Conditions modal_conditions() {
  Conditions conditions;
  const auto all = [](const Codes& codes, const std::string& alarm) {
    std::map<std::string, std::string> result;
    for (const std::string& code : codes) result[code] = alarm;
    return result;
  };
  const Codes arcs{"G02", "G03"};
  conditions[{"G38", "01"}] = all(arcs, "0306H");
  conditions[{"G38", "02"}] = {};  // some plane is always in force (MGC-064)
  conditions[{"G39", "02"}] = {};
  conditions[{"G00", "15"}] = {};  // no alarm: the axis just does not turn
  for (const char* code : {"G52", "G54", "G55", "G56", "G57", "G58", "G59"})
    conditions[{code, "15"}] = all({"G41.1", "G42.1"}, "0304H");
  for (const char* code :
       {"G52", "G53", "G17", "G18",   "G19", "G43",   "G44",   "G49",   "G54", "G55",  "G56",
        "G57", "G58", "G59", "G61.1", "G62", "G40.1", "G41.1", "G42.1", "G68", "G12.1"})
    conditions[{code, "21"}] = {{"G12.1", "0322H"}};
  for (const char* plane : {"G17", "G18", "G19"}) {
    conditions[{plane, "07"}] = all({"G41", "G42"}, "0316H");
    conditions[{plane, "15"}] = all({"G41.1", "G42.1"}, "031CH");
    conditions[{plane, "16"}] = {{"G68", "0326H"}};
  }
  for (const char* radius : {"G40", "G41", "G42"}) conditions[{radius, "01"}] = all(arcs, "0315H");
  for (const char* normal : {"G40.1", "G41.1", "G42.1"}) conditions[{normal, "13"}] = {{"G61.1", "0304H"}};
  conditions[{"G61.1", "15"}] = all({"G41.1", "G42.1"}, "0304H");
  for (const char* polar : {"G12.1", "G13.1"}) {
    conditions[{polar, "07"}] = all({"G41", "G42"}, "0324H");
    conditions[{polar, "13"}] = all({"G62", "G61.1"}, "0324H");
    conditions[{polar, "15"}] = all({"G41.1", "G42.1"}, "0324H");
    conditions[{polar, "16"}] = {{"G68", "0324H"}};
  }
  return conditions;
}

TEST(MelsecCombinations, EveryCellOfTheModalTable) {
  const auto cells = read_table("melsec_combination_modal.tsv");
  ASSERT_EQ(cells.size(), 400U);
  const Conditions conditions = modal_conditions();
  std::size_t refused = 0;
  for (const Cell& cell : cells) {
    if (cell.result == "no") {
      EXPECT_TRUE(conditions.count({cell.commanded, cell.group}) == 1)
          << cell.commanded << " in " << cell.group << ": the cancel code of the group must stay allowed";
    }
    for (const std::string& other : groups().at(cell.group)) {
      const std::string_view got =
          refused_in_modal(set_of_word(cell.commanded), set_of_word(other), false).detail;
      const std::string expected = expected_alarm(cell, other, conditions);
      EXPECT_TRUE(agrees(expected, got))
          << cell.commanded << " while " << other << ": '" << got << "' instead of '" << expected << "'";
      refused += got.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 50U);
}

TEST(MelsecCombinations, ToleranceOfEachAxisLiftsTheRefusalsOfHighAccuracyControl) {
  for (const auto& [commanded, in_force] : {std::pair{"G41.1", "G61.1"}, std::pair{"G61.1", "G41.1"},
                                            std::pair{"G61.1", "G12.1"}, std::pair{"G12.1", "G61.1"}}) {
    EXPECT_FALSE(refused_in_modal(set_of_word(commanded), set_of_word(in_force), false).detail.empty());
    EXPECT_TRUE(refused_in_modal(set_of_word(commanded), set_of_word(in_force), true).detail.empty())
        << commanded << " while " << in_force;
  }
  EXPECT_EQ(refused_in_modal(set_of_word("G12.1"), set_of_word("G62"), true).detail, "0324H");
}

TEST(MelsecCombinations, TheSetsFollowTheCodeTable) {
  std::size_t codes = 0;
  for (const CodeRow& row : code_table()) {
    if (row.letter != 'G') continue;
    EXPECT_EQ(set_of(row.number), CodeSet{1} << codes) << row.word;
    ++codes;
  }
  EXPECT_EQ(codes, kGCodes.size());
}

/// The details code of the first alarm of a block; what is not a matter of combinations does not count.
std::string alarm_of_block(const Controller& controller, const std::string& block) {
  InterpreterOptions options = controller.interpreter_options;
  options.programs = [](std::int32_t) { return ProgramText{Source::from_text("O002.gcd", "%\nM99\n%\n")}; };
  Interpreter program(controller.rules, Source::from_text("O001.gcd", "%\n" + block + "\nM02\n%\n"), options);
  while (const Action* action = program.next()) {
    const auto* alarm = std::get_if<Alarm>(&action->what);
    if (alarm == nullptr) continue;
    constexpr std::array<std::string_view, 2> kOtherMatters{"031BH", "0325H"};
    const bool other =
        std::find(kOtherMatters.begin(), kOtherMatters.end(), alarm->kind->detail) != kOtherMatters.end();
    return other ? std::string() : std::string(alarm->kind->detail);
  }
  return {};
}

std::string with_operands(const std::string& code) {
  if (code == "G04") return "G04P1";
  if (code == "G65") return "G65P2";
  if (code == "G41" || code == "G42") return code + "D1";
  return code == "G43" || code == "G44" ? code + "H1" : code;
}

TEST(MelsecCombinations, TheInterpreterObeysTheSameBlockTable) {
  SetupOptions setup;
  setup.dialect = "melsec";
  const auto controller = make_controller(setup);
  ASSERT_TRUE(controller.has_value());
  const Conditions conditions = same_block_conditions();
  for (const Cell& cell : read_table("melsec_combination_same_block.tsv")) {
    // Words behind G65 are its arguments, so it stands last.
    for (const std::string& other : groups().at(cell.group)) {
      const std::string block = with_operands(other) + with_operands(cell.commanded);
      EXPECT_TRUE(agrees(expected_alarm(cell, other, conditions), alarm_of_block(*controller, block)))
          << block;
    }
  }
}

}  // namespace
}  // namespace kerf::melsec
