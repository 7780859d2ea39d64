// The moves held back, and the path that is made of them.

#include <cmath>

#include "toolpath/compensated_move.hpp"
#include "toolpath/interference.hpp"
#include "toolpath/radius_compensation.hpp"

namespace kerf {
namespace {

constexpr double kWholeTurn = 360.0 + 1e-9;  // degrees; a circle of exactly one turn is what the program says

bool is_full_circle(const PlanarSegment& segment) {
  return segment.is_arc && distance(segment.start, segment.end) <= kNoLength && segment.sweep_deg != 0.0;
}

}  // namespace

// The segment begins where the corner before it ends.
void RadiusCompensationPass::hold(const Action& action, const OffsetSegment& segment, Vec2 entry,
                                  bool computed) {
  held().action = action;
  held().computed = computed;
  held().gentle = false;
  held().led = overcuts_.led();
  held().segment = segment;
  begin_at(held().segment.offset, entry);
  has_corner_arc_ = unjoined_ = false;
  corner_arc_block_ = 0;
  state_ = State::running;
}

// The move held back, what waits behind it, and the way around the corner.
void RadiusCompensationPass::leave_held(const Corner& corner, const Action& next, Vec2 next_direction) {
  leave_held_at(corner.points[0]);
  if (policy_.joints_belong_to_next) release_waiting(next_direction);
  add_corner(corner, policy_.joints_belong_to_next ? next : held().action);
  if (!policy_.joints_belong_to_next) release_waiting(next_direction);
}

void RadiusCompensationPass::leave_held_at(Vec2 end) {
  add_segment(held().action, held().segment, end);
  facing_ = facing();
  state_ = State::settled;
}

// The corner is known; with an interference check the one behind it may still change it.
void RadiusCompensationPass::leave_held_for(const Corner& corner, const Action& next, Vec2 next_direction) {
  leave_before();
  if (policy_.interference == InterferenceCheck::none || has_corner_arc_)
    return leave_held(corner, next, next_direction);
  before_ = Before{corner, next_direction, out_.waiting(), state_ == State::running};
  held_at_ = (held_at_ + 1) % moves_.size();
}

void RadiusCompensationPass::leave_before() {
  has_earlier_ = before_ && before_->is_contour;
  if (!before_) return;
  add_segment(before_move().action, before_move().segment, before_->corner.points[0]);
  if (policy_.joints_belong_to_next) release_waiting(before_->direction, before_->waiting);
  add_corner(before_->corner, policy_.joints_belong_to_next ? held().action : before_move().action);
  if (!policy_.joints_belong_to_next) release_waiting(before_->direction, before_->waiting);
  before_.reset();
}

// The tool stops in front of the move held back, which is not made, nor anything behind it.
void RadiusCompensationPass::leave_before_and_stop() {
  if (before_ && policy_.joints_belong_to_next) before_->corner = corner_at(before_->corner.points[0]);
  leave_before();
  out_.drop_waiting();
  state_ = State::settled;
}

void RadiusCompensationPass::add_corner(const Corner& corner, const Action& like) {
  const Move& move = std::get<Move>(like.what);
  for (std::size_t i = 1; i < corner.points.size(); ++i) {
    const AxisVector to = with_point(out_.position(), plane_, corner.points[i]);
    const PlanarSegment way = way_between(corner, i, left_mm_);
    if (way.is_arc)
      out_.add_arc_joint(like.origin, move, to, {{way.center.x, way.center.y}, way.radius, way.sweep_deg});
    else
      out_.add_joint(like.origin, move, to);
  }
}

bool RadiusCompensationPass::sees_together(const Origin& next) const {
  return before_ && policy_.interference != InterferenceCheck::none &&
         next.block <= before_move().action.origin.block + policy_.interference_blocks;
}

// The way that most blocks of a contour take: one straight block behind another, gently, and nothing in
// between. False: it is no such block, or the corner needs more than a look. Gives what advance() gives.
bool RadiusCompensationPass::advance_gently(const Action& action, const Move& move) {
  const Origin& origin = action.origin;
  const RadiusCompensation& beside = move.compensation;
  if (overcuts_.led() || held().led) return false;
  if (!before_ || !held().gentle || !before_->corner.gentle || !before_move().gentle) return false;
  if (before_->waiting + out_.waiting() > 0 || origin.block != held().action.origin.block + 1) return false;
  if (is_arc(move.mode) || beside.rule != VectorRule::computed || left_offset(beside) != left_mm_)
    return false;
  if (held_move().compensation.rule != VectorRule::computed || !sees_together(origin)) return false;
  if (held_move().path_mode == PathMode::corner_override) return false;  // wants the angle

  const HeldMove& first = held();
  const OffsetSegment next = offset_of(segment_of(move, plane_), left_mm_);
  const Vec2 gap = next.offset.start - first.segment.offset.end;
  if (!is_gentle(dot(first.segment.ends, next.begins)) || dot(gap, gap) < kSamePoint * kSamePoint)
    return false;
  const Vec2 point = turning_point(first.segment.programmed.end, first.segment.ends, next.begins, left_mm_);
  if (dot(point - before_->corner.points[0], first.segment.begins) < -kBack) return false;

  has_earlier_ = true;
  add_segment(before_move().action, before_move().segment, before_->corner.points[0]);
  before_->corner.points[0] = point;
  before_->direction = next.begins;
  before_->is_contour = true;
  held_at_ = (held_at_ + 1) % moves_.size();
  HeldMove& last = held();
  last.action.origin = origin;
  last.action.what = move;
  last.segment = next;
  last.segment.offset.start = point;
  last.computed = last.gentle = true;
  last.led.reset();
  unjoined_ = false;
  corner_arc_block_ = 0;
  return true;
}

// Looks at the move held back between the corner before it and `corner`, which the next move makes. True: an
// alarm was raised.
bool RadiusCompensationPass::interferes(Corner& corner, const Action& action, const OffsetSegment& next) {
  if (!sees_together(action.origin)) return false;
  const RadiusCompensation& on = std::get<Move>(action.what).compensation;
  const bool is_contour = on.side != Side::none && !on.suspended && next.left_mm == held().segment.left_mm;
  Neighbours neighbours;
  if (!before_->corner.fixed && !corner.fixed) {
    neighbours.before = has_contour_before() ? &before_move().segment : nullptr;
    neighbours.behind = is_contour ? &next : nullptr;
  }
  const Interference found = remove_interference(before_->corner, held().segment, corner, neighbours);
  for (Corner* one : {&before_->corner, &corner}) one->round = one->round && one->points.size() == 2;
  if (found == Interference::partly)
    held().segment.offset = straight(before_->corner.points.back(), corner.points[0]);
  if (found == Interference::wholly && !goes_around(corner, next, is_contour)) return refuse_before();
  held().gentle = held().gentle && before_->corner.gentle;
  return before_keeps_clear(is_contour ? &next : nullptr) ? false : refuse_before();
}

// Where the move held back has lost all its points, the paths of its neighbours may meet.
bool RadiusCompensationPass::goes_around(Corner& corner, const OffsetSegment& next,
                                         bool keeps_clear_of_next) {
  if (policy_.interference != InterferenceCheck::avoid) return false;
  const auto around = avoiding_point(before_move().segment, before_move().segment.offset.start, next);
  if (!around) return false;
  if (keeps_clear_of_next && !keeps_clear(next, way_of(before_move().segment, *around))) return false;
  before_->corner = corner = corner_at(*around);
  held().segment.offset = straight(*around, *around);
  return true;
}

// The starting move is not part of the contour, and behind a change of the amount the tool keeps another
// distance.
bool RadiusCompensationPass::has_contour_before() const {
  return before_->is_contour && before_move().segment.left_mm == held().segment.left_mm;
}

// The path up to the move held back, against the blocks seen together with each part of it. `next` is the
// contour's block behind the move held back, when there is one. Where the program itself says what to cut, by
// vectors or another amount, that is left as it is.
bool RadiusCompensationPass::before_keeps_clear(const OffsetSegment* next) const {
  const OffsetSegment& own = before_move().segment;
  const Corner& corner = before_->corner;
  if (corner.fixed || (corner.gentle && before_move().gentle)) return true;
  const bool has_before = has_contour_before();
  if (before_->is_contour && before_move().computed) {
    const PlanarSegment way = way_of(own, corner.points[0]);
    if (!keeps_clear(own, way)) return false;
    // What lies where a full circle begins and ends leads into it and out of it.
    if (is_full_circle(own.programmed)) return true;
    // Where the contour begins the rules of the start say where the tool stands.
    const bool stands_in_it = !has_earlier_ && !keeps_clear(held().segment, straight(way.start, way.start));
    const bool leads_into_it = is_full_circle(held().segment.programmed);
    if (has_before && !stands_in_it && !leads_into_it && !keeps_clear(held().segment, way)) return false;
    if (has_earlier_ && earlier().segment.left_mm == own.left_mm && !keeps_clear(earlier().segment, way))
      return false;
  }
  for (std::size_t i = 1; i < corner.points.size(); ++i) {
    const PlanarSegment way = way_between(corner, i, own.left_mm);
    if (has_before && !keeps_clear(own, way)) return false;
    if (!held().computed) continue;
    if (!keeps_clear(held().segment, way) || (next != nullptr && !keeps_clear(*next, way))) return false;
  }
  return true;
}

// The same for the last move of the contour, which ends at `corner`, where the rules of the end say.
bool RadiusCompensationPass::held_keeps_clear(const Corner& corner) const {
  if (corner.fixed || !held().computed) return true;
  const PlanarSegment way = way_of(held().segment, corner.points[0]);
  if (!keeps_clear(held().segment, way)) return false;
  if (is_full_circle(held().segment.programmed)) return true;
  if (is_full_circle(before_move().segment.programmed)) return true;
  const bool stands_in_it = !keeps_clear(before_move().segment, straight(way.end, way.end));
  return stands_in_it || !has_contour_before() || keeps_clear(before_move().segment, way);
}

bool RadiusCompensationPass::refuse_before() {
  const Origin refused = before_move().action.origin;
  before_.reset();
  out_.drop_waiting();
  return refuse(refused);
}

// An alarm takes the place of a move that would cut into others. True.
bool RadiusCompensationPass::refuse(const Origin& refused) {
  state_ = State::settled;
  raise(policy_.interference_alarm, refused,
        FixedText<200>::format("The tool would cut into the path of the blocks behind at {}{:.3f} {}{:.3f}",
                               letter(plane_.first), held().segment.programmed.start.x, letter(plane_.second),
                               held().segment.programmed.start.y));
  return true;
}

void RadiusCompensationPass::leave_held_at_right_angles() {
  const bool own = held().led || held_move().compensation.rule != VectorRule::computed;
  leave_held_at(own ? corner_to({}).points[0] : held().segment.offset.end);
}

// The look-ahead ends here: nothing is held back any longer.
void RadiusCompensationPass::settle() {
  if (state_ == State::settled || state_ == State::off) return;
  leave_before();
  if (state_ == State::starting && policy_.start_waits) {
    add_segment(held().action, held().segment, held().segment.programmed.end);
    release_waiting({});
    turn_off(false);
    return;
  }
  leave_held_at_right_angles();
  release_waiting({});
  unjoined_ = policy_.resumes_unjoined;
}

// The actions that wait, in order, up to a corner arc whose direction is not known yet.
void RadiusCompensationPass::release_waiting(Vec2 next_direction, std::size_t count) {
  for (; count > 0; --count) {
    Action* action = out_.first_waiting();
    if (action == nullptr) break;
    Vec2 to = point();
    if (const CornerArc* arc = std::get_if<CornerArc>(&action->what)) {
      Vec2 direction = unit(Vec2{arc->direction[0], arc->direction[1]});
      if (direction == Vec2{}) direction = next_direction;
      if (direction == Vec2{}) return;
      const std::optional<CornerTurn> turn = corner_turn(direction);
      if (turn && state_ == State::settled) {
        make_corner_arc(*action, *turn);
        to = turn->end;
        facing_ = direction;
      }
    }
    out_.release_first(plane_, to);
  }
  if (out_.waiting() == 0) has_corner_arc_ = false;
}

// A corner arc still waits for a move that does not come: it is left out.
void RadiusCompensationPass::drop_corner_arc() {
  while (out_.first_waiting() != nullptr) out_.release_first(plane_, point());
  has_corner_arc_ = false;
}

// What is left of the path beside a segment when it ends at `end`: a straight way when an arc has no length.
PlanarSegment RadiusCompensationPass::way_of(const OffsetSegment& segment, Vec2 end) const {
  if (!segment.offset.is_arc) return straight(segment.offset.start, end);
  PlanarSegment way = segment.offset;
  double left_deg = end_at(way, end);
  if (policy_.drops_whole_turns && left_deg >= kWholeTurn) {
    left_deg -= 360.0;
    way.sweep_deg = std::copysign(left_deg, way.sweep_deg);
  }
  way.radius = distance(way.center, way.start);
  return left_deg <= 0.0 || length_of(way) <= kNoLength ? straight(way.start, end) : way;
}

// How much faster the tool's centre is to go on an arc: with the edge at the feed it takes as long as the
// programmed arc; where the feed counts along the path in space, the rise of a helix takes another share of
// it.
double RadiusCompensationPass::feed_change(const OffsetSegment& segment, const Move& like) const {
  const double inner = segment.programmed.radius;
  const double outer = segment.offset.radius;
  if (!policy_.feed_at_edge) return 1.0;
  const double sweep = radians(std::abs(segment.programmed.sweep_deg));
  const double rise = like.end[plane_.third] - like.start[plane_.third];
  const double rises = like.feed_in_space && sweep > 0.0 ? rise / sweep : 0.0;
  return std::hypot(outer, rises) / std::hypot(inner, rises);
}

void RadiusCompensationPass::add_segment(const Action& action, const OffsetSegment& segment, Vec2 end) {
  const Move& like = std::get<Move>(action.what);
  const AxisVector to = with_point(like.end, plane_, end);
  if (!segment.offset.is_arc && !is_arc(like.mode)) {
    if (!goes_nowhere(plane_, out_.position(), to)) out_.add_move(action.origin, like, to);
    return;
  }
  const PlanarSegment way = way_of(segment, end);
  if (!way.is_arc && goes_nowhere(plane_, out_.position(), to)) return;
  Move& move = out_.add_move(action.origin, like, to);
  if (way.is_arc && segment.programmed.radius > 0.0) move.feed *= feed_change(segment, like);
  if (way.is_arc)
    move.arc = {{way.center.x, way.center.y}, way.radius, way.sweep_deg};
  else if (is_arc(move.mode))
    move.mode = MoveMode::linear;
}

// The tool stands at right angles to the end of the held move, or where the last corner arc left it.
void RadiusCompensationPass::make_corner_arc(Action& action, const CornerTurn& turn) const {
  Move move = held_move();
  const Vec2 corner = held().segment.programmed.end;
  move.mode = turn.sweep_deg < 0.0 ? MoveMode::clockwise : MoveMode::counterclockwise;
  move.rotary_feed = {};
  move.feed = std::get<CornerArc>(action.what).feed;
  move.arc = {{corner.x, corner.y}, std::abs(left_mm_), turn.sweep_deg};
  move.end = out_.position();
  action.what = move;
}

}  // namespace kerf
