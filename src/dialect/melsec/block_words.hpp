#pragma once
// The words of one block sorted (manual 5.1, 5.4, 5.6).

#include <array>
#include <optional>

#include "base/alarm.hpp"
#include "base/axis.hpp"
#include "dialect/melsec/codes.hpp"
#include "execute/code_table.hpp"
#include "syntax/block.hpp"

namespace kerf::melsec {

// One-shot codes, as sets of one.
inline constexpr CodeSet kDwell = set_of(code(4));
inline constexpr CodeSet kCornerVector = set_of(code(38));
inline constexpr CodeSet kCornerArc = set_of(code(39));
inline constexpr CodeSet kExactStop = set_of(code(9));
inline constexpr CodeSet kLocalSystem = set_of(code(52));
inline constexpr CodeSet kMachineMove = set_of(code(53));
inline constexpr CodeSet kMacroCall = set_of(code(65));

/// M codes that steer the program itself.
enum class ProgramCode : std::uint8_t { none, stop, end, call, go_back };

/// An axis word: the last one of its axis, and whether G91 was in force where it stands.
struct AxisWord {
  const Word* word = nullptr;
  bool incremental = false;
};

/// The axes of the machine, and those of them that follow another one.
struct LineAxes {
  AxisSet all;
  AxisSet followers;
};

/// Ten times the number of a G word; nothing when no code can have it.
std::optional<CodeNumber> code_number(const Word& word);

/// The set of a code of the code table, or of kNoCode; faster than set_of() while running.
CodeSet set_of_known(CodeNumber number);

/// Sorts a block. The last word of an address is valid, the last code of a group, the last four M codes; what
/// stands behind G65 is an argument, unless it is a G code.
class BlockWords {
 public:
  static constexpr std::size_t kAuxiliaries = 4;

  /// False: `alarm` says what is wrong. `distance` is the code of G90 and G91 in force before the block.
  /// Words of axes that follow another one are ignored (6.8).
  bool collect(const Block& block, CodeNumber distance, const LineAxes& line, std::optional<Alarm>& alarm);

  CodeNumber operator[](Group group) const { return codes_[static_cast<std::size_t>(group)]; }
  bool has(Group group) const { return (*this)[group] != kNoCode; }
  bool has(CodeSet codes) const { return (code_set_ & codes) != 0; }
  /// The codes that count: the last one of each group, and all one-shot codes.
  CodeSet codes() const { return code_set_; }
  const Word* find(char address) const { return values_[static_cast<std::size_t>(address - 'A')]; }
  const Word* rapid_feed() const { return rapid_feed_; }
  const AxisWord& axis(Axis axis) const { return axes_[index(axis)]; }
  AxisSet axes() const { return named_; }
  /// Takes no notice of the words of an axis.
  void ignore(Axis axis) { named_.erase(axis); }
  ProgramCode program_code() const { return program_code_; }
  /// M codes for the machine, of the last four M codes of the block.
  const FixedVector<std::int32_t, kAuxiliaries>& auxiliaries() const { return auxiliaries_; }
  /// First word behind G65; the number of words without it.
  std::size_t first_argument() const { return first_argument_; }
  /// The word that holds the group's code.
  const Word& word(Group group) const { return *code_at_[static_cast<std::size_t>(group)]; }

 private:
  bool take_code(const Block& block, const Word& word, std::optional<Alarm>& alarm);
  bool take_auxiliary(const Block& block, const Word& word, std::optional<Alarm>& alarm);
  void sort_auxiliaries();
  bool take_value(const Block& block, const Word& word, const LineAxes& line, std::optional<Alarm>& alarm);

  std::array<CodeNumber, kGroupCount> codes_{};
  std::array<const Word*, kGroupCount> code_at_{};
  std::array<const Word*, 26> values_{};
  std::array<AxisWord, kAxisCount> axes_{};
  AxisSet named_;
  const Word* rapid_feed_ = nullptr;
  FixedVector<std::int32_t, kAuxiliaries> auxiliaries_;
  CodeSet code_set_ = 0;
  ProgramCode program_code_ = ProgramCode::none;
  std::size_t first_argument_ = 0;
  bool incremental_ = false;
};

}  // namespace kerf::melsec
