// The tables of the DGSHAPE dialect agree with each other and with the manual's numbers.

#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>
#include <string>

#include "dialect/dgshape/codes.hpp"
#include "dialect/dgshape/spindle_codes.hpp"
#include "dialect/dialect.hpp"
#include "machine/schema.hpp"

namespace kerf {
namespace {

const Dialect& dgshape() {
  return *find_dialect("dgshape");
}

TEST(DgshapeTables, TheManualHas39GCodesAnd13MCodes) {
  std::set<int> g;
  std::set<int> m;
  for (const CodeRow& row : dgshape().codes) {
    if (row.letter == 'G') g.insert(row.number / 10);
    if (row.letter == 'M') m.insert(row.number / 10);
  }
  // Manual 2-7, list of words.
  EXPECT_EQ(g, (std::set<int>{0,  1,  2,  3,  4,  10, 17, 18, 19, 20, 21, 28, 39, 40, 41, 42, 43, 49, 50, 51,
                              53, 54, 55, 56, 57, 58, 59, 80, 81, 82, 83, 85, 86, 89, 90, 91, 92, 98, 99}));
  EXPECT_EQ(m, (std::set<int>{0, 1, 2, 3, 5, 6, 12, 13, 14, 15, 16, 17, 30}));
}

TEST(DgshapeTables, AlarmWordsAreUniqueAndExplained) {
  std::set<std::string_view> words;
  for (const AlarmKind& kind : dgshape().alarms) {
    EXPECT_TRUE(words.insert(kind.detail).second) << kind.detail;
    EXPECT_EQ(kind.code, "DGS");
    for (const std::string_view text : {kind.name, kind.cause, kind.remedy})
      EXPECT_FALSE(text.empty()) << kind.detail;
    EXPECT_EQ(kind.cause.back(), '.') << kind.detail;
  }
}

TEST(DgshapeTables, ParametersAreSound) {
  EXPECT_EQ(schema_faults(schema_of(dgshape())), std::vector<std::string>{});
}

TEST(DgshapeTables, SpindleCodesArePreferredNumbers) {
  // Manual 2-4: twenty steps to the decade, rounded; code 20 is 10 rpm.
  for (int code = 1; code <= 98; ++code) {
    const double exact = std::pow(10.0, code / 20.0);
    EXPECT_NEAR(dgshape::spindle_code_rpm(code) / exact, 1.0, 0.013) << code;
  }
  EXPECT_DOUBLE_EQ(dgshape::spindle_code_rpm(1), 1.12);
  EXPECT_DOUBLE_EQ(dgshape::spindle_code_rpm(50), 315.0);
  EXPECT_DOUBLE_EQ(dgshape::spindle_code_rpm(98), 80000.0);
}

TEST(CodeTable, NearMissesAreNamed) {
  const auto codes = dgshape().codes;
  EXPECT_NE(nearest_code(codes, 'G', 45).view().find("G54"), std::string_view::npos) << "swapped digits";
  EXPECT_TRUE(nearest_code(codes, 'G', 7).empty()) << "one of many codes with another digit";
  EXPECT_NE(dgshape::remedy_for_unknown('G', 71).view().find("G21"), std::string_view::npos);
  EXPECT_NE(dgshape::remedy_for_unknown('M', 8).view().find("M12"), std::string_view::npos);
  EXPECT_NE(nearest_code(codes, 'G', 811).view().find("G81"), std::string_view::npos) << "a digit too many";
  EXPECT_TRUE(nearest_code(codes, 'G', 7777).empty());
}

}  // namespace
}  // namespace kerf
