#pragma once
// Text of bounded length that never allocates, for messages made where allocation is forbidden.

#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <string_view>

namespace kerf {

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
    const auto result = fmt::format_to_n(text.data_.data(), Capacity, pattern, std::forward<Args>(args)...);
    text.size_ = static_cast<std::uint16_t>(std::min(result.size, Capacity));
    return text;
  }

 private:
  std::uint16_t size_ = 0;
  std::array<char, Capacity> data_{};
};

}  // namespace kerf
