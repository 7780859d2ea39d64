#pragma once
// Moves in a polar plane in pieces over which the speed of the rotary axis changes little.

#include "execute/action.hpp"
#include "geometry/planar_segment.hpp"

namespace kerf {

/// Near the centre of rotation the rotary axis turns fast for a slow tool, so a law that gives a segment one
/// highest speed would go at the slowest everywhere. The pieces lie on the same line or arc, run into each
/// other (Move::passes_on), and each turns less than a quarter of a turn. A piece is found in bounded time,
/// and a move has at most a few hundred.
class PolarPieces {
 public:
  bool empty() const { return !more_; }
  /// Begins with a move of PolarForm::axes. Only when empty.
  void take(const Action& action);
  /// The next piece, valid until the following call.
  const Action& next();

 private:
  Action whole_;
  Action piece_;
  PlanarSegment contour_;  ///< of the whole move
  double done_ = 0.0;      ///< part of it
  bool more_ = false;
};

}  // namespace kerf
