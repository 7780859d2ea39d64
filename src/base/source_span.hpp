#pragma once
// Where in a source text something stands.

#include <cstdint>

namespace kerf {

/// A stretch of one line of a source text. Lines and columns count from 1, columns in bytes; line 0 means "no
/// place".
struct SourceSpan {
  std::uint64_t offset = 0;  ///< bytes from the start of the text
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::uint32_t length = 0;  ///< bytes

  friend constexpr bool operator==(const SourceSpan&, const SourceSpan&) = default;
};

}  // namespace kerf
