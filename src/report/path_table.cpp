#include "report/path_table.hpp"

#include <fmt/format.h>
#include <iterator>
#include <utility>
#include <variant>

#include "report/action_text.hpp"
#include "report/number_text.hpp"
#include "report/text_escape.hpp"

namespace kerf {
namespace {

constexpr int kPositionDecimals = 4;  // the least increment of the machines, 0.0001 mm
constexpr int kPositionWidth = 11;    // -9999.9999 and a space
constexpr int kWhatWidth = 9;         // "arc ccw"
constexpr int kFeedWidth = 9;

/// Right-aligned in `width` columns, with at least one space before it.
void append_column(std::string& out, std::string_view text, int width) {
  const int padding = std::max(1, width - static_cast<int>(text.size()));
  out.append(static_cast<std::size_t>(padding), ' ');
  out += text;
}

void append_arc(std::string& out, const Move& move) {
  const auto number = [&out](double value) { append_rounded(out, value, kPositionDecimals); };
  out += "  R";
  number(move.arc.radius);
  out += " centre ";
  out += letter(move.plane.first);
  number(move.arc.center[0]);
  out += ' ';
  out += letter(move.plane.second);
  number(move.arc.center[1]);
  out += " sweep ";
  number(move.arc.sweep);
}

}  // namespace

PathTable::PathTable(const Machine& machine, EffectiveFeed feed)
    : axes_(machine.axes), feed_(std::move(feed)) {}

void PathTable::header(std::string& out) const {
  out += fmt::format("{:>7} {:>6}  {:<{}}", "line", "N", "what", kWhatWidth);
  for (const Axis axis : axes_) out += fmt::format("{:>{}}", letter(axis), kPositionWidth);
  out += fmt::format("{:>{}}  arc\n", "feed", kFeedWidth);
}

void PathTable::write(const Action& action, std::string& out) {
  if (std::holds_alternative<CornerArc>(action.what)) return;
  const Origin& origin = action.origin;
  if (origin.program != program_ && origin.program >= 0) {
    program_ = origin.program;
    fmt::format_to(std::back_inserter(out), "program {}\n", program_);
  }
  auto end = std::back_inserter(out);
  fmt::format_to(end, "{:>7} ", origin.span.line);
  if (origin.sequence_number >= 0) {
    fmt::format_to(end, "{:>6}  ", origin.sequence_number);
  } else {
    out.append(8, ' ');
  }
  if (const auto* move = std::get_if<Move>(&action.what)) {
    write_move(*move, out);
  } else {
    out += describe(action.what);
    if (const auto* alarm = std::get_if<Alarm>(&action.what)) {
      out += ": ";
      append_visible(out, message_of(*alarm));
    }
  }
  out += '\n';
}

void PathTable::write_move(const Move& move, std::string& out) const {
  fmt::format_to(std::back_inserter(out), "{:<{}}", describe(move), kWhatWidth);
  for (const Axis axis : axes_)
    append_column(out, fixed_text(move.end[axis], kPositionDecimals), kPositionWidth);
  if (move.mode == MoveMode::rapid) return;
  append_column(out, fixed_text(feed_ ? feed_(move) : move.feed, 1), kFeedWidth);
  if (is_arc(move.mode)) append_arc(out, move);
}

}  // namespace kerf
