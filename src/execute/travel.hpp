#pragma once
// The range of travel of the machine's axes.

#include <array>
#include <optional>

#include "base/fixed_text.hpp"
#include "execute/action.hpp"
#include "machine/machine.hpp"

namespace kerf {

/// An axis that would leave its travel.
struct Excess {
  Axis axis = Axis::X;
  double reached = 0.0;  ///< machine coordinate, mm or degrees
};

class Travel {
 public:
  explicit Travel(const Machine& machine);

  /// Machine coordinates within the limits of every axis, up to 0.000001 mm or degrees.
  bool contains(const AxisVector& position) const {
    bool inside = true;
    for (std::size_t i = 0; i < axes_; ++i) {
      inside &= position.values[i] >= lowest_[i] && position.values[i] <= highest_[i];
    }
    return inside;
  }
  bool contains(Axis axis, double position) const {
    return position >= lowest_[index(axis)] && position <= highest_[index(axis)];
  }
  /// The end of a move and, on an arc and in a polar plane, its outermost points; the start is not looked at.
  bool contains(const Move& move) const {
    const bool direct = !is_arc(move.mode) && move.polar.form == PolarForm::none;
    return contains(move.end) && (direct || contains_between(move));
  }

  /// The first axis that a move or a position takes out of its travel.
  std::optional<Excess> excess_of(const Move& move) const;
  std::optional<Excess> excess_of(const AxisVector& position) const;
  /// The first axis that a move takes out of its travel and that was inside before.
  std::optional<Excess> leaving(const Move& move) const;
  /// "X would reach 600.0000 mm; travel is 0 to 500 mm"
  FixedText<200> message_for(const Excess& excess) const;

  double lower(std::size_t i) const { return lower_[i]; }
  double upper(std::size_t i) const { return upper_[i]; }

  static constexpr double kRounding = 1e-6;  ///< mm or degrees

 private:
  bool contains_between(const Move& move) const;

  std::array<double, kAxisCount> lower_;  // minus infinity for axes the machine lacks
  std::array<double, kAxisCount> upper_;
  std::array<double, kAxisCount> lowest_;  // the same with the rounding allowed
  std::array<double, kAxisCount> highest_;
  std::size_t axes_ = 0;  // the machine has none behind this one
  std::array<AxisType, kAxisCount> type_{};
};

}  // namespace kerf
