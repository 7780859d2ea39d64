#include "execute/evaluate.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "execute/scalar_functions.hpp"

namespace kerf {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// An angle in degrees brought into [0, 360), where the quarters are exact.
double turned(double degrees) {
  const double rest = std::fmod(degrees, 360.0);
  return rest < 0.0 ? rest + 360.0 : rest;
}

/// The bits of the value as the controller sees it: 32-bit two's complement, the fraction dropped. Outside
/// that range the upper bits are lost, and what is no number counts as 0.
std::int64_t bits_of(double value) {
  constexpr double kTwo32 = 4294967296.0;
  if (!std::isfinite(value)) return 0;
  const double rest = std::fmod(std::trunc(value), kTwo32);
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(rest)));
}

constexpr double kLargestBcd = 4294967295.0;

/// Each hexadecimal digit counts as a decimal digit; digits above 9 count what they are.
double from_bcd(double value) {
  if (!(value >= 0.0 && value <= kLargestBcd)) return 0.0;
  auto rest = static_cast<std::uint64_t>(value);
  double sum = 0.0;
  for (double place = 1.0; rest != 0; rest >>= 4, place *= 10.0)
    sum += static_cast<double>(rest & 0xFU) * place;
  return sum;
}

double to_bcd(double value) {
  if (!(value >= 0.0 && value <= kLargestBcd)) return 0.0;
  auto rest = static_cast<std::uint64_t>(value);
  double sum = 0.0;
  for (double place = 1.0; rest != 0; rest /= 10, place *= 16.0)
    sum += static_cast<double>(rest % 10) * place;
  return sum;
}

MathFault power(double base, double exponent, double& value) {
  const bool whole = exponent == std::trunc(exponent);
  if ((base == 0.0 && exponent <= 0.0) || (base < 0.0 && !whole)) return MathFault::out_of_domain;
  value = std::pow(base, exponent);
  return MathFault::none;
}

/// The operations that evaluate() leaves to it.
MathFault binary(ExpressionOp op, double a, double b, double& value) {
  switch (op) {
    case ExpressionOp::divide:
      if (b == 0.0) return MathFault::zero_divisor;
      value = a / b;
      return MathFault::none;
    case ExpressionOp::modulo:
      if (b == 0.0) return MathFault::zero_divisor;
      value = std::fmod(a, b);
      return MathFault::none;
    case ExpressionOp::bit_or:
      value = static_cast<double>(bits_of(a) | bits_of(b));
      return MathFault::none;
    case ExpressionOp::bit_xor:
      value = static_cast<double>(bits_of(a) ^ bits_of(b));
      return MathFault::none;
    case ExpressionOp::bit_and:
      value = static_cast<double>(bits_of(a) & bits_of(b));
      return MathFault::none;
    case ExpressionOp::equal:
      value = a == b ? 1.0 : 0.0;
      return MathFault::none;
    case ExpressionOp::not_equal:
      value = a != b ? 1.0 : 0.0;
      return MathFault::none;
    case ExpressionOp::greater:
      value = a > b ? 1.0 : 0.0;
      return MathFault::none;
    case ExpressionOp::greater_equal:
      value = a >= b ? 1.0 : 0.0;
      return MathFault::none;
    case ExpressionOp::quotient:
      value = a / b;
      return MathFault::none;
    case ExpressionOp::remainder:
      value = std::fmod(a, b);
      return MathFault::none;
    case ExpressionOp::both:
      value = a != 0.0 && b != 0.0 ? 1.0 : 0.0;
      return MathFault::none;
    case ExpressionOp::either:
      value = a != 0.0 || b != 0.0 ? 1.0 : 0.0;
      return MathFault::none;
    default:
      return power(a, b, value);
  }
}

MathFault tangent(double degrees, double& value) {
  const double angle = turned(degrees);
  if (angle == 90.0 || angle == 270.0) return MathFault::out_of_domain;
  value = std::tan(degrees * kRadians);
  return MathFault::none;
}

MathFault unary(ExpressionOp op, double a, double& value) {
  switch (op) {
    case ExpressionOp::negate:
      value = -a;
      return MathFault::none;
    case ExpressionOp::sine:
      value = std::sin(a * kRadians);
      return MathFault::none;
    case ExpressionOp::cosine:
      value = std::cos(a * kRadians);
      return MathFault::none;
    case ExpressionOp::tangent:
      return tangent(a, value);
    case ExpressionOp::arc_sine:
      value = std::asin(a) / kRadians;
      return std::abs(a) > 1.0 ? MathFault::out_of_domain : MathFault::none;
    case ExpressionOp::arc_cosine:
      value = std::acos(a) / kRadians;
      return std::abs(a) > 1.0 ? MathFault::out_of_domain : MathFault::none;
    case ExpressionOp::arc_tangent:
      value = std::atan(a) / kRadians;
      return MathFault::none;
    case ExpressionOp::square_root:
      value = std::sqrt(a);
      return a < 0.0 ? MathFault::out_of_domain : MathFault::none;
    case ExpressionOp::absolute:
      value = std::abs(a);
      return MathFault::none;
    case ExpressionOp::from_bcd:
      value = from_bcd(a);
      return MathFault::none;
    case ExpressionOp::to_bcd:
      value = to_bcd(a);
      return MathFault::none;
    case ExpressionOp::round:
      value = std::round(a);
      return MathFault::none;
    case ExpressionOp::truncate:
      value = std::trunc(a);
      return MathFault::none;
    case ExpressionOp::round_up:
      value = a < 0.0 ? std::floor(a) : std::ceil(a);
      return MathFault::none;
    case ExpressionOp::logarithm:
      value = std::log(a);
      return a <= 0.0 ? MathFault::out_of_domain : MathFault::none;
    case ExpressionOp::negation:
      value = a == 0.0 ? 1.0 : 0.0;
      return MathFault::none;
    default:
      value = std::exp(a);
      return MathFault::none;
  }
}

}  // namespace

MathFault evaluate(Expression expression, const MacroVariables& variables, double& value) {
  std::array<double, kExpressionStack> stack;  // NOLINT(*-member-init): written before it is read
  double* top = stack.data() - 1;
  for (const ExpressionStep& step : expression) {
    // What loops are made of stands here; the rest is a call away.
    switch (step.op) {
      case ExpressionOp::constant:
        *++top = step.operand;
        break;
      case ExpressionOp::variable:
      case ExpressionOp::indirect: {
        if (step.op == ExpressionOp::variable) *++top = step.operand;
        const double* variable = variables.find(*top);
        if (variable == nullptr) return MathFault::no_variable;
        *top = *variable;
        break;
      }
      case ExpressionOp::add:
        --top;
        *top += top[1];
        break;
      case ExpressionOp::subtract:
        --top;
        *top -= top[1];
        break;
      case ExpressionOp::multiply:
        --top;
        *top *= top[1];
        break;
      case ExpressionOp::less:
        --top;
        *top = *top < top[1] ? 1.0 : 0.0;
        break;
      case ExpressionOp::less_equal:
        --top;
        *top = *top <= top[1] ? 1.0 : 0.0;
        break;
      case ExpressionOp::system_value: {
        const double* found = variables.find_system(*top);
        if (found == nullptr) return MathFault::no_variable;
        *top = *found;
        break;
      }
      case ExpressionOp::call1:
        *top = scalar_function(static_cast<std::size_t>(step.operand), *top);
        break;
      case ExpressionOp::call2:
        --top;
        *top = scalar_function(static_cast<std::size_t>(step.operand), *top, top[1]);
        break;
      default: {
        if (is_binary(step.op)) --top;
        const MathFault fault =
            is_binary(step.op) ? binary(step.op, *top, top[1], *top) : unary(step.op, *top, *top);
        if (fault != MathFault::none) return fault;
      }
    }
  }
  value = stack[0];
  return MathFault::none;
}

}  // namespace kerf
