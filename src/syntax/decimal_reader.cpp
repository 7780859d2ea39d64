#include "syntax/decimal_reader.hpp"

#include <bit>
#include <cstring>
#include <string_view>

namespace kerf {
namespace {

constexpr int kMaxDigits = 18;

bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}

/// The whole of a number of any length.
Decimal long_decimal(std::string_view text) {
  Decimal number;
  int count = 0;  // significant digits taken
  for (const char c : text) {
    if (c == '.') {
      number.has_point = true;
      continue;
    }
    if (count == kMaxDigits || (number.has_point && number.decimals == kMaxDigits)) {
      number.overflow = number.overflow || !number.has_point;
      continue;
    }
    number.digits = number.digits * 10 + (c - '0');
    if (number.digits != 0) ++count;
    if (number.has_point) ++number.decimals;
  }
  return number;
}

bool read_any(const char*& p, Decimal& number) {
  const char* first = p;
  while (is_digit(*p)) ++p;
  bool any = p != first;
  const bool point = *p == '.';
  if (point) {
    const char* behind = ++p;
    while (is_digit(*p)) ++p;
    any = any || p != behind;
  }
  number = long_decimal({first, p});
  number.has_point = point;
  return any;
}

/// Eight decimal digits, one a byte, the first in the lowest byte: pairs, then fours, then all at once.
std::uint64_t value_of_eight(std::uint64_t digits) {
  digits = digits * 10 + (digits >> 8);
  constexpr std::uint64_t kEven = 0x000000FF000000FF;
  constexpr std::uint64_t kUpper = 100 + (std::uint64_t{1'000'000} << 32);
  constexpr std::uint64_t kLower = 1 + (std::uint64_t{10'000} << 32);
  return ((digits & kEven) * kUpper + ((digits >> 16) & kEven) * kLower) >> 32;
}

}  // namespace

// Nearly every number of a program has at most eight characters. They are taken as one integer, without a
// loop: the lengths of numbers vary, and a loop over them is mispredicted in nearly every word.
bool read_decimal(const char*& p, Decimal& number) {
  if constexpr (std::endian::native != std::endian::little) return read_any(p, number);
  std::uint64_t text = 0;
  std::memcpy(&text, p, sizeof text);
  const std::uint64_t digits = text ^ 0x3030303030303030;  // a digit's byte is its value
  constexpr std::uint64_t kTops = 0x8080808080808080;
  // The top bit of every byte that is no digit.
  const std::uint64_t others = (((digits & ~kTops) + 0x7676767676767676) | digits) & kTops;
  const int whole = std::countr_zero(others) >> 3;  // digits in front of the point; 8 when all are
  if (whole < 8 && p[whole] == '.') {
    const int length = std::countr_zero(others & (others - 1)) >> 3;
    if (length == 1) return read_any(p, number);
    if (length == 8 && is_digit(p[8])) return read_any(p, number);
    const std::uint64_t front = (std::uint64_t{1} << (8 * whole)) - 1;
    const std::uint64_t joined = (digits & front) | ((digits >> 8) & ~front);
    number.digits = static_cast<std::int64_t>(value_of_eight(joined << (8 * (9 - length))));
    number.decimals = static_cast<std::uint8_t>(length - 1 - whole);
    number.has_point = true;
    p += length;
    return true;
  }
  if (whole == 0 || (whole == 8 && (is_digit(p[8]) || p[8] == '.'))) return read_any(p, number);
  number.digits = static_cast<std::int64_t>(value_of_eight(digits << (8 * (8 - whole))));
  p += whole;
  return true;
}

}  // namespace kerf
