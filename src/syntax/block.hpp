#pragma once
// Words and blocks: the smallest parts of an NC program in the word-address format of ISO 6983 / JIS B 6315.

#include <cstdint>

#include "base/fixed_vector.hpp"
#include "base/source_span.hpp"

namespace kerf {

/// The number of a word exactly as it is written; what it means is the dialect's business.
struct Decimal {
  std::int64_t digits = 0;    ///< all digits as an integer with the sign, the point left out
  std::uint8_t decimals = 0;  ///< how many of the digits stand behind the point
  bool has_point = false;
  bool overflow = false;  ///< more than 18 significant digits in front of the point
};

/// An address letter and a number. In a language with expressions the value may be computed when the block is
/// executed; `number` then means nothing.
struct Word {
  char address = 0;              ///< upper case; lower case where a language has words of several letters
  bool comma = false;            ///< a comma stands in front: ,F
  bool is_computed = false;      ///< `computed` is the value
  std::int32_t expression = -1;  ///< in a compiled program: which expression gives the value; -1: none
  Decimal number;
  double computed = 0.0;
  std::uint32_t column = 0;  ///< of the address in its line, from 1
  std::uint32_t length = 0;  ///< bytes, address included
};

/// All words between two ends of block.
struct Block {
  static constexpr std::size_t kMaxWords = 128;
  SourceSpan span;               ///< from the first character of the line to its last, line end excluded
  bool skip_mark = false;        ///< a slash stands in front
  std::uint8_t skip_number = 0;  ///< of the signal that leaves it out, where there are several; 0: none
  FixedVector<Word, kMaxWords> words;
};

inline SourceSpan span_of(const Block& block, const Word& word) {
  return {block.span.offset + word.column - block.span.column, block.span.line, word.column, word.length};
}

}  // namespace kerf
