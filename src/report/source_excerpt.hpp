#pragma once
// One line of a source text, laid out for a display with a marked stretch under it.

#include <string>
#include <string_view>

#include "base/source_span.hpp"

namespace kerf {

/// The line of `source` in which the span begins, without its line end. Empty when the span has no place or
/// lies outside the text (an alarm of another file). Of a very long line the part up to 64 KiB behind the
/// place.
std::string_view line_of(std::string_view source, const SourceSpan& span);

/// A line as shown: tabs as spaces, control codes as visible stand-ins, cut with `…` where it is too long.
struct Excerpt {
  std::string text;  ///< UTF-8
  int indent = 0;    ///< columns before the mark
  int width = 1;     ///< columns of the mark, at least 1
};

/// Lays out the line of a span in at most `columns` (at least 20) columns, so that the start of the span is
/// visible.
Excerpt excerpt_of(std::string_view source, const SourceSpan& span, int columns);

}  // namespace kerf
