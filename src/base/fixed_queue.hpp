#pragma once
// A first-in first-out queue of fixed capacity that never allocates.

#include <array>
#include <cassert>
#include <cstddef>

namespace kerf {

/// References to queued values stay valid until the value is popped and its slot is used again.
template <class T, std::size_t Capacity>
class FixedQueue {
 public:
  constexpr std::size_t size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr bool full() const { return size_ == Capacity; }

  /// The new last value, to be filled in by the caller, who checks full() first. It may hold an old value.
  constexpr T& push() {
    assert(!full());
    if (size_ == 0) first_ = 0;  // stay in the slots that are in the cache
    return data_[(first_ + size_++) % Capacity];
  }
  constexpr void push(const T& value) { push() = value; }

  constexpr T& front() { return data_[first_]; }
  constexpr const T& front() const { return data_[first_]; }
  constexpr T& back() { return (*this)[size_ - 1]; }
  constexpr T& operator[](std::size_t i) { return data_[(first_ + i) % Capacity]; }
  constexpr const T& operator[](std::size_t i) const { return data_[(first_ + i) % Capacity]; }

  /// Removes the first value; the reference stays readable until the next push.
  constexpr const T& pop() {
    assert(!empty());
    const T& value = data_[first_];
    first_ = (first_ + 1) % Capacity;
    --size_;
    return value;
  }
  /// Removes the last value.
  constexpr void drop_back() {
    assert(!empty());
    --size_;
  }
  constexpr void clear() { first_ = size_ = 0; }

 private:
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  std::array<T, Capacity> data_{};
};

}  // namespace kerf
