#include "report/svg_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "report/number_text.hpp"

namespace kerf {
namespace {

constexpr double kUnit = 100.0;  ///< places per picture unit

/// An angle brought into -pi to pi.
double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

/// Mixes the bits of a key (the finalizer of a 64-bit multiply-xorshift generator).
std::uint64_t mixed(std::uint64_t value) {
  value ^= value >> 31U;
  value *= 0x9E3779B97F4A7C15U;
  value ^= value >> 29U;
  value *= 0xD6E8FEB86659FD93U;
  return value ^ (value >> 32U);
}

}  // namespace

SvgPath::Place SvgPath::place_of(Point2 point) {
  constexpr double kFar = 1e9;  // beyond any picture; keeps the conversion defined
  return {std::llround(std::clamp(point.x, -kFar, kFar) * kUnit),
          std::llround(std::clamp(point.y, -kFar, kFar) * kUnit)};
}

void SvgPath::line(Point2 from, Point2 to) {
  begin_at(place_of(from));
  const Place end = place_of(to);
  if (!extends_sleeve(end)) {
    const Place corner = pending_;
    flush();
    begin_at(corner);
    extends_sleeve(end);
  }
  pending_ = end;
}

void SvgPath::arc(Point2 from, Point2 to, const ArcStroke& stroke) {
  const Place start = place_of(from);
  const Place end = place_of(to);
  const double chord = std::hypot(to.x - from.x, to.y - from.y);
  if (chord < tolerance_) {
    line(from, to);
    return;
  }
  flush();
  const auto size = static_cast<std::uint64_t>(std::llround(stroke.radius_x / tolerance_));
  if (!is_new(start, end, 2U * size + (stroke.clockwise ? 2U : 1U))) return;
  move_pen(start);
  append_command('a');
  append_value(std::llround(stroke.radius_x * kUnit));
  append_value(std::llround(stroke.radius_y * kUnit));
  data_ += stroke.clockwise ? " 0 0 1" : " 0 0 0";
  needs_space_ = true;
  append_value(end.x - pen_.x);
  append_value(end.y - pen_.y);
  pen_ = end;
}

const std::string& SvgPath::finish() {
  flush();
  return data_;
}

void SvgPath::begin_at(Place from) {
  if (active_ && pending_ == from) return;
  flush();
  anchor_ = pending_ = from;
  active_ = true;
  has_sleeve_ = false;
  reach_ = 0.0;
}

/// Whether the stroke from the anchor can go on to `to` with every point since the anchor within the
/// tolerance. Narrows the sleeve when it can.
bool SvgPath::extends_sleeve(Place to) {
  const double dx = static_cast<double>(to.x - anchor_.x) / kUnit;
  const double dy = static_cast<double>(to.y - anchor_.y) / kUnit;
  const double distance = std::hypot(dx, dy);
  if (distance < reach_ - tolerance_) return false;  // it turns back
  reach_ = std::max(reach_, distance);
  if (distance <= tolerance_) return true;
  const double angle = std::atan2(dy, dx);
  const double half_width = std::asin(tolerance_ / distance);
  if (!has_sleeve_) {
    has_sleeve_ = true;
    direction_ = angle;
    low_ = -half_width;
    high_ = half_width;
    return true;
  }
  const double offset = wrapped(angle - direction_);
  if (offset < low_ || offset > high_) return false;
  low_ = std::max(low_, offset - half_width);
  high_ = std::min(high_, offset + half_width);
  return true;
}

void SvgPath::flush() {
  if (!active_) return;
  active_ = false;
  // A stroke without length still shows as a dot with round caps.
  if (is_new(anchor_, pending_, 0)) {
    move_pen(anchor_);
    emit_line(pending_);
  }
}

void SvgPath::emit_line(Place to) {
  append_command('l');
  append_value(to.x - pen_.x);
  append_value(to.y - pen_.y);
  pen_ = to;
}

void SvgPath::move_pen(Place to) {
  if (pen_down_ && pen_ == to) return;
  append_command('M');
  append_value(to.x);
  append_value(to.y);
  pen_ = to;
  pen_down_ = true;
}

/// False when a stroke between the same two places, as far as the tolerance tells them apart, was drawn
/// before.
bool SvgPath::is_new(Place from, Place to, std::uint64_t kind) {
  const double grid = 2.0 * tolerance_ * kUnit;
  const auto cell = [grid](Place place) {
    const auto x = static_cast<std::uint64_t>(std::llround(static_cast<double>(place.x) / grid));
    const auto y = static_cast<std::uint64_t>(std::llround(static_cast<double>(place.y) / grid));
    return mixed(x * 0x1000193U + mixed(y));
  };
  std::uint64_t first = cell(from);
  std::uint64_t second = cell(to);
  if (kind == 0 && first > second) std::swap(first, second);
  return seen_.insert(mixed(first + kind) ^ (second * 3U)).second;
}

void SvgPath::append_command(char command) {
  const bool repeated = command == last_command_ && command != 'M';
  if (!repeated) {
    data_ += command;
    needs_space_ = false;
  }
  last_command_ = command;
}

void SvgPath::append_value(std::int64_t hundredths) {
  if (needs_space_ && hundredths >= 0) data_ += ' ';
  append_rounded(data_, static_cast<double>(hundredths) / kUnit, 2);
  needs_space_ = true;
}

void append_path(std::string& out, std::string_view style, std::string_view data) {
  if (data.empty()) return;
  out += "<path class=\"";
  out += style;
  out += "\" d=\"";
  out += data;
  out += "\"/>\n";
}

}  // namespace kerf
