// Names and sizes of program files (5.1).

#include "shell_test.hpp"

namespace kerf {
namespace {

class MelsecFiles : public ShellTest {
 protected:
  /// What `kerf check` says of a program that calls program `number`.
  Outcome call(const std::string& number) {
    file("O001.gcd", "%\r\nM98 P" + number + "\r\nM02\r\n%\r\n");
    return kerf("check --dialect melsec " + path("O001.gcd"));
  }
};

constexpr std::string_view kSubprogram = "%\r\nG91 G00 X1.\r\nM99\r\n%\r\n";

/// A good program of that many bytes.
std::string program_of(std::size_t bytes) {
  constexpr std::string_view kHead = "%\r\nG91 G00 X1.\r\n";
  constexpr std::string_view kTail = "M02\r\n%\r\n";
  const std::size_t comment = bytes - kHead.size() - kTail.size();
  std::string text(kHead);
  while (text.size() < kHead.size() + comment) {
    const std::size_t rest = kHead.size() + comment - text.size();
    const std::size_t line = rest < 200 ? rest : 100;  // never leaves less than a line of its own
    text += "(" + std::string(line - 3, 'A') + "\r\n";
  }
  return text.append(kTail);
}

TEST_F(MelsecFiles, ThreeDigitsBetween001And256NameAProgram) {
  file("O002.gcd", kSubprogram);
  file("O256.gcd", kSubprogram);
  EXPECT_EQ(call("2").status, 0);
  EXPECT_EQ(call("256").status, 0);
}

TEST_F(MelsecFiles, OtherNamesAreNoPrograms) {
  for (const char* name : {"O3.gcd", "P004.gcd", "O005.txt", "o006.gcd", "O007.GCD", "O0008.gcd", "O257.gcd"})
    file(name, kSubprogram);
  for (const char* number : {"3", "4", "5", "6", "7", "8"}) {
    const Outcome outcome = call(number);
    EXPECT_EQ(outcome.status, 1) << number;
    EXPECT_NE((outcome.out + outcome.err).find("031FH"), std::string::npos) << number << outcome.out;
  }
  EXPECT_EQ(call("257").status, 1);
}

TEST_F(MelsecFiles, AProgramHasUpTo512KBytes) {
  for (const std::size_t bytes : {std::size_t{520000}, std::size_t{524288}}) {
    const std::string text = program_of(bytes);
    ASSERT_EQ(text.size(), bytes);
    const Outcome outcome = kerf("check --dialect melsec " + file("O002.gcd", text));
    EXPECT_EQ(outcome.status, 0) << bytes << outcome.out;
  }
  const Outcome outcome = kerf("check --dialect melsec " + file("O003.gcd", program_of(524289)));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE((outcome.out + outcome.err).find("1FC0H 0041H"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace kerf
