#include "syntax/plain_line.hpp"

#include <array>

#include "syntax/decimal_reader.hpp"

namespace kerf {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}

/// The line feeds behind a source end its last line.
bool at_line_end(const char* p) {
  return *p == '\n' || (*p == '\r' && p[1] == '\n');
}

/// The digits of a number and the sign in front of them. No more digits than a double holds exactly.
bool read_number(const char*& p, Decimal& number, bool& minus) {
  constexpr std::ptrdiff_t kMostCharacters = 16;  // 15 digits and a point
  minus = *p == '-';
  if (minus || *p == '+') ++p;
  const char* first = p;
  return read_decimal(p, number) && p - first <= kMostCharacters && number.digits < 1'000'000'000'000'000;
}

/// Both the digits and the power of ten are exact, so the quotient is the double next to the number, as a
/// parser of floating point numbers gives it.
double value_of(const Decimal& number, bool minus) {
  constexpr std::array kPowers{1.0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const double value = static_cast<double>(number.digits) / kPowers[number.decimals];
  return minus ? -value : value;
}

/// Where the words of a line go.
struct IntoBlock {
  Block& block;
  const char* line_start;
  const char* block_start;

  bool full() const { return block.words.full(); }
  void take(const char* from, const char* to, const Decimal& number, bool minus) {
    Word& word = block.words.push_back();
    word.address = *from;
    word.comma = false;
    word.is_computed = true;
    word.expression = -1;
    word.computed = value_of(number, minus);
    word.column = static_cast<std::uint32_t>(from - line_start + 1);
    word.length = static_cast<std::uint32_t>(to - from);
    block.span.length = static_cast<std::uint32_t>(to - block_start);
  }
};

/// Only counted.
struct Counted {
  std::size_t count = 0;
  bool full() const { return count == Block::kMaxWords; }
  void take(const char*, const char*, const Decimal&, bool) { ++count; }
};

template <class Sink>
bool read_words(const char*& p, LetterSet letters, Sink& words) {
  while (!at_line_end(p)) {
    if (is_blank(*p)) {
      ++p;
      continue;
    }
    if (!letters.contains(*p) || words.full()) return false;
    const char* from = p++;
    Decimal number;
    bool minus = false;
    if (!read_number(p, number, minus)) return false;
    words.take(from, p, number, minus);
  }
  return true;
}

/// N and digits, if they stand there.
bool pass_block_number(const char*& p) {
  if (*p != 'N') return true;
  if (!is_digit(*++p)) return false;
  while (is_digit(*p)) ++p;
  return true;
}

/// Behind the words that end at `p`; false when the line was too long.
bool go_behind(const char* p, std::string_view text, LinePlace& place) {
  const auto end = static_cast<std::size_t>(p - text.data());
  if (end - place.start > kLongestPlainLine) return false;
  const std::size_t behind = end + (*p == '\r' ? 2 : 1);
  place.at = place.start = behind < text.size() ? behind : text.size();
  ++place.line;
  return true;
}

const char* first_of(const LinePlace& place, std::string_view text) {
  const char* p = text.data() + place.at;
  while (is_blank(*p)) ++p;
  return p;
}

}  // namespace

bool read_plain_line(LinePlace& place, std::string_view text, LetterSet letters, Block& block) {
  block.words.clear();
  block.skip_mark = false;
  block.skip_number = 0;
  const char* const line_start = text.data() + place.start;
  const char* const first = first_of(place, text);
  block.span = {static_cast<std::uint64_t>(first - text.data()), place.line,
                static_cast<std::uint32_t>(first - line_start + 1), 0};
  const char* p = first;
  IntoBlock words{block, line_start, first};
  if (!pass_block_number(p) || !read_words(p, letters, words)) return false;
  if (block.words.empty() && *first == 'N') return false;
  return go_behind(p, text, place);
}

bool pass_plain_line(LinePlace& place, std::string_view text, LetterSet letters, bool& has_words) {
  const char* const first = first_of(place, text);
  const char* p = first;
  Counted words;
  if (!pass_block_number(p) || !read_words(p, letters, words)) return false;
  has_words = words.count > 0;
  if (!has_words && *first == 'N') return false;
  return go_behind(p, text, place);
}

}  // namespace kerf
