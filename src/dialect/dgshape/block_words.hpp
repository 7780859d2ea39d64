#pragma once
// The words of one block sorted: codes by modal group, M codes in written order, values by address.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/alarm.hpp"
#include "base/fixed_vector.hpp"
#include "execute/code_table.hpp"
#include "syntax/block.hpp"

namespace kerf::dgshape {

using WordMask = std::uint32_t;

constexpr WordMask mask(char address) {
  return WordMask{1} << (address - 'A');
}

constexpr WordMask mask_of(std::string_view addresses) {
  WordMask all = 0;
  for (char address : addresses) all |= mask(address);
  return all;
}

/// Rows of the G and M codes by their two-digit number, null where the dialect has none.
class CodeIndex {
 public:
  CodeIndex();
  const CodeRow* find(char letter, const Decimal& number) const;

 private:
  std::array<const CodeRow*, 100> g_{};
  std::array<const CodeRow*, 100> m_{};
};

class BlockWords {
 public:
  /// False: `alarm` says what is wrong (unknown-code, repeated-word, conflicting-codes).
  bool collect(const Block& block, const CodeIndex& index, std::optional<Alarm>& alarm);

  bool has(char address) const { return (present_ & mask(address)) != 0; }
  WordMask present() const { return present_; }
  /// The word of an address that has() confirmed.
  const Word& word(char address) const { return (*block_)[at_[static_cast<std::size_t>(address - 'A')]]; }
  /// The code of a group, the last one when several were written (manual 1-3); kNoCode without.
  CodeNumber operator[](Group group) const { return codes_[static_cast<std::size_t>(group)]; }
  bool has(Group group) const { return (*this)[group] != kNoCode; }
  /// The word that holds the group's code.
  const Word& word(Group group) const { return (*block_)[code_at_[static_cast<std::size_t>(group)]]; }
  /// A motion code and a fixed cycle in one block: the later word is meant.
  bool cycle_behind_motion() const;
  const FixedVector<std::uint8_t, Block::kMaxWords>& m_words() const { return m_words_; }
  const Word& at(std::size_t i) const { return (*block_)[i]; }

 private:
  bool take_g(const Block& block, std::size_t i, const CodeIndex& index, std::optional<Alarm>& alarm);

  const FixedVector<Word, Block::kMaxWords>* block_ = nullptr;
  WordMask present_ = 0;
  std::array<std::uint8_t, 26> at_{};
  std::array<CodeNumber, kGroupCount> codes_{};
  std::array<std::uint8_t, kGroupCount> code_at_{};
  FixedVector<std::uint8_t, Block::kMaxWords> m_words_;
};

}  // namespace kerf::dgshape
