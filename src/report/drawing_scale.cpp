#include "report/drawing_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/number_text.hpp"

namespace kerf {
namespace {

constexpr double kRounding = 1e-9;  ///< relative; 0.3 / 0.1 counts as 3

}  // namespace

double round_up_125(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= value * (1.0 - kRounding)) return factor * power;
  }
  return 10.0 * power;
}

double round_down_125(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value * (1.0 + kRounding))));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= value * (1.0 + kRounding)) return factor * power;
  }
  return power;
}

std::vector<double> ticks_between(double low, double high, double step) {
  constexpr int kMost = 200;
  std::vector<double> ticks;
  const double first = std::ceil(low / step - kRounding);
  const double last = std::floor(high / step + kRounding);
  for (int i = 0; i < kMost && first + i <= last; ++i) ticks.push_back((first + i) * step);
  return ticks;
}

std::string tick_text(double tick, double step) {
  const int decimals = static_cast<int>(std::clamp(std::ceil(-std::log10(step) - kRounding), 0.0, 6.0));
  return fixed_text(tick, decimals);
}

}  // namespace kerf
