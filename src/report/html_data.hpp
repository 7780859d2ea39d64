#pragma once
// The numbers of a run as a compact JSON object that the script of the HTML report draws.

#include <string>

#include "report/html_report.hpp"

namespace kerf {

/// Appends one JSON object, safe inside a <script> element. Numbers are integers of a fixed unit, each given
/// as the difference from the one before (the script adds them up), so that long toolpaths stay small:
///
///   axes      letters of the positions below: X, Y, Z, every rotary axis that turns, and that of normal line
///             control
///   limits    per axis [low, high], 0.001 mm or degree, not differences: "all" that is drawn, and "feed":
///             the cutting moves
///   rows      executed blocks: line, text (index into texts), count (actions of the block)
///   texts     block texts
///   actions   kinds (one letter each: r l c a are moves, rapid, line, clockwise, anticlockwise; x an alarm,
///             w a warning, o anything else), start and duration (0.1 ms), notes {index: words} of those that
///             do not move
///   moves     length (0.001 mm), peak (0.1 mm/min), and a path: end (per axis), jumps [move, position...]
///             where a move does not start at the end of the one before, arcs: move, plane (0 XY, 1 ZX, 2 YZ,
///             3 other), first, second (centre), sweep (0.001 degree)
///   programmed  null, or the programmed path of compensated moves: a path, plane of each move
///   swept     runs of compensated cutting moves with the same amount: move (the first), count, radius, plane
///   pointing  null, or axis (a letter) and runs of moves under normal line control: move, count, zero (of
///             the axis, 0.001 degree), plane
///   holes     x, y, bottom
///   speed     time (0.1 ms), feed (0.1 mm/min), line
void append_report_data(std::string& out, const ReportInput& input);

}  // namespace kerf
