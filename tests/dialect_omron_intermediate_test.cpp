// The intermediate code of the OMRON controller (manual A-1).

#include <gtest/gtest.h>

#include "dialect/omron/compile.hpp"

namespace kerf::omron {
namespace {

std::string code_of(std::string_view text, std::int32_t number = 1) {
  std::vector<ParseFault> faults;
  const std::string code = intermediate_code(text, number, faults);
  for (const ParseFault& fault : faults) ADD_FAILURE() << fault.detail << " in line " << fault.span.line;
  return code;
}

/// Of a main program, without its first and last line.
std::string lines_of(std::string_view text) {
  const std::string code = code_of(text);
  constexpr std::string_view kHead = "open prog 1\n";
  constexpr std::string_view kFoot = "close\n";
  EXPECT_TRUE(code.starts_with(kHead) && code.ends_with(kFoot)) << code;
  return code.substr(kHead.size(), code.size() - kHead.size() - kFoot.size());
}

// OMR-685, 687, 688: the example of the manual. Its line numbers need one line without code behind the first
// and one in front of N11; its letters O in N03 and P0 are digits.
TEST(OmronIntermediate, ExampleOfTheManual) {
  EXPECT_EQ(code_of("N01 G17 G64 G91 G01 F1000\n"
                    "                                   // block-number = N{line-number}\n"
                    "N02 M03 S1000\n"
                    "/1 N03 X10                         // Optional Block Skip\n"
                    "N04 X[P0]                          // Variable Indirection\n"
                    "N05 if (Q0==1) {X10}               // Control syntax\n"
                    "N06 M98 P1000                      // Subprogram call\n"
                    "N07 M100 VA0                       // M-code\n"
                    "\n"
                    "N11 G91 G99 G84 X10 Y0 Z-10 R-5 P1000 K1// Start of Tapping Cycle\n"
                    "N12 G99 X10\n"
                    "N13 G98 X10\n"
                    "N14 G80                            // End of Tapping Cycle\n"
                    "N15 M05\n"
                    "N16 M30                            // End of program\n"),
            "open prog 1\n"
            "N1 G17 G64 G91 G01 F1000 M999.002\n"
            "N3 M03 S1000 M999.002\n"
            "cskip1 N4 X10 M999.002\n"
            "N5 X(P0) M999.002\n"
            "if(Q0 == 1)\n"
            "N6 X10 M999.002\n"
            "N7 M98 P1000 M999.002\n"
            "N8 M100 A0 M999.002\n"
            "N10 G91 G99 G80.001 G84 X10 Y0 Z-10 R-5 P1000 K1 M999.002\n"
            "N11 G99 G84 X10 M999.002\n"
            "N12 G98 G84 X10 M999.002\n"
            "N13 G80 M999.002\n"
            "N14 M05 M999.002\n"
            "N15 M30 M999.002\n"
            "close\n");
}

// OMR-663, 665, 686
TEST(OmronIntermediate, SubprogramOfTheManual) {
  EXPECT_EQ(code_of("N01 G04 P100\nN02 M99 // End of subprogram\n", 1000),
            "open subprog 1000\nN1 G04 P100 M999.002\nN2 M99 M999.002\nreturn\nclose\n");
}

// OMR-664, 665: a return for each M99, the footer's own only when the last block has none.
TEST(OmronIntermediate, EveryReturnHasItsLine) {
  EXPECT_EQ(code_of("if(Q0==1){M99}\nX1\n", 2999),
            "open subprog 2999\nif(Q0 == 1)\n{\nN1 M99 M999.002\nreturn\n}\nN2 X1 M999.002\nreturn\nclose\n");
  EXPECT_EQ(code_of("M99\n"), "open prog 1\nN1 M99 M999.002\nreturn\nclose\n");
}

// OMR-666, 667, 668, 670, 671
TEST(OmronIntermediate, WordsKeepTheirSpelling) {
  EXPECT_EQ(lines_of("G01X10.50Y-.5F0100 // text\n\n// nothing\n   N7   M03\tS+300\n"),
            "N1 G01 X10.50 Y-.5 F0100 M999.002\nN4 M03 S+300 M999.002\n");
}

// OMR-675, 683
TEST(OmronIntermediate, SkipsStandInFrontOfTheNumber) {
  EXPECT_EQ(lines_of("/31 X1\n"), "cskip31 N1 X1 M999.002\n");
}

// OMR-676, 679
TEST(OmronIntermediate, BracketsAndArguments) {
  EXPECT_EQ(lines_of("X[ L12 ] Y[Q0]\nM100 VA[L0] VH-3.5\n"),
            "N1 X(L12) Y(Q0) M999.002\nN2 M100 A(L0) H-3.5 M999.002\n");
}

// OMR-677, 678
TEST(OmronIntermediate, CyclesAreRepeatedUntilTheyEnd) {
  EXPECT_EQ(lines_of("G84 X1 Z-2 R-1\nG98\nX2\nG74 X3\nG99 Y4\nG01 X5\nX6\nG74 X7\nG80\nX8\n"),
            "N1 G80.001 G84 X1 Z-2 R-1 M999.002\n"
            "N2 G98 M999.002\n"
            "N3 G84 X2 M999.002\n"
            "N4 G80.001 G74 X3 M999.002\n"
            "N5 G99 G74 Y4 M999.002\n"
            "N6 G01 X5 M999.002\n"
            "N7 X6 M999.002\n"
            "N8 G80.001 G74 X7 M999.002\n"
            "N9 G80 M999.002\n"
            "N10 X8 M999.002\n");
}

// OMR-680, 681, 682
TEST(OmronIntermediate, BracesStayAroundSeveralCommands) {
  EXPECT_EQ(lines_of("if(Q0==1){X1\nY1}else{Z1}\nwhile(L0<3){L0=L0+1}\ndo X2 while(L1>=2||L2!=0)\n"),
            "if(Q0 == 1)\n{\nN1 X1 M999.002\nN2 Y1 M999.002\n}\nelse\nN2 Z1 M999.002\n"
            "while(L0 < 3)\n{\nL0=L0+1\n}\ndo\nN4 X2 M999.002\nwhile(L1 >= 2 || L2 != 0)\n");
  EXPECT_EQ(lines_of("switch(L0%3){\ncase -1: X1\nbreak\ndefault: Y1}\n"),
            "switch(L0%3)\n{\ncase -1:\nN2 X1 M999.002\nbreak\ndefault:\nN4 Y1 M999.002\n}\n");
}

// OMR-073, 074, 684: the limit counts in intermediate code.
TEST(OmronIntermediate, BlocksHaveAtMost1020Bytes) {
  // "N1 X" + digits + " M999.002"
  const std::string longest = "X" + std::string(1020 - 4 - 9, '1');
  EXPECT_EQ(lines_of(longest).size(), 1020U + 1U);
  std::vector<ParseFault> faults;
  EXPECT_EQ(intermediate_code(longest + "1", 1, faults), "");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].detail, "block-length");
  EXPECT_EQ(lines_of("X1 //" + std::string(5000, 'c')), "N1 X1 M999.002\n");
}

// OMR-664, 682: M99 and its return are two lines, which a condition and a skip hold together.
TEST(OmronIntermediate, AReturnStaysWithItsCondition) {
  EXPECT_EQ(lines_of("if(Q0==1){M99}\nX5\n"), "if(Q0 == 1)\n{\nN1 M99 M999.002\nreturn\n}\nN2 X5 M999.002\n");
  EXPECT_EQ(lines_of("if(1==1) M99\nelse X1\n"),
            "if(1 == 1)\n{\nN1 M99 M999.002\nreturn\n}\nelse\nN2 X1 M999.002\n");
  EXPECT_EQ(lines_of("/1 M99\nX2\n"), "cskip1 N1 M99 M999.002\ncskip1 return\nN2 X2 M999.002\n");
}

// OMR-676: whichever way the number of the cycle is written.
TEST(OmronIntermediate, ACycleMayHaveAPointBehindItsNumber) {
  EXPECT_EQ(lines_of("G84. X1 Z-1 R0\nX2\nG80\n"),
            "N1 G80.001 G84. X1 Z-1 R0 M999.002\nN2 G84 X2 M999.002\nN3 G80 M999.002\n");
}

// Nothing behind the end is part of the program; a byte order mark in front is not either.
TEST(OmronIntermediate, TheProgramEndsWithItsEnd) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBFX1\nM30\nX[\n"), "N1 X1 M999.002\nN2 M30 M999.002\n");
}

}  // namespace
}  // namespace kerf::omron
