#pragma once
// The path as it is programmed, where tool radius compensation leads the tool beside it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "execute/action.hpp"

namespace kerf {

/// Collects from the actions in front of the toolpath the moves that compensation changes: those with a
/// compensation in force, and the one behind them that leads back to the programmed path. Moves in other
/// planes than X-Y, Z-X and Y-Z are left out: no picture looks at them. Beyond `kMost` moves nothing is kept,
/// and `truncated()` says so.
class ProgrammedPath {
 public:
  static constexpr std::size_t kMost = 200'000;

  /// An action as the program has it.
  void add(const Action& action);

  /// Forgets the moves behind a block (Origin::block), for a record that ends with it.
  void end_at(std::uint32_t block);

  std::size_t size() const { return moves_.size(); }
  bool truncated() const { return truncated_; }
  /// A move with the X, Y and Z of its start and end, its arc and its plane; everything else is left out.
  Move operator[](std::size_t i) const;

 private:
  /// What a picture needs of a Move, a quarter of its size.
  struct Kept {
    std::uint32_t block = 0;
    MoveMode mode = MoveMode::linear;
    Plane plane;
    std::array<double, 3> start{};
    std::array<double, 3> end{};
    Arc arc;
  };

  std::vector<Kept> moves_;
  bool displaced_ = false;  ///< the tool is beside the programmed path
  bool truncated_ = false;
};

}  // namespace kerf
