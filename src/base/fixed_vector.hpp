#pragma once
// A vector of fixed capacity that never allocates.

#include <array>
#include <cassert>
#include <cstddef>

namespace kerf {

/// Holds up to Capacity values of a default-constructible type.
template <class T, std::size_t Capacity>
class FixedVector {
 public:
  constexpr std::size_t size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr bool full() const { return size_ == Capacity; }
  static constexpr std::size_t capacity() { return Capacity; }

  /// The caller checks full() first.
  constexpr T& push_back(const T& value) {
    assert(!full());
    return data_[size_++] = value;
  }
  /// The new last value, to be filled in by the caller. It may hold an old value.
  constexpr T& push_back() {
    assert(!full());
    return data_[size_++];
  }
  constexpr void clear() { size_ = 0; }
  constexpr void resize(std::size_t size) {
    assert(size <= Capacity);
    size_ = size;
  }

  constexpr T& operator[](std::size_t i) { return data_[i]; }
  constexpr const T& operator[](std::size_t i) const { return data_[i]; }
  constexpr T& back() { return data_[size_ - 1]; }
  constexpr const T& back() const { return data_[size_ - 1]; }
  constexpr T* begin() { return data_.data(); }
  constexpr T* end() { return data_.data() + size_; }
  constexpr const T* begin() const { return data_.data(); }
  constexpr const T* end() const { return data_.data() + size_; }

 private:
  std::size_t size_ = 0;
  std::array<T, Capacity> data_{};
};

}  // namespace kerf
