#pragma once
// The words of one block sorted (manual 1-5, 1-7).

#include <array>
#include <optional>

#include "base/alarm.hpp"
#include "base/axis.hpp"
#include "execute/code_table.hpp"
#include "syntax/block.hpp"

namespace kerf::omron {

/// The place of an address, which is a plain letter, in a table of all of them.
constexpr std::size_t place_of(char address) {
  return static_cast<unsigned char>(address);
}

class BlockWords {
 public:
  /// False: `alarm` says what is wrong.
  bool collect(const Block& block, std::optional<Alarm>& alarm);

  CodeNumber operator[](Group group) const { return codes_[static_cast<std::size_t>(group)]; }
  bool has(Group group) const { return (*this)[group] != kNoCode; }
  bool has_exact_stop() const { return exact_stop_; }
  /// G09 stands in front of the axis words.
  bool exact_stop_leads() const { return exact_stop_leads_; }
  /// The word that holds the group's code.
  const Word& word(Group group) const { return *code_at_[static_cast<std::size_t>(group)]; }

  const Word* find(char address) const { return values_[place_of(address)]; }
  /// The axis words, X Y Z A B C.
  AxisSet axes() const { return axes_; }
  const Word& axis(Axis axis) const { return *find(letter(axis)); }
  /// The M code, -1 without one.
  std::int32_t m_code() const { return m_code_; }
  const Word& m_word() const { return *find('M'); }

 private:
  bool take_g_code(const Block& block, const Word& word, std::optional<Alarm>& alarm);
  bool take_m_code(const Block& block, const Word& word, std::optional<Alarm>& alarm);

  std::array<CodeNumber, kGroupCount> codes_{};
  std::array<const Word*, kGroupCount> code_at_{};
  std::array<const Word*, 128> values_{};
  AxisSet axes_;
  std::int32_t m_code_ = -1;
  bool exact_stop_ = false;
  bool exact_stop_leads_ = false;
};

}  // namespace kerf::omron
