#pragma once
// The G-code control of the MELSEC iQ-R motion controller. Source: MELSEC iQ-R Motion Controller Programming
// Manual (G-code Control).

#include "dialect/dialect.hpp"

namespace kerf::melsec {

Dialect dialect();

}  // namespace kerf::melsec
