// Tool radius compensation as the blocks command it (G40, G41, G42). Where the tool goes is the business of
// the toolpath (RadiusCompensationPass).

#include <cmath>

#include "dialect/omron/block_run.hpp"

namespace kerf::omron {
namespace {

constexpr double kRounding = 1e-6;  // mm

double way_in_plane(const Move& move) {
  const auto along = [&move](Axis axis) { return move.end[axis] - move.start[axis]; };
  return std::hypot(along(move.plane.first), along(move.plane.second));
}

bool is_shorter(const Move& move, double radius) {
  return way_in_plane(move) < radius - kRounding;
}

}  // namespace

bool BlockRun::radius_compensation() {
  if (!words_.has(Group::radius_compensation)) return true;
  const CodeNumber wanted = words_[Group::radius_compensation];
  const CodeNumber before = registers.modal[Group::radius_compensation];
  const SourceSpan where = span(words_.word(Group::radius_compensation));
  if (wanted != code(40) && (before == code(40) ? registers.offset_return_pending : wanted != before))
    return refuse("compensation-word", where);
  registers.modal.set(Group::radius_compensation, wanted);
  if (wanted == code(40)) {
    registers.offset_return_pending = before != code(40) && !registers.offset_start_pending;
    registers.offset_start_pending = false;
  } else if (before == code(40)) {
    const Tool* tool = selected_tool();
    registers.radius_amount = tool == nullptr ? 0.0 : tool->radius;
    registers.offset_start_pending = true;
    registers.offset_unused = false;
    ++registers.radius_start;
  }
  return true;
}

/// Fills in what the compensation does to a move. A figure that is turned over has the tool on its other
/// side.
bool BlockRun::compensate(Move& move) {
  if (!is_compensating()) return true;
  move.plane = plane_in_force();
  move.axis_words = words_.axes().contains(move.plane.first) || words_.axes().contains(move.plane.second);
  const bool moves = is_arc(move.mode) || way_in_plane(move) > kRounding;
  if (!compensates()) {
    if (!moves && !move.axis_words) return true;
    registers.offset_return_pending = false;
    return ends(move);
  }
  if (registers.offset_start_pending) {
    if (!moves) return true;
    registers.offset_start_pending = false;
    registers.offset_unused = true;
    if (!starts(move)) return false;
  } else if (move.mode == MoveMode::rapid) {
    return refuse("compensation-word", block_.span);
  } else if (moves) {
    registers.offset_unused = false;
  }
  const bool left = (registers.modal[Group::radius_compensation] == code(41)) !=
                    arc_change(registers.placement, move.plane).turns_over;
  const bool inside = is_arc(move.mode) && left == (move.arc.sweep > 0.0);
  if (inside && move.arc.radius <= registers.radius_amount + kRounding)
    return refuse("compensation-radius", block_.span,
                  FixedText<200>::format("The tool's radius is {:.4f} mm, that of the arc {:.4f} mm.",
                                         registers.radius_amount, move.arc.radius));
  move.compensation.side = left ? Side::left : Side::right;
  move.compensation.amount = registers.radius_amount;
  move.compensation.start = registers.radius_start;
  return true;
}

bool BlockRun::starts(const Move& move) {
  if (move.mode != MoveMode::linear) return refuse("compensation-start", block_.span);
  return !is_shorter(move, registers.radius_amount) ||
         refuse("compensation-start", block_.span,
                FixedText<200>::format("The starting move is shorter than the tool's radius of {:.4f} mm.",
                                       registers.radius_amount));
}

bool BlockRun::ends(const Move& move) {
  if (registers.offset_unused)
    return refuse("compensation-end", block_.span, "No move stands between its start and its end.");
  if (is_arc(move.mode)) return refuse("compensation-end", block_.span);
  return !is_shorter(move, registers.radius_amount) ||
         refuse(
             "compensation-end", block_.span,
             FixedText<200>::format("The move that ends it is shorter than the tool's radius of {:.4f} mm.",
                                    registers.radius_amount));
}

/// Nothing that waits for a movement to end, and no stop; the program may not end either.
bool BlockRun::compensation_allows_m_code() {
  if (!is_compensating()) return true;
  const std::int32_t number = words_.m_code();
  const SourceSpan where = span(words_.m_word());
  if (number == 2 || number == 30 || (number == 99 && level_ == 0)) return refuse("compensation-end", where);
  if (number == 98 || number == 99) return true;
  const bool immediate = m_timing() == OutputTiming::immediate;
  const bool stops = number <= 1;
  return (immediate && !stops) || refuse("compensation-word", where);
}

}  // namespace kerf::omron
