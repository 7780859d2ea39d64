#pragma once
// Which statements are proved, by what, and which are not.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "conformance/runner/statements.hpp"
#include "conformance/runner/text.hpp"

namespace kerf::conformance {

enum class ClaimKind : std::uint8_t {
  unit,    ///< a named unit test proves it
  reason,  ///< software cannot show it; the text says why
  later,   ///< it needs a part that kerf does not have yet; the text names the part
};

/// A row of conformance/claims.
struct Claim {
  std::string id;
  ClaimKind kind = ClaimKind::unit;
  std::string text;
  std::string file;
  std::uint32_t line = 0;
};

/// A tab-separated table with the header `id how text`.
tl::expected<std::vector<Claim>, FileError> parse_claims(const std::string& file, std::string_view text);

/// What the cases say about the ids they name.
struct CaseClaims {
  std::set<std::string> named;
  std::set<std::string> failed;  ///< by at least one case
};

enum class Proof : std::uint8_t { by_case, by_unit_test, by_reason, later, failed, missing };

struct TableCoverage {
  std::string name;
  std::map<Proof, std::size_t> counts;
  std::vector<Statement> missing;  ///< failed ones included
};

TableCoverage coverage_of(const StatementTable& table, const CaseClaims& cases,
                          const std::vector<Claim>& claims);

/// Claims of unknown ids, claims of one id twice, and `reason` and `later` claims of ids that a case proves
/// after all.
std::vector<FileError> claim_errors(const std::set<std::string>& known_ids, const CaseClaims& cases,
                                    const std::vector<Claim>& claims);

/// The names `Suite.Test` that a `unit` claim's text holds, in any order.
std::vector<std::string> unit_tests_of(const Claim& claim);

/// `unit` claims whose tests are not among those of the test sources.
std::vector<FileError> unit_test_errors(const std::vector<Claim>& claims, const std::set<std::string>& tests);

/// The tests that a GoogleTest source defines, as `Suite.Test`.
std::set<std::string> tests_defined_in(std::string_view source);

/// `dgshape: 614 statements: 590 by a case, 20 by a unit test, 4 by a reason, 0 for later, 0 failed, 0
/// missing`
std::string summary_line(const TableCoverage& coverage);

}  // namespace kerf::conformance
