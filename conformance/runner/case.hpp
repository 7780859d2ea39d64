#pragma once
// A conformance case as it is written: a machine, programs, and what they must do. The format is described in
// conformance/README.md.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace kerf::conformance {

/// `X=10` or `plane=XY`.
struct Field {
  std::string key;
  std::variant<double, std::string> value;
  std::optional<double> tolerance = std::nullopt;  ///< of this value; otherwise the case's
};

/// A line of `expect` or `after`: `cw X=10 radius=5`, `alarm no-feed line=3`, `program=1`. Observed events
/// have the same shape, so that both print alike.
struct Entry {
  std::string name;                ///< rapid, dwell, alarm, offset, ...
  std::vector<std::string> words;  ///< what stands behind it without `=`
  std::vector<Field> fields;
  std::uint32_t line = 0;  ///< in the case file

  const Field* find(std::string_view key) const;
};

std::string entry_text(const Entry& entry);

/// One program and what it must do.
struct ProgramSection {
  std::string text;                            ///< with line feeds; the runner's own % and M02 included
  std::map<std::int32_t, std::string> others;  ///< programs it may call, by their numbers
  std::uint32_t line = 0;
  std::vector<Entry> expected;
  std::vector<Entry> facts;
};

struct OverrideChange {
  double time_s = 0.0;
  std::optional<double> feed_percent;
  std::optional<double> rapid_percent;
};

enum class LineEnd : std::uint8_t { lf, crlf, cr };

struct Case {
  std::string file;
  std::uint32_t line = 0;
  std::string title;
  std::string alternative;  ///< the values of `foreach`; empty: none
  std::vector<std::string> ids;
  std::vector<std::string> settings;  ///< KEY=VALUE
  bool ideal = false;
  std::set<std::string> watched;  ///< moves, dwell, spindle, ...
  LineEnd line_end = LineEnd::lf;
  bool optional_stop = false;
  bool block_skip = false;
  bool recover = false;
  std::vector<OverrideChange> changes;
  double tolerance = 0.0006;
  std::vector<ProgramSection> programs;
};

}  // namespace kerf::conformance
