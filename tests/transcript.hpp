#pragma once
// What a program gives, a line for each action, to compare two ways of executing it.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <vector>

#include "dialect/setup.hpp"
#include "execute/interpreter.hpp"

namespace kerf {

inline std::string described(const AxisVector& v) {
  return fmt::format("{}", fmt::join(v.values, " "));
}

inline std::string described(const Action& action) {
  if (const auto* alarm = std::get_if<Alarm>(&action.what)) return std::string(alarm->kind->detail);
  const auto* move = std::get_if<Move>(&action.what);
  if (move == nullptr) return fmt::format("action {}", action.what.index());
  const RadiusCompensation& radius = move->compensation;
  const std::string beside =
      radius.side == Side::none
          ? ""
          : fmt::format(" {} {} {} in {}{}", radius.amount, radius.start, static_cast<int>(radius.rule),
                        letter(move->plane.first), letter(move->plane.second));
  return fmt::format("{} {} {} {} {} {} {} {} | {} | {} | {} F{}{}", static_cast<int>(move->mode),
                     static_cast<int>(move->path_mode), move->each_axis, move->axis_words,
                     static_cast<int>(move->compensation.side), move->rotary_feed.active, move->from_rest,
                     move->exact_stop, described(move->start), described(move->end),
                     described(move->commanded), move->feed, beside);
}

/// All actions of a program, alarms included, which it goes on behind; no more than a thousand.
inline std::vector<std::string> transcript(const Controller& controller, const std::string& name,
                                           const std::string& text) {
  Interpreter program(controller.rules, Source::from_text(name, text), controller.interpreter_options);
  std::vector<std::string> lines;
  while (lines.size() < 1000) {
    const Action* action = program.next();
    if (action == nullptr) break;
    lines.push_back(fmt::format("{}: {}", action->origin.span.line, described(*action)));
    program.recover();
  }
  return lines;
}

}  // namespace kerf
