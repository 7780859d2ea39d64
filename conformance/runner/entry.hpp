#pragma once
// Lines of `expect` and `after`, and what may stand in them.

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "conformance/runner/case.hpp"

namespace kerf::conformance {

/// Splits a line into name, words and fields; a value that is a number becomes one. The error is a message.
tl::expected<Entry, std::string> parse_entry(std::string_view text, std::uint32_t line);

/// Empty when the entry is a well-formed event, otherwise what is wrong with it.
std::string event_fault(const Entry& entry);

/// Empty when the entry is a well-formed fact, otherwise what is wrong with it.
std::string fact_fault(const Entry& entry);

/// What `watch` calls this event: rapid and linear are moves.
std::string watch_kind(std::string_view event_name);

bool is_watch_kind(std::string_view word);

/// All kinds but `warning`.
std::set<std::string> default_watch();

}  // namespace kerf::conformance
