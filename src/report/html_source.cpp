#include "report/html_source.hpp"

#include <algorithm>
#include <cstddef>

namespace kerf {

std::string_view source_of(const ReportInput& input, const Origin& origin) {
  return input.source_of_program ? input.source_of_program(origin.program) : input.source_text;
}

std::string_view block_text(const ReportInput& input, const Origin& origin) {
  constexpr std::size_t kLongest = 400;
  const std::string_view source = source_of(input, origin);
  const SourceSpan& span = origin.span;
  if (span.line == 0 || span.offset >= source.size()) return {};
  const auto begin = static_cast<std::size_t>(span.offset);
  const std::size_t line_end = std::min(source.find_first_of("\r\n", begin), source.size());
  const std::size_t span_end = span.length > 0 ? std::min(begin + span.length, line_end) : line_end;
  return source.substr(begin, std::min(span_end - begin, kLongest));
}

}  // namespace kerf
