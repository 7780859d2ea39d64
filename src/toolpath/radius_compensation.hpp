#pragma once
// The pass that moves the tool centre beside the programmed path: tool radius compensation (G40, G41, G42)
// with look-ahead over one block, and its corner arcs (G39). Source: DGSHAPE NC code reference 2-2, G39 to
// G42; corner.hpp has the geometry.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "execute/action.hpp"
#include "execute/toolpath_policy.hpp"
#include "toolpath/corner.hpp"
#include "toolpath/overcut_check.hpp"
#include "toolpath/path_queue.hpp"

namespace kerf {

/// Rewrites moves whose `compensation` commands a side, in the plane of the move that starts it; other axes
/// ride along unchanged.
///
/// - The first straight move with motion in the plane after a side is commanded starts the compensation; the
///   first move that names an axis of the plane after the side returns to none ends it. A negative amount
///   exchanges sides.
/// - A move of a new start (RadiusCompensation::start) starts the compensation again from the point at right
///   angles to the end of the last move.
/// - Actions between two compensated moves are given out in order, where the first move ends; behind its
/// joints
///   when these belong to it, in front of them when the policy gives them to the next move.
/// - The look-ahead ends when `blocks_without_motion` or more blocks lie between two moves (counted by
///   Origin::block, without the block of a corner arc), or more than 64 actions: the first move ends at the
///   point at right angles to its end, and the tool goes straight to the point at right angles to the start
///   of the next.
/// - A corner arc whose direction is given is made at once, behind the actions in front of it; one without
///   waits for the next move. At an inner corner it is left out, and the corner is joined as without it; so
///   it is in the block that starts the compensation.
/// - Moves put in at corners carry origin, mode, feed and commanded end of the move they belong to; those
///   after a failed look-ahead or a corner arc carry the ones of the move after them.
/// - End and the end of the actions finish the last move at the point at right angles to its end and take
///   the compensation back.
/// - An alarm drops the move it is about (and, when an arc is used up by its neighbours, the move after it;
///   where the policy stops before a fault and in an interference, also what stands behind it) and takes the
///   compensation back. The next move goes on from where the tool is; a straight one starts the compensation
///   again when it commands a side, arcs before it run as programmed.
/// - Without an interference check an inner corner may turn the direction of a short straight move round.
/// With
///   one, a move is held back until the corner behind the next is known, too.
/// - With sees_contour_ahead OvercutCheck reads ahead: a block may come with the corner by which it is to be
///   left, and with its alarm behind it.
/// - VectorRule gives the end of a move a point of its own; a suspended move goes to its programmed end, and
///   the one behind it from there to its own end point. Side and amount may change where the policy says so:
///   the corner before the move that changes them has the old amount.
///
/// Start and end of the moves given out chain exactly. Moves that shrink to nothing are left out. Nothing is
/// allocated. While not in force, actions are handed through without a copy.
class RadiusCompensationPass {
 public:
  explicit RadiusCompensationPass(const RadiusCompensationPolicy& policy);

  /// The next action, valid until the following call; nullptr at the end. `upstream.next()` gives the same,
  /// and nullptr again when it is asked after its end.
  template <class Upstream>
  const Action* next(Upstream& upstream) {
    for (;;) {
      if (const Action* ready = out_.pop()) return ready;
      const Action* action = overcuts_.is_on() ? overcuts_.next(upstream) : upstream.next();
      if (action == nullptr) {
        if (state_ == State::off) return nullptr;
        finish();
      } else if (is_idle() && passes_through(*action)) {
        return action;
      } else {
        push(*action);
      }
    }
  }

  /// Back to the state after construction.
  void reset();

 private:
  enum class State : std::uint8_t {
    off,
    starting,  ///< the straight starting move is held back
    running,   ///< a compensated move is held back
    settled,   ///< in force; the last move has been given out, up to the point at right angles to its end
  };

  /// The move before the one held back, while the interference check waits for the corner behind that one.
  struct Before {
    Corner corner;            ///< between it and the one held back
    Vec2 direction;           ///< in which that one begins
    std::size_t waiting = 0;  ///< actions that come between the two
    bool is_contour = false;  ///< not the starting move
  };

  /// A move that is held back, or was a short while ago.
  struct HeldMove {
    Action action;
    OffsetSegment segment;      ///< its offset begins where the tool enters it
    bool computed = false;      ///< it begins where its corner was computed for its own amount
    bool gentle = false;        ///< and that corner is gentle (Corner)
    std::optional<Corner> led;  ///< what OvercutCheck gives it as the corner behind it
  };

  /// A corner arc that really turns.
  struct CornerTurn {
    double sweep_deg = 0.0;
    Vec2 end;
  };

  bool is_idle() const { return state_ == State::off && !displaced_ && !after_alarm_; }
  bool tells_only(const Move& move) const;
  bool passes_through(const Action& action) const;
  void push(const Action& action);
  void push_while_off(const Action& action);
  void push_move(const Action& action, const Move& move);
  void push_corner_arc(const Action& action);
  void push_motionless(const Action& action);

  void start(const Action& action, const Move& move);
  void start_from_rest(const Action& action, const Move& move);
  void change_at_rest(const Origin& origin, const Move& move);
  void suspend(const Action& action, const Move& move);
  void advance(const Action& action, const Move& move);
  [[gnu::hot]] bool advance_gently(const Action& action, const Move& move);
  void end(const Action& action, const Move& move);
  void finish();
  void turn_off(bool displaced);

  void hold(const Action& action, const OffsetSegment& segment, Vec2 entry, bool computed);
  void leave_held(const Corner& corner, const Action& next, Vec2 next_direction);
  void leave_held_at(Vec2 end);
  void leave_held_for(const Corner& corner, const Action& next, Vec2 next_direction);
  void leave_before();
  void leave_before_and_stop();
  void add_corner(const Corner& corner, const Action& like);
  void note_inner_corner(const Move& move, const OffsetSegment& next);
  bool sees_together(const Origin& next) const;
  bool interferes(Corner& corner, const Action& action, const OffsetSegment& next);
  bool goes_around(Corner& corner, const OffsetSegment& next, bool keeps_clear_of_next);
  bool has_contour_before() const;
  bool before_keeps_clear(const OffsetSegment* next) const;
  bool held_keeps_clear(const Corner& corner) const;
  bool refuse_before();
  bool refuse(const Origin& refused);
  bool refuses_held(const Action& action) const;
  void leave_held_at_right_angles();
  void settle();
  PlanarSegment way_of(const OffsetSegment& segment, Vec2 end) const;
  void add_segment(const Action& action, const OffsetSegment& segment, Vec2 end);
  double feed_change(const OffsetSegment& segment, const Move& like) const;
  void release_waiting(Vec2 next_direction) { release_waiting(next_direction, out_.waiting()); }
  void release_waiting(Vec2 next_direction, std::size_t count);
  void drop_corner_arc();
  void make_corner_arc(Action& action, const CornerTurn& turn) const;

  Corner corner_to(const OffsetSegment& next) const;
  Corner corner_to_end(const Move& move) const;
  std::optional<CornerTurn> corner_turn(Vec2 direction) const;
  bool stands_beside_end() const;
  bool look_ahead_fails(const Origin& next) const;

  void raise(const AlarmKind* kind, const Origin& origin, const FixedText<200>& message);
  void raise_corner_fault(const Corner& corner, const Origin& next);

  /// The parallel of a move.
  OffsetSegment beside(const PlanarSegment& programmed, double left_mm) const {
    return policy_.small_arcs_turn_over ? offset_turned_over(programmed, left_mm)
                                        : offset_of(programmed, left_mm);
  }
  Vec2 facing() const;
  Vec2 vector_of(const RadiusCompensation& compensation, double left_mm) const;
  CornerRules rules() const {
    return {left_mm_, policy_.small_angle_deg, policy_.joint_gap_mm, policy_.rounds_acute};
  }
  HeldMove& held() { return moves_[held_at_]; }
  const HeldMove& held() const { return moves_[held_at_]; }
  const HeldMove& before_move() const { return moves_[(held_at_ + 2) % 3]; }
  const HeldMove& earlier() const { return moves_[(held_at_ + 1) % 3]; }
  const Move& held_move() const { return std::get<Move>(held().action.what); }
  Vec2 point() const { return in_plane(out_.position(), plane_); }

  RadiusCompensationPolicy policy_;
  State state_ = State::off;
  bool displaced_ = false;      ///< off, but the tool stands where out_ ends, not where the program has it
  bool after_alarm_ = false;    ///< off because of an alarm, with a side commanded
  bool from_rest_ = false;      ///< off; a side was commanded without motion
  bool unjoined_ = false;       ///< settled: the next move begins where the tool is, not beside its own start
  RadiusCompensation at_rest_;  ///< what was commanded without motion
  std::optional<Before> before_;
  bool has_earlier_ = false;  ///< with before_: there is a move of the contour in front of it
  Plane plane_;
  double left_mm_ = 0.0;
  std::array<HeldMove, 3> moves_;       ///< around: the one held back, the one before it, the one before that
  std::size_t held_at_ = 0;             ///< of the one held back; settled: of the last one given out
  Vec2 facing_;                         ///< settled: the tool stands at right angles to this direction
  bool has_corner_arc_ = false;         ///< one without a direction waits
  std::uint32_t corner_arc_block_ = 0;  ///< block of the last corner arc behind held(); 0: none
  PathQueue out_;
  OvercutCheck overcuts_;
};

}  // namespace kerf
