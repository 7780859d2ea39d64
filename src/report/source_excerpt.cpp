#include "report/source_excerpt.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "report/text_escape.hpp"

namespace kerf {
namespace {

constexpr int kTabStop = 4;
constexpr char32_t kEllipsis = 0x2026;

/// How far from a place the end of its line is looked for.
constexpr std::size_t kLineReach = std::size_t{1} << 16;

/// One character of the line, as it is shown.
struct Cell {
  char32_t shown = 0;
  int column = 0;  ///< first column, from 0
  int width = 1;
  std::size_t byte = 0;
};

/// The bytes of a line that can come to be shown around a mark.
struct Slice {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// A line of a gigabyte is not laid out whole. Eight bytes a column leave room for UTF-8 and for characters
/// without a width.
Slice slice_around(std::string_view line, std::size_t mark, std::size_t columns) {
  const std::size_t reach = 8 * columns;
  const auto inside_character = [&line](std::size_t at) {
    return at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80U;
  };
  mark = std::min(mark, line.size());
  Slice slice{mark > reach ? mark - reach : 0, std::min(line.size(), mark + reach)};
  while (slice.begin < mark && inside_character(slice.begin)) ++slice.begin;
  while (slice.end > mark && inside_character(slice.end)) --slice.end;
  return slice;
}

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  cells.reserve(line.size());
  int column = 0;
  for (std::size_t at = 0; at < line.size();) {
    const Character character = first_character(line.substr(at));
    Cell cell{U' ', column, 1, at};
    if (character.code == '\t') {
      cell.width = kTabStop - column % kTabStop;
    } else {
      cell.shown = visible(character.code);
      cell.width = column_width(cell.shown);
    }
    cells.push_back(cell);
    column += cell.width;
    at += character.bytes;
  }
  return cells;
}

/// A stretch of columns, the end not included.
struct Columns {
  int first = 0;
  int last = 0;
};

/// The columns of the bytes [begin, end); a place behind the last character is the column after it.
Columns marked_columns(const std::vector<Cell>& cells, std::size_t begin, std::size_t end) {
  const int line_width = cells.empty() ? 0 : cells.back().column + cells.back().width;
  Columns mark{line_width, line_width};
  for (const Cell& cell : cells) {
    if (cell.byte <= begin) mark.first = cell.column;
    if (cell.byte < end) mark.last = cell.column + cell.width;
  }
  const bool behind = cells.empty() || begin > cells.back().byte;
  if (behind) mark.first = line_width;
  mark.last = std::max(mark.last, mark.first + 1);
  return mark;
}

/// The stretch of the line to show: all of it, or a window with the mark's start about a third from its left
/// edge.
Columns window_of(int line_width, const Columns& mark, int columns) {
  if (line_width <= columns) return {0, line_width};
  const bool mark_fits_from_start = mark.last <= columns - 1;
  if (mark_fits_from_start) return {0, columns};
  const int wanted = std::min(mark.first - columns / 3, mark.last - columns * 2 / 3);
  const int first = std::clamp(wanted, 0, std::max(0, line_width - columns));
  return {std::min(first, mark.first), std::min(first, mark.first) + columns};
}

}  // namespace

std::string_view line_of(std::string_view source, const SourceSpan& span) {
  if (span.line == 0 || span.offset > source.size() || span.column == 0) return {};
  const auto offset = static_cast<std::size_t>(span.offset);
  if (span.column - 1U > offset) return {};
  const std::size_t begin = offset - (span.column - 1U);
  const bool at_line_start = begin == 0 || source[begin - 1] == '\n' || source[begin - 1] == '\r';
  const std::size_t near = std::max(begin, offset - std::min(offset, kLineReach));
  const std::string_view around = source.substr(near, offset - near + kLineReach);
  const std::size_t end = near + std::min(around.find_first_of("\r\n"), around.size());
  if (!at_line_start || end < offset) return {};
  return source.substr(begin, end - begin);
}

Excerpt excerpt_of(std::string_view source, const SourceSpan& span, int columns) {
  columns = std::max(columns, 20);
  const std::string_view line = line_of(source, span);
  const std::size_t place = span.column == 0 ? 0 : span.column - 1U;
  const Slice slice = slice_around(line, place, static_cast<std::size_t>(columns));
  const std::vector<Cell> cells = cells_of(line.substr(slice.begin, slice.end - slice.begin));
  const std::size_t begin = place - slice.begin;
  const Columns mark = marked_columns(cells, begin, begin + span.length);
  const int line_width = cells.empty() ? 0 : cells.back().column + cells.back().width;
  const Columns window = window_of(line_width, mark, columns);

  Excerpt excerpt;
  // A cut end gives its column to the ellipsis.
  const bool cut_left = window.first > 0 || slice.begin > 0;
  const bool cut_right = window.last < line_width || slice.end < line.size();
  const int first = window.first + (cut_left ? 1 : 0);
  const int last = window.last - (cut_right ? 1 : 0);
  int column = window.first;
  if (cut_left) {
    append_utf8(excerpt.text, kEllipsis);
    ++column;
  }
  for (const Cell& cell : cells) {
    if (cell.column < first || cell.column + cell.width > last) continue;
    for (; column < cell.column; ++column) excerpt.text += ' ';
    const int repeats = cell.shown == U' ' ? cell.width : 1;
    for (int i = 0; i < repeats; ++i) append_utf8(excerpt.text, cell.shown);
    column += cell.width;
  }
  if (cut_right) {
    for (; column < last; ++column) excerpt.text += ' ';
    append_utf8(excerpt.text, kEllipsis);
  }
  excerpt.indent = mark.first - window.first;
  excerpt.width = std::max(1, std::min(mark.last, last) - mark.first);
  return excerpt;
}

}  // namespace kerf
