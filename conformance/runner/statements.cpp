#include "conformance/runner/statements.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <set>

namespace kerf::conformance {
namespace {

/// How rows of a table without ids are named.
struct Naming {
  std::string_view column;
  std::string_view prefix;
};

constexpr Naming kNamings[] = {{"id", ""}, {"word", "DGC-"}, {"code", "DGK-"}};

}  // namespace

tl::expected<StatementTable, FileError> parse_statements(const std::string& file, std::string_view text) {
  StatementTable table;
  table.name = std::filesystem::path(file).stem().string();
  table.dialect = table.name.substr(0, table.name.find('_'));
  const std::vector<TextLine> lines = lines_of(text);
  if (lines.empty()) return tl::unexpected(FileError{file, 0, "the table is empty"});
  const std::vector<std::string> header = parts_of(lines.front().text, '\t');
  const auto* naming = std::find_if(std::begin(kNamings), std::end(kNamings),
                                    [&](const Naming& candidate) { return candidate.column == header[0]; });
  if (naming == std::end(kNamings)) {
    return tl::unexpected(
        FileError{file, 1, fmt::format("a table cannot begin with the column '{}'", header[0])});
  }
  const auto statement = std::find(header.begin(), header.end(), "statement");
  const std::size_t text_column =
      statement != header.end() ? static_cast<std::size_t>(statement - header.begin()) : std::size_t{0};

  std::map<std::string, int> seen;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (trimmed(lines[i].text).empty()) continue;
    const std::vector<std::string> cells = parts_of(lines[i].text, '\t');
    if (cells.size() != header.size()) {
      return tl::unexpected(
          FileError{file, lines[i].number,
                    fmt::format("{} cells in a table of {} columns", cells.size(), header.size())});
    }
    std::string id = fmt::format("{}{}", naming->prefix, cells[0]);
    const int count = ++seen[id];
    if (count > 1 && naming->prefix.empty()) {
      return tl::unexpected(
          FileError{file, lines[i].number, fmt::format("the id {} stands there twice", id)});
    }
    if (count > 1) id += fmt::format("-{}", count);
    const std::string all = fmt::format("{}", fmt::join(cells, " "));
    table.statements.push_back({std::move(id), text_column != 0 ? cells[text_column] : all});
  }
  return table;
}

}  // namespace kerf::conformance
