#pragma once
// Which text of the programs a report quotes.

#include <string_view>

#include "execute/action.hpp"
#include "report/html_report.hpp"

namespace kerf {

/// The text the action's program was read from.
std::string_view source_of(const ReportInput& input, const Origin& origin);

/// The block of an action, without its line end, at most 400 bytes. Empty when the text does not hold it.
std::string_view block_text(const ReportInput& input, const Origin& origin);

}  // namespace kerf
