#include "conformance/runner/coverage.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <optional>

namespace kerf::conformance {
namespace {

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The next identifier behind `position`, which moves behind it.
std::string identifier_at(std::string_view text, std::size_t& position) {
  while (position < text.size() && std::isspace(static_cast<unsigned char>(text[position])) != 0) ++position;
  const std::size_t first = position;
  while (position < text.size() && is_name_character(text[position])) ++position;
  return std::string(text.substr(first, position - first));
}

Proof proof_of(const std::string& id, const CaseClaims& cases,
               const std::map<std::string, ClaimKind>& claims) {
  if (cases.failed.count(id) != 0) return Proof::failed;
  if (cases.named.count(id) != 0) return Proof::by_case;
  const auto claim = claims.find(id);
  if (claim == claims.end()) return Proof::missing;
  switch (claim->second) {
    case ClaimKind::unit:
      return Proof::by_unit_test;
    case ClaimKind::reason:
      return Proof::by_reason;
    case ClaimKind::later:
      return Proof::later;
  }
  return Proof::missing;
}

std::optional<ClaimKind> kind_named(std::string_view name) {
  if (name == "unit") return ClaimKind::unit;
  if (name == "reason") return ClaimKind::reason;
  if (name == "later") return ClaimKind::later;
  return std::nullopt;
}

}  // namespace

tl::expected<std::vector<Claim>, FileError> parse_claims(const std::string& file, std::string_view text) {
  const std::vector<TextLine> lines = lines_of(text);
  if (lines.empty() || lines.front().text != "id\thow\ttext") {
    return tl::unexpected(FileError{file, 1, "a table of claims begins with the columns id, how, text"});
  }
  std::vector<Claim> claims;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (trimmed(lines[i].text).empty()) continue;
    const std::vector<std::string> cells = parts_of(lines[i].text, '\t');
    const auto fail = [&](std::string message) {
      return tl::unexpected(FileError{file, lines[i].number, std::move(message)});
    };
    if (cells.size() != 3) return fail(fmt::format("{} cells in a table of 3 columns", cells.size()));
    const auto kind = kind_named(cells[1]);
    if (!kind) return fail(fmt::format("'{}' is none of unit, reason, later", cells[1]));
    if (trimmed(cells[2]).empty()) return fail("the claim has no text");
    claims.push_back({cells[0], *kind, cells[2], file, lines[i].number});
  }
  return claims;
}

TableCoverage coverage_of(const StatementTable& table, const CaseClaims& cases,
                          const std::vector<Claim>& claims) {
  std::map<std::string, ClaimKind> kinds;
  for (const Claim& claim : claims) kinds.emplace(claim.id, claim.kind);
  TableCoverage coverage;
  coverage.name = table.name;
  for (const Statement& statement : table.statements) {
    const Proof proof = proof_of(statement.id, cases, kinds);
    ++coverage.counts[proof];
    if (proof == Proof::missing || proof == Proof::failed) coverage.missing.push_back(statement);
  }
  return coverage;
}

std::vector<FileError> claim_errors(const std::set<std::string>& known_ids, const CaseClaims& cases,
                                    const std::vector<Claim>& claims) {
  std::vector<FileError> errors;
  std::set<std::string> seen;
  for (const Claim& claim : claims) {
    const auto fail = [&](std::string message) {
      errors.push_back({claim.file, claim.line, std::move(message)});
    };
    if (known_ids.count(claim.id) == 0) fail(fmt::format("there is no statement {}", claim.id));
    if (!seen.insert(claim.id).second) fail(fmt::format("{} is claimed twice", claim.id));
    if (claim.kind != ClaimKind::unit && cases.named.count(claim.id) != 0) {
      fail(fmt::format("{} is said not to be provable or not yet, but a case proves it", claim.id));
    }
  }
  return errors;
}

std::vector<std::string> unit_tests_of(const Claim& claim) {
  std::vector<std::string> tests;
  for (std::string word : words_of(claim.text)) {
    while (!word.empty() && !is_name_character(word.back())) word.pop_back();
    const std::size_t dot = word.find('.');
    const bool named =
        dot != std::string::npos && dot != 0 && dot + 1 < word.size() &&
        std::all_of(word.begin(), word.end(), [](char c) { return c == '.' || is_name_character(c); });
    if (named && std::isupper(static_cast<unsigned char>(word[0])) != 0) tests.push_back(std::move(word));
  }
  return tests;
}

std::vector<FileError> unit_test_errors(const std::vector<Claim>& claims,
                                        const std::set<std::string>& tests) {
  std::vector<FileError> errors;
  for (const Claim& claim : claims) {
    if (claim.kind != ClaimKind::unit) continue;
    const std::vector<std::string> named = unit_tests_of(claim);
    if (named.empty())
      errors.push_back({claim.file, claim.line, "the claim names no unit test (Suite.Test)"});
    for (const std::string& test : named) {
      if (tests.count(test) == 0)
        errors.push_back({claim.file, claim.line, fmt::format("there is no test {}", test)});
    }
  }
  return errors;
}

std::set<std::string> tests_defined_in(std::string_view source) {
  std::set<std::string> tests;
  for (const std::string_view macro : {"TEST(", "TEST_F(", "TEST_P("}) {
    for (std::size_t at = source.find(macro); at != std::string_view::npos; at = source.find(macro, at)) {
      at += macro.size();
      const std::string suite = identifier_at(source, at);
      if (at < source.size() && source[at] == ',') {
        ++at;
        tests.insert(suite + "." + identifier_at(source, at));
      }
    }
  }
  return tests;
}

std::string summary_line(const TableCoverage& coverage) {
  const auto count = [&](Proof proof) {
    const auto found = coverage.counts.find(proof);
    return found == coverage.counts.end() ? std::size_t{0} : found->second;
  };
  std::size_t all = 0;
  for (const auto& [proof, number] : coverage.counts) all += number;
  return fmt::format(
      "{}: {} statements: {} by a case, {} by a unit test, {} by a reason, {} for later, {} failed, {} "
      "missing",
      coverage.name, all, count(Proof::by_case), count(Proof::by_unit_test), count(Proof::by_reason),
      count(Proof::later), count(Proof::failed), count(Proof::missing));
}

}  // namespace kerf::conformance
