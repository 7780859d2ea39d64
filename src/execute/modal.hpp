#pragma once
// Modal groups and the codes in force.

#include <array>
#include <cstdint>

namespace kerf {

/// The groups of G codes over all dialects; a dialect uses those it has.
enum class Group : std::uint8_t {
  one_shot,  ///< acts in its own block only
  motion,
  plane,
  unit,
  distance,
  radius_compensation,
  length_compensation,
  scaling,
  work_system,
  fixed_cycle,
  return_level,
  feed_mode,
  path_mode,  ///< exact stop, cutting mode and the like
  normal_line,
  rotation,
  polar,
  mirror,
  multi_block,  ///< acceleration and deceleration over several blocks
};

inline constexpr std::size_t kGroupCount = 18;

/// Ten times the number of a code, so that G40.1 is 401.
using CodeNumber = std::uint16_t;

constexpr CodeNumber code(int whole, int tenth = 0) {
  return static_cast<CodeNumber>(whole * 10 + tenth);
}

/// No code: of a group that the dialect does not have, or that a block does not name.
inline constexpr CodeNumber kNoCode = 0xFFFF;

/// The G code in force in each group.
class ModalState {
 public:
  constexpr ModalState() { codes_.fill(kNoCode); }
  CodeNumber operator[](Group group) const { return codes_[static_cast<std::size_t>(group)]; }
  void set(Group group, CodeNumber number) { codes_[static_cast<std::size_t>(group)] = number; }

 private:
  std::array<CodeNumber, kGroupCount> codes_{};
};

}  // namespace kerf
