#pragma once
// Which G codes the controller refuses in one block, and which while another one is in force (manual 5.6, the
// two tables of combinations).

#include <string_view>

#include "dialect/melsec/codes.hpp"

namespace kerf::melsec {

/// A cell or more of a table: a code of `commanded` with one of `against` is refused.
struct Combination {
  CodeSet commanded = 0;
  CodeSet against = 0;
  std::string_view detail;  ///< details code; empty: nothing is refused
  /// Allowed when "Tolerable acceleration control for each axis ON" is set.
  bool allowed_with_axis_tolerance = false;
  CodeSet also = 0;  ///< refused only with one of these modal as well; 0: always
};

/// The first pair that must not stand in one block; `codes` are the ones of the block that count, the last
/// one of each group.
Combination refused_in_block(CodeSet codes);

/// The first code of the block that must not be commanded while one of `in_force` is modal. `in_force` has
/// the motion code that the block runs with, and otherwise the codes from before the block.
Combination refused_in_modal(CodeSet codes, CodeSet in_force, bool axis_tolerance);

}  // namespace kerf::melsec
