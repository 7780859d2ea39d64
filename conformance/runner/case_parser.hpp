#pragma once
// Case files into cases.

#include <string>
#include <string_view>
#include <vector>

#include "conformance/runner/case.hpp"
#include "conformance/runner/text.hpp"

namespace kerf::conformance {

struct CaseFile {
  std::vector<Case> cases;        ///< every alternative of a `foreach` is a case of its own
  std::vector<FileError> errors;  ///< in the order of their lines; a case with an error is left out
};

/// What the runner puts around the blocks of a `body`, and of a `sub`.
struct ProgramFrame {
  std::string head = "%\n";
  std::string tail = "M02\n%\n";
  std::string sub_tail = "%\n";
};

CaseFile parse_cases(const std::string& file, std::string_view text, const ProgramFrame& frame = {});

}  // namespace kerf::conformance
