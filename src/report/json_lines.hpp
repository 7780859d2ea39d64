#pragma once
// The events of `kerf path --json`: one JSON object a line, in order of execution.

#include <functional>
#include <string>

#include "execute/action.hpp"
#include "machine/machine.hpp"

namespace kerf {

/// Writes actions as JSON Lines. Lengths in mm, angles in degrees, feeds in mm/min, times in seconds, machine
/// coordinates; every number reads back as the double it was. A move in a polar plane has the positions of
/// its axes at its ends, and the member polar: x = r cos a, y = r sin a on the work, r being the linear axis
/// less `center`, a the rotary axis less `zero`; between its ends it runs straight there, or on the arc. The
/// same action always gives the same bytes.
class JsonLines {
 public:
  /// The feed that is in force for a move that is no rapid, mm/min: the programmed one after clamping and
  /// override.
  using EffectiveFeed = std::function<double(const Move&)>;

  /// Without `feed` the programmed feed is written. Only the axes of `machine` appear.
  explicit JsonLines(const Machine& machine, EffectiveFeed feed = {});

  /// Appends one line and its line end. A CornerArc belongs between two stages of the toolpath and writes
  /// nothing.
  void write(const Action& action, std::string& out) const;

 private:
  void write_move(const Origin& origin, const Move& move, std::string& out) const;
  void write_axes(const AxisVector& position, std::string& out) const;

  AxisSet axes_;
  EffectiveFeed feed_;
};

}  // namespace kerf
