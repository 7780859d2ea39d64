#pragma once
// The facts of `after`.

#include <string>
#include <vector>

#include "conformance/runner/case.hpp"
#include "conformance/runner/rig.hpp"

namespace kerf::conformance {

/// One line for every fact that does not hold, with what was found instead; empty when all hold. `before` is
/// the run of the program before this one of the case, or null.
std::string fact_differences(const Case& test, const ProgramSection& section, const Controller& controller,
                             const ProgramRun& run, const ProgramRun* before);

}  // namespace kerf::conformance
