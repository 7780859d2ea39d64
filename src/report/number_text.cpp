#include "report/number_text.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/compile.h>
#include <fmt/format.h>

namespace kerf {
namespace {

constexpr std::array<std::int64_t, 10> kPowersOfTen{
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};

/// Appends count / 10^decimals; `trim` leaves out zeros at the end of the fraction.
void append_scaled(std::string& out, std::int64_t count, int decimals, bool trim) {
  if (count < 0) {
    out += '-';
    count = -count;
  }
  const std::int64_t unit = kPowersOfTen[static_cast<std::size_t>(decimals)];
  append_integer(out, count / unit);
  std::int64_t fraction = count % unit;
  if (decimals == 0 || (trim && fraction == 0)) return;
  while (trim && fraction % 10 == 0) {
    fraction /= 10;
    --decimals;
  }
  std::array<char, 10> digits{};
  digits[0] = '.';
  for (int i = decimals; i > 0; --i) {
    digits[static_cast<std::size_t>(i)] = static_cast<char>('0' + fraction % 10);
    fraction /= 10;
  }
  out.append(digits.data(), static_cast<std::size_t>(decimals) + 1);
}

void append_to_places(std::string& out, double value, int decimals, bool trim) {
  const double unit = static_cast<double>(kPowersOfTen[static_cast<std::size_t>(decimals)]);
  const double count = std::round(value * unit);
  if (std::abs(count) < 9e15) {
    append_scaled(out, static_cast<std::int64_t>(count), decimals, trim);
  } else {
    append_number(out, value);
  }
}

}  // namespace

void append_integer(std::string& out, std::int64_t value) {
  const fmt::format_int digits(value);
  out.append(digits.data(), digits.size());
}

void append_number(std::string& out, double value) {
  // Most numbers of a toolpath are multiples of the least increment, 0.0001. Such a value has at most 15
  // digits, and decimals of up to 15 digits are all different doubles, so its trimmed decimal is also the
  // shortest.
  constexpr int kDecimals = 4;
  constexpr double kUnit = 1e4;
  const double count = std::round(value * kUnit);
  if (std::abs(count) < 1e15 && count / kUnit == value) {
    append_scaled(out, static_cast<std::int64_t>(count), kDecimals, true);
    return;
  }
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  std::array<char, 32> digits{};
  const auto* end = fmt::format_to(digits.data(), FMT_COMPILE("{}"), value);
  out.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

void append_rounded(std::string& out, double value, int decimals) {
  append_to_places(out, value, decimals, true);
}

void append_fixed(std::string& out, double value, int decimals) {
  append_to_places(out, value, decimals, false);
}

std::string rounded_text(double value, int decimals) {
  std::string text;
  append_rounded(text, value, decimals);
  return text;
}

std::string fixed_text(double value, int decimals) {
  std::string text;
  append_fixed(text, value, decimals);
  return text;
}

std::string clock_text(double seconds) {
  if (!(seconds > 0.0)) seconds = 0.0;
  constexpr double kLongest = 3.6e9;  // a million hours; keeps the conversion defined
  const auto tenths = static_cast<std::int64_t>(std::llround(std::fmin(seconds, kLongest) * 10.0));
  return fmt::format("{}:{:02}:{:02}.{}", tenths / 36'000, tenths / 600 % 60, tenths / 10 % 60, tenths % 10);
}

std::string grouped_text(std::uint64_t value) {
  std::string text = fmt::format_int(value).str();
  for (std::size_t at = text.size(); at > 3;) {
    at -= 3;
    text.insert(at, 1, ' ');
  }
  return text;
}

}  // namespace kerf
