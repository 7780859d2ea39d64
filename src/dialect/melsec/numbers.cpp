#include "dialect/melsec/numbers.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace kerf::melsec {
namespace {

/// Halves of a step as they come out of decimal fractions, which are seldom exact doubles.
constexpr double kRounding = 1e-9;

/// The number as written, the decimal point at the end when there is none.
double written(const Decimal& number) {
  // One division by an exact power is right to the last bit.
  double power = 1.0;
  for (int i = 0; i < number.decimals; ++i) power *= 10.0;
  return static_cast<double>(number.digits) / power;
}

/// Written in `unit` without a decimal point; computed values and those with a point count whole.
double scaled(const Word& word, double unit_per_whole) {
  if (word.is_computed) return word.computed;
  return word.number.has_point ? written(word.number)
                               : static_cast<double>(word.number.digits) / unit_per_whole;
}

NumberResult limited(const Word& word, double value, double lowest, double highest) {
  const bool inside = std::isfinite(value) && value >= lowest - kRounding && value <= highest + kRounding;
  return {value, inside && !word.number.overflow ? NumberFault::none : NumberFault::range};
}

/// A length of up to four decimals in steps of 0.0001; nothing when it is another number.
std::optional<std::int64_t> whole_steps(const Word& word) {
  constexpr std::array<std::int64_t, 5> kStepsPerDigit{10'000, 1'000, 100, 10, 1};
  constexpr std::int64_t kManyDigits = 10'000'000'000;
  const Decimal& number = word.number;
  if (word.is_computed || number.overflow || number.decimals > 4) return std::nullopt;
  if (number.digits > kManyDigits || number.digits < -kManyDigits) return std::nullopt;
  return number.has_point ? number.digits * kStepsPerDigit[number.decimals] : number.digits;
}

NumberResult length(const Word& word, double largest) {
  constexpr double kStepsPerUnit = 1e4;
  if (const auto steps = whole_steps(word)) {
    const double value = static_cast<double>(*steps) / kStepsPerUnit;
    return {value, value >= -largest && value <= largest ? NumberFault::none : NumberFault::range};
  }
  const double value = scaled(word, kStepsPerUnit);
  if (!std::isfinite(value)) return {value, NumberFault::range};
  const double steps = std::round(value * kStepsPerUnit);
  return limited(word, steps / kStepsPerUnit, -largest, largest);
}

}  // namespace

NumberResult position_of(const Word& word) {
  return length(word, 9999.9999);
}

NumberResult radius_of(const Word& word) {
  return length(word, 99999.9999);
}

NumberResult feed_of(const Word& word) {
  return limited(word, scaled(word, 1.0), 0.01, 1e6);
}

NumberResult seconds_of(const Word& word) {
  return limited(word, scaled(word, 1000.0), 0.0, 99999.999);
}

NumberResult integer_of(const Word& word, double lowest, double highest) {
  if (word.is_computed) return limited(word, std::round(word.computed), lowest, highest);
  if (word.number.has_point) return {0.0, NumberFault::decimal_point};
  return limited(word, static_cast<double>(word.number.digits), lowest, highest);
}

double argument_of(const Word& word) {
  return word.is_computed ? word.computed : written(word.number);
}

}  // namespace kerf::melsec
