#pragma once
// Sentences wrapped between words for a terminal.

#include <string>
#include <string_view>

namespace kerf {

/// Appends `sentence` and a line end. The output stands at column `indent` already; further lines start
/// there, and none is longer than `width` columns unless a single word is. Control codes are made visible.
void append_wrapped(std::string& out, std::string_view sentence, int indent, int width);

}  // namespace kerf
