#pragma once
// Text from an NC file made safe for where it is printed. NC files hold any bytes: UTF-8, Shift JIS, control
// codes.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace kerf {

/// One character of a text that should be UTF-8.
struct Character {
  char32_t code = 0;      ///< U+FFFD when the bytes are no UTF-8
  std::size_t bytes = 1;  ///< 1 to 4 bytes taken from the text; 1 when they are no UTF-8
  bool valid = true;
};

/// The first character of a text that is not empty.
Character first_character(std::string_view text);

void append_utf8(std::string& out, char32_t code);

/// Columns of a terminal with fixed-width type: 2 for East Asian wide characters, 0 for combining marks.
int column_width(char32_t code);

/// What to show on a terminal for a character: itself, or a visible stand-in for control codes (which could
/// otherwise move the cursor) and for marks that reverse the direction of writing. The tab is the caller's.
char32_t visible(char32_t code);

/// Appends text for a terminal, every character as visible() says, tabs and line ends as spaces.
void append_visible(std::string& out, std::string_view text);

/// Columns that append_visible() fills.
int visible_width(std::string_view text);

/// Appends a JSON string with its quotes. Bytes that are no UTF-8 become U+FFFD.
void append_json_string(std::string& out, std::string_view text);

/// As append_json_string(), and also safe inside an HTML <script> element: `<` is written \u003c.
void append_script_string(std::string& out, std::string_view text);

/// Appends text for XML or HTML content and quoted attributes. Codes that XML 1.0 forbids become U+FFFD.
void append_xml(std::string& out, std::string_view text);

std::string xml_text(std::string_view text);

}  // namespace kerf
