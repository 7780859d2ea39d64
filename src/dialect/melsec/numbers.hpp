#pragma once
// What the number of a word means, by address (manual 5.4).

#include "execute/number_result.hpp"
#include "syntax/block.hpp"

namespace kerf::melsec {

/// Position, centre or angle: mm or degrees, without a decimal point counted in 0.0001; -9999.9999 to
/// 9999.9999. Values of expressions count whole units and are rounded to 0.0001, halves away from zero.
NumberResult position_of(const Word& word);
/// Radius or rotation angle: the same, up to 99999.9999.
NumberResult radius_of(const Word& word);
/// F: mm/min or degrees/min, without a decimal point counted in 1; 0.01 to 1000000.
NumberResult feed_of(const Word& word);
/// G04 X: seconds, without a decimal point counted in 0.001; 0 to 99999.999.
NumberResult seconds_of(const Word& word);
/// An address that takes integers only. Values of expressions are rounded, halves away from zero.
NumberResult integer_of(const Word& word, double lowest, double highest);
/// An argument of G65, as it is written: a missing decimal point stands at the end.
double argument_of(const Word& word);

}  // namespace kerf::melsec
