#pragma once
// Lines of nothing but letters with a number behind each: what most of a long program consists of. They are
// read straight from the text whenever they are reached, so that a program of a million of them takes no more
// memory than its text.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "syntax/block.hpp"

namespace kerf {

/// The letters that words may have, A to Z.
class LetterSet {
 public:
  constexpr explicit LetterSet(std::string_view letters) {
    for (const char c : letters) bits_ |= 1U << static_cast<unsigned>(c - 'A');
  }
  constexpr bool contains(char c) const {
    const auto place = static_cast<unsigned char>(c - 'A');
    return place < 26 && (bits_ >> place & 1U) != 0;
  }

 private:
  std::uint32_t bits_ = 0;
};

/// A place in a text: where a line, or what is left of it, begins.
struct LinePlace {
  std::size_t at = 0;
  std::size_t start = 0;   ///< of the line
  std::uint32_t line = 0;  ///< from 1; 0: no place
};

/// Reads the line at `place` into `block`, every value computed, and moves `place` to the line behind; false,
/// with `place` unchanged, when the line is none of these: blanks, at most one block number (N and digits) in
/// front, then words of the letters, each with a number of at most 15 digits directly behind it, all
/// in kLongestPlainLine bytes. An empty line is read as a block without words. `text` is that of a Source.
bool read_plain_line(LinePlace& place, std::string_view text, LetterSet letters, Block& block);

/// The same without keeping the words.
bool pass_plain_line(LinePlace& place, std::string_view text, LetterSet letters, bool& has_words);

inline constexpr std::size_t kLongestPlainLine = 256;

}  // namespace kerf
