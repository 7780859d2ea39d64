#include "dialect/dgshape/numbers.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

namespace kerf::dgshape {
namespace {

constexpr std::int64_t kEightDigits = 99'999'999;
constexpr double kMmPerInch = 25.4;

constexpr std::array<std::int64_t, 19> kPowers = [] {
  std::array<std::int64_t, 19> powers{};
  std::int64_t power = 1;
  for (auto& p : powers) {
    p = power;
    power = power > 100'000'000'000'000'000 ? power : power * 10;
  }
  return powers;
}();

/// The number in steps of 10^-places, surplus digits rounded half away from zero (DGS-092). Saturates far
/// outside every range.
std::int64_t in_steps(const Decimal& number, int places) {
  if (number.overflow) return number.digits < 0 ? -kPowers[18] : kPowers[18];
  const int shift = places - number.decimals;
  if (shift == 0) return number.digits;
  if (shift == -1) return (number.digits + (number.digits < 0 ? -5 : 5)) / 10;
  if (shift > 0) {
    if (std::llabs(number.digits) > kPowers[18] / kPowers[static_cast<std::size_t>(shift)]) {
      return number.digits < 0 ? -kPowers[18] : kPowers[18];
    }
    return number.digits * kPowers[static_cast<std::size_t>(shift)];
  }
  const std::int64_t half = kPowers[static_cast<std::size_t>(-shift)] / 2;
  std::int64_t steps = number.digits + (number.digits < 0 ? -half : half);
  // Digit by digit: a division by a constant is a multiplication, one by a variable takes many cycles.
  for (int i = shift; i < 0; ++i) steps /= 10;
  return steps;
}

bool inside_integer_range(const Decimal& number) {
  return !number.overflow && number.digits >= -kEightDigits && number.digits <= kEightDigits;
}

/// A value that the manual limits to eight digits, read with `places` decimals when it has a point or is
/// calculator type. Range 1: eight digits without a point; with one, eight digits of the least increment.
NumberResult eight_digits(const Word& word, bool calculator, int places) {
  const Decimal& number = word.number;
  if (!number.has_point) {
    if (!inside_integer_range(number)) return {0.0, NumberFault::range};
    if (calculator) return {static_cast<double>(number.digits), NumberFault::none};
    return {
        static_cast<double>(number.digits) / static_cast<double>(kPowers[static_cast<std::size_t>(places)]),
        NumberFault::none};
  }
  const std::int64_t steps = in_steps(number, places);
  if (std::llabs(steps) > kEightDigits) return {0.0, NumberFault::range};
  return {static_cast<double>(steps) / static_cast<double>(kPowers[static_cast<std::size_t>(places)]),
          NumberFault::none};
}

}  // namespace

NumberReader::NumberReader(const ControllerSettings& settings, bool inch)
    : calculator_words_(settings.calculator_words), angle_unit_(settings.angle_unit), inch_(inch) {}

bool NumberReader::calculator(char address) const {
  switch (calculator_words_) {
    case CalculatorWords::none:
      return false;
    case CalculatorWords::all:
      return true;
    case CalculatorWords::feed:
      return address == 'F';
    case CalculatorWords::dimension:
      return address != 'F' && address != 'Q' && address != 'P';
  }
  return false;
}

NumberResult NumberReader::length(const Word& word) const {
  // Eight digits of 0.001 mm or 0.0001 inch; the printed limits have the two exchanged (DGS-160).
  NumberResult result = eight_digits(word, calculator(word.address), inch_ ? 4 : 3);
  if (inch_) result.value *= kMmPerInch;
  return result;
}

NumberResult NumberReader::distance(const Word& word) const {
  return length(word);
}

NumberResult NumberReader::feed(const Word& word) const {
  return length(word);
}

NumberResult NumberReader::angle(const Word& word) const {
  const Decimal& number = word.number;
  if (!number.has_point) {
    if (!inside_integer_range(number)) return {0.0, NumberFault::range};
    if (calculator(word.address)) return {static_cast<double>(number.digits), NumberFault::none};
  }
  const double units = number.has_point
                           ? std::round(static_cast<double>(number.digits) /
                                        static_cast<double>(kPowers[number.decimals]) / angle_unit_)
                           : static_cast<double>(number.digits);
  if (number.has_point && std::llabs(in_steps(number, 3)) > kEightDigits) return {0.0, NumberFault::range};
  // Whole units to the degree divide exactly; 90000 x 0.001 would miss 90 by a rounding error.
  const double per_degree = std::round(1.0 / angle_unit_);
  const bool whole = std::abs(per_degree * angle_unit_ - 1.0) < 1e-12;
  return {whole ? units / per_degree : units * angle_unit_, NumberFault::none};
}

NumberResult NumberReader::dwell_seconds(const Word& word) const {
  return eight_digits(word, calculator(word.address), 3);
}

NumberResult NumberReader::scale(const Word& word) const {
  return eight_digits(word, calculator(word.address), 3);
}

NumberResult NumberReader::integer(const Word& word) {
  if (word.number.has_point) return {0.0, NumberFault::decimal_point};
  if (!inside_integer_range(word.number)) return {0.0, NumberFault::range};
  return {static_cast<double>(word.number.digits), NumberFault::none};
}

}  // namespace kerf::dgshape
