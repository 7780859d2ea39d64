// kerf_conformance: runs the conformance cases and reports which of the manuals' statements they prove.

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <getopt.h>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "conformance/runner/case_parser.hpp"
#include "conformance/runner/coverage.hpp"
#include "conformance/runner/run_case.hpp"
#include "conformance/runner/statements.hpp"

namespace kerf::conformance {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string directory;
  std::string table;   ///< only cases of its dialect; only its coverage
  std::string filter;  ///< only cases whose place, title or ids hold this text
  bool list_missing = false;
};

/// The files of a folder and the folders in it, in the order of their names.
std::vector<std::string> files_below(const fs::path& folder, std::string_view extension) {
  std::vector<std::string> files;
  if (!fs::is_directory(folder)) return files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == extension)
      files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Everything below the conformance folder, read.
struct Suite {
  std::vector<StatementTable> tables;
  std::vector<Claim> claims;
  std::vector<std::pair<std::string, Case>> cases;  ///< with their dialect
  std::set<std::string> unit_tests;
  std::vector<FileError> errors;
};

/// The settings that all cases of a dialect start from: the lines KEY=VALUE of its file `machine.set`.
std::vector<std::string> machine_of(const fs::path& folder) {
  std::vector<std::string> settings;
  for (const TextLine& line : lines_of(read_file((folder / "machine.set").string()).value_or(""))) {
    if (!line.text.empty() && line.text[0] != '#') settings.push_back(line.text);
  }
  return settings;
}

/// The frame of a dialect's programs: where its folder has a file `last_block`, they have no more around them
/// than that behind a body; elsewhere the % lines of ISO 6983.
ProgramFrame frame_of(const fs::path& folder) {
  const auto last_block = read_file((folder / "last_block").string());
  return last_block ? ProgramFrame{"", *last_block, ""} : ProgramFrame{};
}

Suite read_suite(const fs::path& directory) {
  Suite suite;
  const auto fail = [&](const FileError& error) { suite.errors.push_back(error); };
  for (const std::string& file : files_below(directory / "statements", ".tsv")) {
    auto table = parse_statements(file, read_file(file).value_or(""));
    if (table)
      suite.tables.push_back(*std::move(table));
    else
      fail(table.error());
  }
  for (const std::string& file : files_below(directory / "claims", ".tsv")) {
    auto claims = parse_claims(file, read_file(file).value_or(""));
    if (claims)
      std::move(claims->begin(), claims->end(), std::back_inserter(suite.claims));
    else
      fail(claims.error());
  }
  for (const std::string& file : files_below(directory / "cases", ".case")) {
    const std::string dialect = fs::relative(file, directory / "cases").begin()->string();
    CaseFile cases = parse_cases(file, read_file(file).value_or(""), frame_of(directory / "cases" / dialect));
    const std::vector<std::string> machine = machine_of(directory / "cases" / dialect);
    for (Case& test : cases.cases) {
      test.settings.insert(test.settings.begin(), machine.begin(), machine.end());
      suite.cases.emplace_back(dialect, std::move(test));
    }
    for (const FileError& error : cases.errors) fail(error);
  }
  for (const std::string& file : files_below(directory.parent_path() / "tests", ".cpp")) {
    suite.unit_tests.merge(tests_defined_in(read_file(file).value_or("")));
  }
  return suite;
}

bool is_selected(const Options& options, const std::string& dialect, const Case& test) {
  if (!options.table.empty() && options.table.substr(0, options.table.find('_')) != dialect) return false;
  const std::string text = fmt::format("{}:{} {} {} {}", test.file, test.line, test.title, test.alternative,
                                       fmt::join(test.ids, " "));
  return text.find(options.filter) != std::string::npos;
}

void print_failure(const Case& test, const std::string& text) {
  fmt::print("FAILED {}:{}: {}\n", test.file, test.line, test.title);
  if (!test.alternative.empty()) fmt::print("  {}\n", test.alternative);
  for (const TextLine& line : lines_of(text)) fmt::print("    {}\n", line.text);
}

/// Runs the selected cases. Returns how many failed.
std::size_t run_cases(const Options& options, const Suite& suite, CaseClaims& claims) {
  std::size_t run = 0;
  std::size_t failed = 0;
  for (const auto& [dialect, test] : suite.cases) {
    claims.named.insert(test.ids.begin(), test.ids.end());
    if (!is_selected(options, dialect, test)) continue;
    ++run;
    const std::string text = run_case(test, dialect);
    if (text.empty()) continue;
    ++failed;
    claims.failed.insert(test.ids.begin(), test.ids.end());
    print_failure(test, text);
  }
  fmt::print("{} cases, {} failed\n", run, failed);
  return failed;
}

void report_coverage(const Options& options, const Suite& suite, const CaseClaims& cases) {
  for (const StatementTable& table : suite.tables) {
    if (!options.table.empty() && options.table != table.name) continue;
    const TableCoverage coverage = coverage_of(table, cases, suite.claims);
    fmt::print("{}\n", summary_line(coverage));
    if (!options.list_missing) continue;
    for (const Statement& statement : coverage.missing)
      fmt::print("  {}  {}\n", statement.id, statement.text);
  }
}

int run(const Options& options) {
  const fs::path directory = fs::absolute(options.directory).lexically_normal();
  if (!fs::is_directory(directory / "cases")) {
    fmt::print(stderr, "{}: no folder with cases\n", options.directory);
    return 2;
  }
  Suite suite = read_suite(directory);
  std::set<std::string> known;
  for (const StatementTable& table : suite.tables) {
    for (const Statement& statement : table.statements) known.insert(statement.id);
  }
  for (const auto& [dialect, test] : suite.cases) {
    for (const std::string& id : test.ids) {
      if (known.count(id) == 0)
        suite.errors.push_back({test.file, test.line, fmt::format("there is no statement {}", id)});
    }
  }
  CaseClaims cases;
  const std::size_t failed = run_cases(options, suite, cases);
  for (const FileError& error : claim_errors(known, cases, suite.claims)) suite.errors.push_back(error);
  for (const FileError& error : unit_test_errors(suite.claims, suite.unit_tests))
    suite.errors.push_back(error);
  report_coverage(options, suite, cases);
  for (const FileError& error : suite.errors) fmt::print("ERROR {}\n", error_text(error));
  return failed == 0 && suite.errors.empty() ? 0 : 1;
}

}  // namespace
}  // namespace kerf::conformance

int main(int argc, char** argv) {
  constexpr std::string_view kUsage =
      "usage: kerf_conformance [--list-missing] [--table NAME] [--filter TEXT] DIR\n"
      "Runs the conformance cases of the conformance folder DIR and reports which of the manuals' statements "
      "they "
      "prove.\n"
      "  --list-missing   list the statements that nothing proves\n"
      "  --table NAME     only the cases and the coverage of this table\n"
      "  --filter TEXT    only cases whose place, title, alternative or ids hold this text\n";
  constexpr std::array kLong{option{"list-missing", no_argument, nullptr, 'l'},
                             option{"table", required_argument, nullptr, 't'},
                             option{"filter", required_argument, nullptr, 'f'}, option{}};
  kerf::conformance::Options options;
  for (int c = 0; (c = getopt_long(argc, argv, "", kLong.data(), nullptr)) != -1;) {
    if (c == 'l') options.list_missing = true;
    if (c == 't') options.table = optarg;
    if (c == 'f') options.filter = optarg;
    if (c == '?') {
      fmt::print(stderr, "{}", kUsage);
      return 2;
    }
  }
  if (optind + 1 != argc) {
    fmt::print(stderr, "{}", kUsage);
    return 2;
  }
  options.directory = argv[optind];
  return kerf::conformance::run(options);
}
