#include "execute/scalar_functions.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/turn.hpp"

namespace kerf {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// The zeros have the signs that IEEE 754 gives sinPi and cosPi, and so have the infinities of the tangent.
double sine_deg(double degrees) {
  const double sine = turn_by(degrees).sine;
  return sine == 0.0 ? std::copysign(0.0, degrees) : sine;
}

double cosine_deg(double degrees) {
  return turn_by(degrees).cosine + 0.0;
}

double tangent_deg(double degrees) {
  return sine_deg(degrees) / cosine_deg(degrees);
}

/// The whole root of degree 5, of negative numbers too.
double fifth_root(double x) {
  const double root = std::pow(std::abs(x), 0.2);
  // One step of Newton takes away what the rounded exponent adds.
  const double power = root * root * root * root;
  const double better =
      power > 0.0 && std::isfinite(power) ? root - (root * power - std::abs(x)) / (5.0 * power) : root;
  return std::copysign(better, x);
}

double sign_of(double x) {
  return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;
}

struct Unary {
  std::string_view name;
  double (*value)(double);
};

struct Binary {
  std::string_view name;
  double (*value)(double, double);
};

constexpr std::array kUnary{
    Unary{"abs", [](double x) { return std::abs(x); }},
    Unary{"acos", [](double x) { return std::acos(x); }},
    Unary{"acosd", [](double x) { return std::acos(x) / kRadians; }},
    Unary{"acosh", [](double x) { return std::acosh(x); }},
    Unary{"asin", [](double x) { return std::asin(x); }},
    Unary{"asind", [](double x) { return std::asin(x) / kRadians; }},
    Unary{"asinh", [](double x) { return std::asinh(x); }},
    Unary{"atan", [](double x) { return std::atan(x); }},
    Unary{"atand", [](double x) { return std::atan(x) / kRadians; }},
    Unary{"atanh", [](double x) { return std::atanh(x); }},
    Unary{"cbrt", [](double x) { return std::cbrt(x); }},
    Unary{"ceil", [](double x) { return std::ceil(x); }},
    Unary{"cos", [](double x) { return std::cos(x); }},
    Unary{"cosd", cosine_deg},
    Unary{"cosh", [](double x) { return std::cosh(x); }},
    Unary{"exp", [](double x) { return std::exp(x); }},
    Unary{"exp2", [](double x) { return std::exp2(x); }},
    Unary{"floor", [](double x) { return std::floor(x); }},
    Unary{"int", [](double x) { return std::floor(x); }},
    Unary{"isnan", [](double x) { return std::isnan(x) ? 1.0 : 0.0; }},
    Unary{"log", [](double x) { return std::log(x); }},
    Unary{"log10", [](double x) { return std::log10(x); }},
    Unary{"log2", [](double x) { return std::log2(x); }},
    Unary{"qnrt", fifth_root},
    Unary{"qrrt", [](double x) { return std::sqrt(std::sqrt(x)); }},
    Unary{"rint", [](double x) { return std::nearbyint(x); }},
    Unary{"sgn", sign_of},
    Unary{"sin", [](double x) { return std::sin(x); }},
    Unary{"sind", sine_deg},
    Unary{"sinh", [](double x) { return std::sinh(x); }},
    Unary{"sqrt", [](double x) { return std::sqrt(x); }},
    Unary{"tan", [](double x) { return std::tan(x); }},
    Unary{"tand", tangent_deg},
    Unary{"tanh", [](double x) { return std::tanh(x); }},
};

constexpr std::array kBinary{
    Binary{"atan2", [](double y, double x) { return std::atan2(y, x); }},
    Binary{"atan2d", [](double y, double x) { return std::atan2(y, x) / kRadians; }},
    Binary{"pow", [](double x, double y) { return std::pow(x, y); }},
};

}  // namespace

std::optional<ScalarFunction> find_scalar_function(std::string_view name) {
  for (std::size_t i = 0; i < kUnary.size(); ++i) {
    if (kUnary[i].name == name) return ScalarFunction{i, 1};
  }
  for (std::size_t i = 0; i < kBinary.size(); ++i) {
    if (kBinary[i].name == name) return ScalarFunction{i, 2};
  }
  return std::nullopt;
}

double scalar_function(std::size_t number, double argument) {
  return kUnary[number].value(argument);
}

double scalar_function(std::size_t number, double first, double second) {
  return kBinary[number].value(first, second);
}

}  // namespace kerf
