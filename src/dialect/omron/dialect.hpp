#pragma once
// The OMRON NJ/NY NC Integrated Controller as a dialect.

#include "dialect/dialect.hpp"

namespace kerf::omron {

Dialect dialect();

}  // namespace kerf::omron
