#pragma once
// The manual's statements: the tables of conformance/statements.

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "conformance/runner/text.hpp"

namespace kerf::conformance {

struct Statement {
  std::string id;
  std::string text;
};

struct StatementTable {
  std::string name;     ///< of the file, without .tsv
  std::string dialect;  ///< the name up to the first _
  std::vector<Statement> statements;
};

/// A tab-separated table with a header line. What makes the id depends on the first column:
/// - `id`: it is the id; the text is the column `statement`;
/// - `word`: DGC-G01, and DGC-X, DGC-X-2, DGC-X-3 for a word that stands there several times;
/// - `code`: DGK-01.
tl::expected<StatementTable, FileError> parse_statements(const std::string& file, std::string_view text);

}  // namespace kerf::conformance
