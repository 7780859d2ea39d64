#pragma once
// How numbers are read (manual 1-5 and 2-1): decimal point or not, calculator or conventional type, mm or
// inch.

#include "dialect/dgshape/settings.hpp"
#include "execute/number_result.hpp"
#include "syntax/block.hpp"

namespace kerf::dgshape {

/// Reads values under the machine's setting and the unit in force.
class NumberReader {
 public:
  NumberReader(const ControllerSettings& settings, bool inch);

  /// X Y Z I J K R, and Q (which only the setting All covers), in mm.
  NumberResult distance(const Word& word) const;
  /// A, in degrees.
  NumberResult angle(const Word& word) const;
  /// F, in mm/min.
  NumberResult feed(const Word& word) const;
  /// X of G04, in seconds. The setting lists addresses, so the X of a dwell follows the X of a coordinate
  /// (DGS-140).
  NumberResult dwell_seconds(const Word& word) const;
  /// P of G51: a factor; 0.001 units in conventional reading (DGS-397).
  NumberResult scale(const Word& word) const;
  /// Words whose reading is fixed: integers without a decimal point, Range 2.
  static NumberResult integer(const Word& word);

 private:
  bool calculator(char address) const;
  NumberResult length(const Word& word) const;

  CalculatorWords calculator_words_;
  double angle_unit_;
  bool inch_;
};

}  // namespace kerf::dgshape
