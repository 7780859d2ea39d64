#pragma once
// Declarations of machine-file keys. One declaration feeds the TOML reader, the validation, `kerf machine
// init` and `show`, `--set`, and the documentation.

#include <cstdint>
#include <limits>
#include <string_view>

namespace kerf {

enum class ValueType : std::uint8_t {
  boolean,
  integer,
  number,
  word,  ///< one of `choices`
  text,
  number_pair,  ///< [low, high]
};

/// One key of the machine file.
struct Parameter {
  /// Full dotted key, at most one `*` in it: a tool number in `tools.*.radius`, an axis letter anywhere else
  /// (axes.*.rapid, offsets.G54.*, melsec.axis.*.g1_time_constant).
  std::string_view key = {};
  ValueType type = ValueType::number;
  /// As TOML text: `100.0`, `"none"`, `true`, `[-9999.9999, 9999.9999]`.
  std::string_view default_value = {};
  /// "mm", "mm/min", "percent", ...; empty: none. For an axis `*`, mm also stands for the degree of a rotary
  /// axis.
  std::string_view unit = {};
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  /// Words separated by `|`, for ValueType::word: `alarm|invalid`, or with the numbers by which the
  /// controller's manual knows them, `0=alarm|1=invalid`; then the number may be written for the word.
  std::string_view choices = {};
  /// One sentence, shown as the comment in `kerf machine init`.
  std::string_view help = {};
  /// The minimum itself is refused: "above 0".
  bool above_minimum = false;
  /// The heading of the controller's manual it stands under, shown above it; empty: none.
  std::string_view group = {};
};

/// A dialect's other default for a key that every dialect shares. The axes and tools named by these keys are
/// the ones that the dialect's default machine has.
struct DefaultOverride {
  /// `axes.A.rapid`, or `axes.*.rapid` for every axis that has no override of its own.
  std::string_view key;
  /// As TOML text.
  std::string_view value;
};

}  // namespace kerf
