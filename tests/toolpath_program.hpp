#pragma once
// A small builder for the actions a toolpath pass gets, and a short text for what it gives.

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

#include "execute/action.hpp"
#include "geometry/circular_arc.hpp"
#include "geometry/vec2.hpp"
#include "toolpath/path_queue.hpp"

namespace kerf::toolpath_test {

/// Hands out a list of actions.
class ListSource {
 public:
  explicit ListSource(const std::vector<Action>& actions) : actions_(&actions) {}
  const Action* next() { return at_ < actions_->size() ? &(*actions_)[at_++] : nullptr; }

 private:
  const std::vector<Action>* actions_;
  std::size_t at_ = 0;
};

/// Builds actions as an interpreter would, one block a call, from X0 Y0 Z0 in the XY plane at 600 mm/min.
class Program {
 public:
  Program& left(double amount) { return side(Side::left, amount); }
  Program& right(double amount) { return side(Side::right, amount); }
  Program& none() { return side(Side::none, 0.0); }
  Program& side(Side side, double amount) {
    compensation_ = {side, amount};
    return *this;
  }

  Program& from(double x, double y) {
    position_[Axis::X] = x;
    position_[Axis::Y] = y;
    return *this;
  }
  Program& to(double x, double y) { return straight_to(MoveMode::linear, x, y); }
  Program& rapid(double x, double y) { return straight_to(MoveMode::rapid, x, y); }
  Program& to(double x, double y, double z) {
    target_z_ = z;
    return to(x, y);
  }
  Program& z(double z) {
    Move move = blank(MoveMode::linear);
    move.axis_words = false;
    move.end[Axis::Z] = z;
    target_z_ = z;
    return add_move(move);
  }

  /// Arcs by end and centre; the same end as the start makes a full circle.
  Program& cw(double x, double y, double cx, double cy) { return arc(x, y, cx, cy, true); }
  Program& ccw(double x, double y, double cx, double cy) { return arc(x, y, cx, cy, false); }

  Program& dwell() { return add(Dwell{1.0}); }
  Program& m(int code) { return add(Auxiliary{code}); }
  Program& corner_arc(double dx = 0.0, double dy = 0.0) { return add(CornerArc{{dx, dy}, 600.0}); }
  Program& end() { return add(End{}); }
  /// A block that gives no action.
  Program& empty_block() {
    ++block_;
    return *this;
  }
  /// The next action belongs to the block of the last one.
  Program& same_block() {
    --block_;
    return *this;
  }

  Program& add(const ActionVariant& what) {
    ++block_;
    Action action{{}, what};
    action.origin.block = block_;
    action.origin.span.line = block_;
    actions_.push_back(action);
    return *this;
  }

  const std::vector<Action>& actions() const { return actions_; }

 private:
  Move blank(MoveMode mode) const {
    Move move;
    move.mode = mode;
    move.compensation = compensation_;
    move.start = move.end = position_;
    move.feed = 600.0;
    return move;
  }
  Program& straight_to(MoveMode mode, double x, double y) {
    Move move = blank(mode);
    move.end = with_point(position_, kPlaneXY, {x, y});
    move.end[Axis::Z] = target_z_;
    return add_move(move);
  }
  Program& arc(double x, double y, double cx, double cy, bool clockwise) {
    Move move = blank(clockwise ? MoveMode::clockwise : MoveMode::counterclockwise);
    const Vec2 center{cx, cy};
    const Vec2 start = in_plane(position_, kPlaneXY);
    double turn = ahead_deg(start - center, Vec2{x, y} - center, clockwise);
    if (turn <= 0.0) turn += 360.0;
    move.end = with_point(position_, kPlaneXY, {x, y});
    move.arc = {{cx, cy}, distance(start, center), clockwise ? -turn : turn};
    return add_move(move);
  }
  Program& add_move(Move move) {
    move.commanded = position_ = move.end;
    return add(move);
  }

  std::vector<Action> actions_;
  AxisVector position_;
  double target_z_ = 0.0;
  RadiusCompensation compensation_;
  std::uint32_t block_ = 0;
};

/// A number with up to three decimals.
inline std::string number(double value) {
  std::string text = fmt::format("{:.3f}", std::abs(value) < 0.0005 ? 0.0 : value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// "10,2" a linear move, "rapid 10,2", "cw 10,2 c 8,2 r 2", each with " z -5" when Z changes; "dwell", "m 8",
/// "end", "alarm <detail>"; separated by " | ". Moves of the ZX plane print Z first.
inline std::string text_of(const std::vector<Action>& actions) {
  std::string text;
  for (const Action& action : actions) {
    if (!text.empty()) text += " | ";
    if (const Move* move = std::get_if<Move>(&action.what)) {
      const Vec2 end = in_plane(move->end, move->plane);
      if (move->mode == MoveMode::rapid) text += "rapid ";
      if (is_arc(move->mode)) text += move->mode == MoveMode::clockwise ? "cw " : "ccw ";
      text += number(end.x) + "," + number(end.y);
      if (is_arc(move->mode))
        text += " c " + number(move->arc.center[0]) + "," + number(move->arc.center[1]) + " r " +
                number(move->arc.radius);
      const Axis third = move->plane.third;
      if (move->start[third] != move->end[third]) text += " z " + number(move->end[third]);
    } else if (std::holds_alternative<Dwell>(action.what)) {
      text += "dwell";
    } else if (const Auxiliary* m = std::get_if<Auxiliary>(&action.what)) {
      text += fmt::format("m {}", m->code);
    } else if (std::holds_alternative<End>(action.what)) {
      text += "end";
    } else if (const Alarm* alarm = std::get_if<Alarm>(&action.what)) {
      text += fmt::format("alarm {}", alarm->kind->detail);
    } else {
      text += "?";
    }
  }
  return text;
}

/// What must hold for moves of any pass: each begins where the one before ended, and arcs go from their start
/// to their end in the direction of their mode.
inline void expect_well_formed(const std::vector<Action>& actions) {
  const Move* before = nullptr;
  for (const Action& action : actions) {
    const Move* move = std::get_if<Move>(&action.what);
    if (move == nullptr) continue;
    EXPECT_TRUE(before == nullptr || move->start == before->end) << "in " << text_of(actions);
    before = move;
    if (!is_arc(move->mode)) continue;
    const Vec2 center{move->arc.center[0], move->arc.center[1]};
    const Vec2 start = in_plane(move->start, move->plane);
    EXPECT_EQ(move->mode == MoveMode::clockwise, move->arc.sweep < 0.0);
    EXPECT_GT(move->arc.radius, 0.0);
    EXPECT_NEAR(distance(start, center), move->arc.radius, 2e-6);
    EXPECT_NEAR(distance(center + rotated(start - center, move->arc.sweep), in_plane(move->end, move->plane)),
                0.0, 4e-6);
  }
}

/// Everything a pass gives for a list of actions.
template <class Pass>
std::vector<Action> run_through(Pass& pass, const std::vector<Action>& actions) {
  ListSource source(actions);
  std::vector<Action> out;
  while (const Action* action = pass.next(source)) out.push_back(*action);
  expect_well_formed(out);
  return out;
}

}  // namespace kerf::toolpath_test
