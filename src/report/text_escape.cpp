#include "report/text_escape.hpp"

#include <array>
#include <fmt/format.h>
#include <iterator>

namespace kerf {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

struct Range {
  char32_t first;
  char32_t last;
};

/// The blocks of Unicode (UAX 11) whose characters take two columns, as far as NC programs may meet them.
constexpr std::array<Range, 9> kWide{{{0x1100, 0x115F},
                                      {0x2E80, 0x303E},
                                      {0x3041, 0xA4CF},
                                      {0xAC00, 0xD7A3},
                                      {0xF900, 0xFAFF},
                                      {0xFE30, 0xFE6F},
                                      {0xFF01, 0xFF60},
                                      {0xFFE0, 0xFFE6},
                                      {0x1F300, 0x3FFFD}}};

constexpr std::array<Range, 5> kNoWidth{
    {{0x0300, 0x036F}, {0x200B, 0x200D}, {0x20D0, 0x20FF}, {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF}}};

/// Marks that change the direction in which the rest of the line is shown.
constexpr std::array<Range, 3> kBidirectional{{{0x200E, 0x200F}, {0x202A, 0x202E}, {0x2066, 0x2069}}};

template <std::size_t Size>
bool contains(const std::array<Range, Size>& ranges, char32_t code) {
  for (const Range& range : ranges) {
    if (code >= range.first && code <= range.last) return true;
  }
  return false;
}

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// Appends one character of a JSON string.
void append_json_character(std::string& out, const Character& character, std::string_view bytes) {
  switch (character.code) {
    case '"':
      out += "\\\"";
      return;
    case '\\':
      out += "\\\\";
      return;
    case '\n':
      out += "\\n";
      return;
    case '\r':
      out += "\\r";
      return;
    case '\t':
      out += "\\t";
      return;
    default:
      break;
  }
  if (character.code < 0x20 || character.code == 0x7F) {
    fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(character.code));
  } else if (!character.valid) {
    append_utf8(out, kReplacement);
  } else {
    out.append(bytes.substr(0, character.bytes));
  }
}

}  // namespace

Character first_character(std::string_view text) {
  const unsigned lead = byte_at(text, 0);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  const Character bad{kReplacement, 1, false};
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return bad;
  char32_t code = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned next = byte_at(text, i);
    if ((next & 0xC0U) != 0x80U) return bad;
    code = (code << 6U) | (next & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};  // less would be an overlong form
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kSmallest[length] || code > 0x10FFFF || surrogate) return bad;
  return {code, length, true};
}

void append_utf8(std::string& out, char32_t code) {
  const auto put = [&out](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0U | (code >> 6U));
    put(0x80U | (code & 0x3FU));
  } else if (code < 0x10000) {
    put(0xE0U | (code >> 12U));
    put(0x80U | ((code >> 6U) & 0x3FU));
    put(0x80U | (code & 0x3FU));
  } else {
    put(0xF0U | (code >> 18U));
    put(0x80U | ((code >> 12U) & 0x3FU));
    put(0x80U | ((code >> 6U) & 0x3FU));
    put(0x80U | (code & 0x3FU));
  }
}

int column_width(char32_t code) {
  if (code < 0x300) return 1;
  if (contains(kNoWidth, code)) return 0;
  return contains(kWide, code) ? 2 : 1;
}

char32_t visible(char32_t code) {
  if (code < 0x20) return 0x2400 + code;  // the control pictures
  if (code == 0x7F) return 0x2421;
  const bool c1_control = code >= 0x80 && code < 0xA0;
  if (c1_control || contains(kBidirectional, code)) return kReplacement;
  return code;
}

void append_visible(std::string& out, std::string_view text) {
  while (!text.empty()) {
    const Character character = first_character(text);
    const bool space = character.code == '\t' || character.code == '\n' || character.code == '\r';
    append_utf8(out, space ? U' ' : visible(character.code));
    text.remove_prefix(character.bytes);
  }
}

int visible_width(std::string_view text) {
  int width = 0;
  while (!text.empty()) {
    const Character character = first_character(text);
    const bool control = character.code < 0x20;
    width += control ? 1 : column_width(visible(character.code));
    text.remove_prefix(character.bytes);
  }
  return width;
}

void append_json_string(std::string& out, std::string_view text) {
  out += '"';
  while (!text.empty()) {
    const Character character = first_character(text);
    append_json_character(out, character, text);
    text.remove_prefix(character.bytes);
  }
  out += '"';
}

void append_script_string(std::string& out, std::string_view text) {
  out += '"';
  while (!text.empty()) {
    const Character character = first_character(text);
    if (character.code == '<' || character.code == 0x2028 || character.code == 0x2029) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(character.code));
    } else {
      append_json_character(out, character, text);
    }
    text.remove_prefix(character.bytes);
  }
  out += '"';
}

void append_xml(std::string& out, std::string_view text) {
  while (!text.empty()) {
    const Character character = first_character(text);
    const bool space = character.code == '\t' || character.code == '\n' || character.code == '\r';
    const bool forbidden = (character.code < 0x20 && !space) || character.code == 0xFFFE ||
                           character.code == 0xFFFF || !character.valid;
    if (forbidden) {
      append_utf8(out, kReplacement);
    } else {
      switch (character.code) {
        case '&':
          out += "&amp;";
          break;
        case '<':
          out += "&lt;";
          break;
        case '>':
          out += "&gt;";
          break;
        case '"':
          out += "&quot;";
          break;
        case '\'':
          out += "&#39;";
          break;
        default:
          out.append(text.substr(0, character.bytes));
          break;
      }
    }
    text.remove_prefix(character.bytes);
  }
}

std::string xml_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  append_xml(out, text);
  return out;
}

}  // namespace kerf
