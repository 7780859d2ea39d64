#pragma once
// Moves in a polar plane of X and C, as the interpreter hands them out and as the pass behind it makes them.

#include <cmath>
#include <vector>

#include "geometry/circular_arc.hpp"
#include "toolpath/polar_pass.hpp"
#include "toolpath_program.hpp"

namespace kerf::polar_test {

/// Moves one after the other in the plane of X and C, numbered as blocks from 1; X and C in mm from the
/// centre of rotation. Feed 600 mm/min.
class PolarProgram {
 public:
  /// X stands at `x` mm from the centre (at `center`, machine coordinate), C at `zero` degrees.
  explicit PolarProgram(double x, double center = 0.0, double zero = 0.0) {
    polar_.form = PolarForm::plane;
    polar_.minus = x < 0.0;
    polar_.linear = Axis::X;
    polar_.rotary = Axis::C;
    polar_.center = center;
    polar_.zero = zero;
    position_[Axis::X] = center + x;
  }

  PolarProgram& feed(double mm_min) {
    feed_ = mm_min;
    return *this;
  }
  PolarProgram& to(double x, double c) { return add(MoveMode::linear, x, c); }
  PolarProgram& to(double x, double c, double z) {
    z_ = z;
    return to(x, c);
  }
  PolarProgram& rapid(double x, double c) { return add(MoveMode::rapid, x, c); }
  /// An arc around (x, c) by a sweep in degrees.
  PolarProgram& arc(double x, double c, double sweep) {
    const Vec2 center{x, c};
    const Vec2 arm = here() - center;
    const Vec2 end = center + length(arm) * direction_at(angle_of_deg(arm) + sweep);
    arc_ = {{polar_.center + x, c}, length(arm), sweep};
    return add(sweep < 0.0 ? MoveMode::clockwise : MoveMode::counterclockwise, end.x, end.y);
  }
  PolarProgram& action(const ActionVariant& what) {
    actions_.push_back({{}, what});
    actions_.back().origin.block = actions_.back().origin.span.line =
        static_cast<std::uint32_t>(actions_.size());
    return *this;
  }

  Vec2 here() const { return {position_[Axis::X] - polar_.center, position_[Axis::C]}; }
  const std::vector<Action>& actions() const { return actions_; }

 private:
  PolarProgram& add(MoveMode mode, double x, double c) {
    Move move;
    move.mode = mode;
    move.plane = {Axis::X, Axis::C, Axis::Z};
    move.polar = polar_;
    move.start = position_;
    position_[Axis::X] = polar_.center + x;
    position_[Axis::C] = c;
    position_[Axis::Z] = z_;
    move.end = move.commanded = position_;
    move.feed = feed_;
    move.arc = arc_;
    arc_ = {};
    return action(move);
  }

  PolarPlane polar_;
  AxisVector position_;
  double z_ = 0.0;
  double feed_ = 600.0;
  Arc arc_;
  std::vector<Action> actions_;
};

/// What the pass makes of actions.
inline std::vector<Action> passed(const std::vector<Action>& actions, bool endless = false) {
  PolarPolicy policy;
  policy.rotary = Axis::C;
  policy.endless = endless;
  PolarPass pass(policy);
  toolpath_test::ListSource source(actions);
  std::vector<Action> out;
  while (const Action* action = pass.next(source)) out.push_back(*action);
  return out;
}

}  // namespace kerf::polar_test
