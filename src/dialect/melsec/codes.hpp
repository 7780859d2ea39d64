#pragma once
// The words of the MELSEC G-code control (manual 5.4, 5.6, 5.7): what `kerf codes` lists and the interpreter
// knows.

#include <array>
#include <cstdint>
#include <span>

#include "execute/action.hpp"
#include "execute/code_table.hpp"

namespace kerf::melsec {

std::span<const CodeRow> code_table();

/// The G codes, in the order of the code table; the place of a code is its bit in a set of codes.
inline constexpr std::array<CodeNumber, 40> kGCodes{
    code(0),  code(1),     code(2),     code(3),     code(17), code(18), code(19),    code(90),
    code(91), code(94),    code(4),     code(9),     code(38), code(39), code(52),    code(53),
    code(65), code(40),    code(41),    code(42),    code(43), code(44), code(49),    code(54),
    code(55), code(56),    code(57),    code(58),    code(59), code(61), code(61, 1), code(62),
    code(64), code(40, 1), code(41, 1), code(42, 1), code(68), code(69), code(12, 1), code(13, 1)};

/// A set of G codes, a bit each.
using CodeSet = std::uint64_t;

/// The set of one code; empty for a number that is no code.
constexpr CodeSet set_of(CodeNumber number) {
  for (std::size_t i = 0; i < kGCodes.size(); ++i) {
    if (kGCodes[i] == number) return CodeSet{1} << i;
  }
  return 0;
}

/// What a code of group 13 asks of the path.
constexpr PathMode path_mode_of(CodeNumber number) {
  if (number == code(64)) return PathMode::cutting;
  if (number == code(61)) return PathMode::exact_stop;
  return number == code(62) ? PathMode::corner_override : PathMode::high_accuracy;
}

/// AxisSettings::other_rates: rates of the axes under G61.1.
inline constexpr RateSet kHighAccuracyRates = 1;

constexpr RateSet rate_set_of(PathMode mode) {
  return mode == PathMode::high_accuracy ? kHighAccuracyRates : RateSet{0};
}

}  // namespace kerf::melsec
