#pragma once
// The DGSHAPE NC code dialect. Source: NC Code Reference Manual, DGSHAPE Corporation, R2-171002.

#include "dialect/dialect.hpp"

namespace kerf::dgshape {

Dialect dialect();

}  // namespace kerf::dgshape
