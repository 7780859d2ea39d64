#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "report/text_escape.hpp"

namespace kerf {
namespace {

std::string json(std::string_view text) {
  std::string out;
  append_json_string(out, text);
  return out;
}

std::string script(std::string_view text) {
  std::string out;
  append_script_string(out, text);
  return out;
}

std::string shown(std::string_view text) {
  std::string out;
  append_visible(out, text);
  return out;
}

TEST(ReportTextEscape, DecodesUtf8AndRefusesWhatIsNone) {
  EXPECT_EQ(first_character("A").code, U'A');
  EXPECT_EQ(first_character("\xC3\xA9").code, U'é');
  EXPECT_EQ(first_character("\xE5\x8A\xA0").code, U'加');
  EXPECT_EQ(first_character("\xF0\x9F\x98\x80").bytes, 4U);
  for (const std::string_view bad : {"\x80", "\xC3", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80",
                                     "\xF4\x90\x80\x80", "\xFF", "\xE5\x8A", "\xC3("}) {
    EXPECT_FALSE(first_character(bad).valid);
    EXPECT_EQ(first_character(bad).bytes, 1U);
  }
}

TEST(ReportTextEscape, JsonStringsAreAlwaysValid) {
  EXPECT_EQ(json("a\"b\\c\n\t\x01"), R"("a\"b\\c\n\t\u0001")");
  EXPECT_EQ(json("\x8F"), "\"\xEF\xBF\xBD\"");
  std::string every_byte;
  for (int i = 0; i < 256; ++i) every_byte += static_cast<char>(i);
  EXPECT_TRUE(nlohmann::json::accept(json(every_byte)));
  EXPECT_EQ(nlohmann::json::parse(json("( 加工 )")).get<std::string>(), "( 加工 )");
}

TEST(ReportTextEscape, ScriptStringsCannotEndTheScript) {
  EXPECT_EQ(script("</script><!--"), R"("\u003c/script>\u003c!--")");
  EXPECT_EQ(nlohmann::json::parse(script("</script>")).get<std::string>(), "</script>");
}

TEST(ReportTextEscape, XmlHasNoMarkupAndNoForbiddenCodes) {
  EXPECT_EQ(xml_text("<a href=\"x\" b='y'>&"), "&lt;a href=&quot;x&quot; b=&#39;y&#39;&gt;&amp;");
  EXPECT_EQ(xml_text(std::string_view("a\0b\x1b", 4)),
            "a\xEF\xBF\xBD"
            "b\xEF\xBF\xBD");
}

TEST(ReportTextEscape, ControlCodesNeverReachTheTerminal) {
  EXPECT_EQ(shown("a\x1b[31mb"), "a␛[31mb");
  EXPECT_EQ(shown("a\tb\nc"), "a b c");
  EXPECT_EQ(shown("\x7f"), "␡");
  EXPECT_EQ(shown("\xC2\x9B"), "\xEF\xBF\xBD");      // CSI of C1
  EXPECT_EQ(shown("\xE2\x80\xAE"), "\xEF\xBF\xBD");  // right-to-left override
  EXPECT_EQ(visible_width("加a\t"), 4);
}

}  // namespace
}  // namespace kerf
