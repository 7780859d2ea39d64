#pragma once
// Expected against observed events.

#include <set>
#include <string>
#include <vector>

#include "conformance/runner/case.hpp"

namespace kerf::conformance {

/// The events whose kind is watched. `refused` always is.
std::vector<Entry> watched_events(const std::vector<Entry>& events, const std::set<std::string>& kinds);

/// Whether every word and field of `expected` stands in `observed`, numbers within the tolerance. An alarm or
/// a warning without a word fits any; in all other events the words must be the same.
bool fits(const Entry& expected, const Entry& observed, double tolerance);

/// Empty when the lists fit entry by entry. Otherwise one line an event: `  ` as expected, `- ` expected and
/// missing, `+ ` observed and not expected; behind a pair that differs only in values stands what differs.
std::string event_difference(const std::vector<Entry>& expected, const std::vector<Entry>& observed,
                             double tolerance);

/// The events without what tells two places of a program, or two places of the machine, apart: line, column,
/// n and machine coordinates. For the fact `same`.
std::vector<Entry> without_place(const std::vector<Entry>& events);

}  // namespace kerf::conformance
