#pragma once
// Names of the machine's axes and small fixed-size containers over them.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace kerf {

/// The axes a machine may have, in the order every table and output lists them.
enum class Axis : std::uint8_t { X, Y, Z, A, B, C, U, V, W };

inline constexpr std::size_t kAxisCount = 9;

constexpr std::size_t index(Axis axis) {
  return static_cast<std::size_t>(axis);
}

constexpr char letter(Axis axis) {
  constexpr std::array<char, kAxisCount> letters{'X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W'};
  return letters[index(axis)];
}

constexpr std::optional<Axis> axis_from_letter(char c) {
  switch (c) {
    case 'X':
      return Axis::X;
    case 'Y':
      return Axis::Y;
    case 'Z':
      return Axis::Z;
    case 'A':
      return Axis::A;
    case 'B':
      return Axis::B;
    case 'C':
      return Axis::C;
    case 'U':
      return Axis::U;
    case 'V':
      return Axis::V;
    case 'W':
      return Axis::W;
    default:
      return std::nullopt;
  }
}

/// One number per axis: millimetres for linear axes, degrees for rotary ones. Axes a machine lacks stay 0.
struct AxisVector {
  std::array<double, kAxisCount> values{};

  constexpr double& operator[](Axis axis) { return values[index(axis)]; }
  constexpr double operator[](Axis axis) const { return values[index(axis)]; }

  constexpr AxisVector& operator+=(const AxisVector& other) {
    for (std::size_t i = 0; i < kAxisCount; ++i) values[i] += other.values[i];
    return *this;
  }
  constexpr AxisVector& operator-=(const AxisVector& other) {
    for (std::size_t i = 0; i < kAxisCount; ++i) values[i] -= other.values[i];
    return *this;
  }
  constexpr AxisVector& operator*=(double factor) {
    for (double& value : values) value *= factor;
    return *this;
  }
  friend constexpr AxisVector operator*(AxisVector a, double factor) { return a *= factor; }
  friend constexpr AxisVector operator+(AxisVector a, const AxisVector& b) { return a += b; }
  friend constexpr AxisVector operator-(AxisVector a, const AxisVector& b) { return a -= b; }
  friend constexpr bool operator==(const AxisVector&, const AxisVector&) = default;
};

/// A set of axes, iterable in the order of the enumeration: `for (Axis axis : set)`.
class AxisSet {
 public:
  constexpr AxisSet() = default;
  constexpr AxisSet(std::initializer_list<Axis> axes) {
    for (Axis axis : axes) insert(axis);
  }

  constexpr void insert(Axis axis) { bits_ = static_cast<std::uint16_t>(bits_ | bit(axis)); }
  constexpr void erase(Axis axis) { bits_ = static_cast<std::uint16_t>(bits_ & ~bit(axis)); }
  constexpr bool contains(Axis axis) const { return (bits_ & bit(axis)) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr int size() const { return std::popcount(bits_); }

  class Iterator {
   public:
    constexpr explicit Iterator(std::uint16_t bits) : bits_(bits) {}
    constexpr Axis operator*() const { return static_cast<Axis>(std::countr_zero(bits_)); }
    constexpr Iterator& operator++() {
      bits_ = static_cast<std::uint16_t>(bits_ & (bits_ - 1U));
      return *this;
    }
    friend constexpr bool operator==(const Iterator&, const Iterator&) = default;

   private:
    std::uint16_t bits_;
  };
  constexpr Iterator begin() const { return Iterator(bits_); }
  constexpr Iterator end() const { return Iterator(0); }

  friend constexpr bool operator==(const AxisSet&, const AxisSet&) = default;

 private:
  static constexpr unsigned bit(Axis axis) { return 1U << index(axis); }
  std::uint16_t bits_ = 0;
};

}  // namespace kerf
