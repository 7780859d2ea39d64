#pragma once
// Text of bounded length that never allocates, for messages made where allocation is forbidden.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fmt/core.h>
#include <string_view>

namespace kerf {

/// Formats into a buffer without allocating; the result is the length of the whole text, which may be more
/// than the capacity. Out of line: the formatting machinery is compiled once.
std::size_t format_into(char* buffer, std::size_t capacity, fmt::string_view pattern, fmt::format_args args);

template <std::size_t Capacity>
class FixedText {
 public:
  constexpr FixedText() = default;
  constexpr FixedText(std::string_view text) { assign(text); }
  constexpr FixedText(const char* text) { assign(text); }

  constexpr std::string_view view() const { return {data_.data(), size_}; }
  constexpr bool empty() const { return size_ == 0; }

  /// Longer text is cut at the capacity.
  constexpr void assign(std::string_view text) {
    size_ = static_cast<std::uint16_t>(std::min(text.size(), Capacity));
    std::copy_n(text.begin(), size_, data_.begin());
  }

  template <class... Args>
  static FixedText format(fmt::format_string<Args...> pattern, Args&&... args) {
    FixedText text;
    const std::size_t size =
        format_into(text.data_.data(), Capacity, pattern, fmt::make_format_args(args...));
    text.size_ = static_cast<std::uint16_t>(std::min(size, Capacity));
    return text;
  }

 private:
  std::uint16_t size_ = 0;
  std::array<char, Capacity> data_{};
};

}  // namespace kerf
