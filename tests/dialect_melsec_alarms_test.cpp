// The alarm catalogue of the MELSEC dialect as a whole, and the size of a program file.

#include <array>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "dialect/melsec/alarms.hpp"
#include "dialect/setup.hpp"
#include "execute/interpreter.hpp"

namespace kerf {
namespace {

/// The number of a details code such as "030AH"; -1 for a word of kerf's own.
int number_of(std::string_view detail) {
  if (detail.size() != 5 || detail.back() != 'H') return -1;
  return std::stoi(std::string(detail.substr(0, 4)), nullptr, 16);
}

/// The error code of a details code in the lists of appendix 1; empty: there is no such details code.
std::string_view error_code(int details) {
  struct Range {
    int first;
    int last;
    std::string_view code;
  };
  // 030BH and 030CH are missing in the manual's list.
  constexpr std::array kRanges{
      Range{0x0010, 0x0016, "30FDH"}, Range{0x0020, 0x0024, "30FDH"}, Range{0x0040, 0x0042, "1FC0H"},
      Range{0x0101, 0x0104, "1FC1H"}, Range{0x0111, 0x0119, "1FC1H"}, Range{0x0201, 0x0203, "1FC2H"},
      Range{0x0221, 0x0222, "1FC2H"}, Range{0x0301, 0x030A, "1FC3H"}, Range{0x030D, 0x0336, "1FC3H"}};
  for (const Range& range : kRanges) {
    if (details >= range.first && details <= range.last) return range.code;
  }
  return {};
}

// MMA-337, MMA-338, MMA-339, MMA-447
TEST(MelsecAlarms, TheDetailsCodesAreThoseOfTheAppendix) {
  std::set<int> found;
  for (const AlarmKind& kind : melsec::alarm_catalogue()) {
    if (kind.code == "KERF") continue;
    const int details = number_of(kind.detail);
    EXPECT_FALSE(error_code(details).empty()) << kind.detail;
    EXPECT_EQ(kind.code, error_code(details)) << kind.detail;
    EXPECT_TRUE(found.insert(details).second) << kind.detail << " twice";
  }
  // 7 + 5 + 3 + 4 + 9 + 3 + 2 + 10 + 42
  EXPECT_EQ(found.size(), 85U);
}

// MMA-341, MMA-504
TEST(MelsecAlarms, CodesOfOtherListsAreNotInTheCatalogue) {
  for (const AlarmKind& kind : melsec::alarm_catalogue()) {
    for (const std::string_view code :
         {"192AH", "19A6H", "2221H", "308FH", "30F9H", "30FEH", "0EF1H", "1FF1H", "3081H"}) {
      EXPECT_NE(kind.code, code);
    }
  }
}

/// The details codes of a program of so many bytes.
std::string alarms_of_size(std::size_t bytes) {
  SetupOptions setup;
  setup.dialect = "melsec";
  const auto controller = make_controller(setup);
  std::string text = "%\nG04 P1\n";
  const std::string end = "M02\n%\n";
  while (text.size() + end.size() + 60 < bytes) text += "(" + std::string(38, 'x') + "\n";
  text += "(" + std::string(bytes - text.size() - end.size() - 2, 'x') + "\n" + end;
  EXPECT_EQ(text.size(), bytes);
  Interpreter program(controller->rules, Source::from_text("O001.gcd", text),
                      controller->interpreter_options);
  std::string alarms;
  while (const Action* action = program.next()) {
    const auto* alarm = std::get_if<Alarm>(&action->what);
    if (alarm != nullptr) alarms += fmt::format("{}/{};", alarm->kind->code, alarm->kind->detail);
  }
  return alarms;
}

// MMA-385
TEST(MelsecAlarms, AProgramFileHasAtMost512Kbytes) {
  EXPECT_EQ(alarms_of_size(524288), "");
  EXPECT_EQ(alarms_of_size(524289), "1FC0H/0041H;");
}

}  // namespace
}  // namespace kerf
