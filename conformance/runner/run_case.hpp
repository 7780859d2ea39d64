#pragma once
// Runs one case.

#include <string>

#include "conformance/runner/case.hpp"

namespace kerf::conformance {

/// Empty when everything is as expected, otherwise what is not, with the program's lines to compare.
std::string run_case(const Case& test, const std::string& dialect);

}  // namespace kerf::conformance
