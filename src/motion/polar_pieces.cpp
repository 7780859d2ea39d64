#include "motion/polar_pieces.hpp"

#include <cmath>

#include "execute/polar_plane.hpp"
#include "geometry/polar.hpp"

namespace kerf {
namespace {

constexpr double kMostTurn = 90.0;      // degrees
constexpr double kRateSpread = 1.3;     // of the rotary axis's rate over a piece
constexpr double kRadiusSpread = 2.0;   // where that rate changes; its change grows towards the centre
constexpr double kSmallestPart = 1e-6;  // of the move
constexpr double kShortest = 1e-5;      // mm

bool is_even(const PlanarSegment& piece) {
  const PolarRange range = polar_range(piece);
  if (range.greatest_turn_deg - range.least_turn_deg > kMostTurn) return false;
  const PolarRates rates = polar_rates(piece);
  if (rates.turn2 > 0.0 && range.greatest_radius > kRadiusSpread * range.least_radius) return false;
  return rates.turn <= kRateSpread * rates.least_turn;
}

}  // namespace

void PolarPieces::take(const Action& action) {
  whole_ = action;
  piece_ = action;
  contour_ = polar_contour(std::get<Move>(action.what));
  done_ = 0.0;
  more_ = true;
}

const Action& PolarPieces::next() {
  const Move& whole = std::get<Move>(whole_.what);
  Move& piece = std::get<Move>(piece_.what);
  const bool first = done_ <= 0.0;
  double end = 1.0;
  PlanarSegment contour = part_of(contour_, done_, end);
  const double least = done_ + kSmallestPart;
  while (end > least && length_of(contour) > kShortest && !is_even(contour)) {
    end = 0.5 * (done_ + end);
    contour = part_of(contour_, done_, end);
  }
  const PolarPlane& polar = whole.polar;
  const double side = polar.minus ? -1.0 : 1.0;
  if (!first) piece.start = piece.end;
  if (first) piece.start = whole.start;
  piece.end = between(whole.start, whole.end, end);
  if (end < 1.0) {
    piece.end[polar.linear] = polar.center + side * length(contour.end);
    piece.end[polar.rotary] = piece.start[polar.rotary] + turn_around_origin_deg(contour);
  }
  if (is_arc(whole.mode)) piece.arc.sweep = contour.sweep_deg;
  piece.from_rest = whole.from_rest && first;
  more_ = end < 1.0;
  piece.passes_on = more_;
  piece.exact_stop = whole.exact_stop && !more_;
  done_ = end;
  return piece_;
}

}  // namespace kerf
