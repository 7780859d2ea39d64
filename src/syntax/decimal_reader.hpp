#pragma once
// Reads the digits of a number out of text.

#include "syntax/block.hpp"

namespace kerf {

/// Reads digits with at most one point at `p` into `number` and moves `p` behind them; false when there is no
/// digit. Leading zeros do not count, digits far below any increment are dropped, and more than 18 in front
/// of the point overflow. Source::kBehind bytes from `p` on must be readable, whatever stands in them.
bool read_decimal(const char*& p, Decimal& number);

}  // namespace kerf
