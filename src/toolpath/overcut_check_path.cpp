// Whether the tool goes on beside a block, and where it goes instead.

#include <algorithm>
#include <cmath>

#include "geometry/segment_distance.hpp"
#include "toolpath/compensated_move.hpp"
#include "toolpath/interference.hpp"
#include "toolpath/overcut_check.hpp"

namespace kerf {
namespace {

constexpr double kSharp = 90.0 - 1e-9;  // degrees; sharper outer corners may be round

/// The paths beside two straight blocks lie on one line.
bool goes_on(const OffsetSegment& first, const OffsetSegment& next) {
  const Vec2 gap = next.offset.start - first.offset.end;
  return dot(first.ends, next.begins) > 0.0 && std::abs(cross(first.ends, gap)) <= kBack &&
         std::abs(cross(first.ends, next.offset.end - first.offset.end)) <= kBack;
}

/// Two points lie on one side of the line on which the path beside a straight block lies.
bool on_one_side(const OffsetSegment& segment, Vec2 a, Vec2 b) {
  const double left_a = cross(segment.begins, a - segment.offset.start);
  const double left_b = cross(segment.begins, b - segment.offset.start);
  return (left_a < 0.0) == (left_b < 0.0);
}

}  // namespace

CornerRules OvercutCheck::rules(double left_mm) const {
  return {left_mm, policy_.small_angle_deg, policy_.joint_gap_mm, policy_.rounds_acute};
}

// The place of the contour's next block in the queue; the queue's size when none is seen.
std::size_t OvercutCheck::next_of_contour(std::size_t place) const {
  const std::size_t farthest = queue_.front().block.number + policy_.interference_blocks;
  for (++place; place < queue_.size(); ++place) {
    const Entry& entry = queue_[place];
    if (entry.kind == Kind::end || entry.kind == Kind::start) break;
    if (entry.kind == Kind::contour) return entry.block.number <= farthest ? place : queue_.size();
  }
  return queue_.size();
}

// The contour's block before one that is not the first.
std::size_t OvercutCheck::last_of_contour(std::size_t place) const {
  do --place;
  while (queue_[place].kind != Kind::contour);
  return place;
}

// The first action queued is a block of the contour.
void OvercutCheck::check(Entry& entry) {
  const SeenBlock& block = entry.block;
  const double left_mm = block.segment.left_mm;
  while (!behind_.empty() && behind_.front().number + policy_.interference_blocks < block.number)
    behind_.pop();
  if (starts_)
    entry_ = start_corner(start_direction_, block.segment, policy_.start_type, rules(left_mm),
                          policy_.type_b_beside)
                 .points.back();
  if (!entry_) entry_ = block.segment.offset.start;
  starts_ = false;
  const std::size_t next = next_of_contour(0);
  if (next == queue_.size()) {
    refused_ = !ends_well(block);
    entry_.reset();
  } else {
    OffsetSegment entered = block.segment;
    begin_at(entered.offset, *entry_);
    const Corner corner = crossover_corner(entered, queue_[next].block.segment, rules(left_mm));
    const bool avoids = policy_.interference == InterferenceCheck::avoid;
    if (corner.fault == CornerFault::none && keeps_out(block, corner) && reaches(next, corner) &&
        !(avoids && passes_corner(block, corner.points[0]))) {
      entry_ = corner.points.back();
    } else if (const auto passage = avoids ? passage_behind(block) : std::nullopt) {
      lead_to(entry, *passage);
    } else {
      // An impossible corner has an alarm of its own.
      refused_ = corner.fault == CornerFault::none;
      entry_.reset();
    }
  }
  if (refused_)
    alarm_ = {entry.action.origin, Alarm{policy_.interference_alarm, entry.action.origin.span, {}, {}}};
}

// The tool goes forward to the corner, and keeps out of the contour on its way to it and around it.
bool OvercutCheck::keeps_out(const SeenBlock& block, const Corner& corner) const {
  const Vec2 end = corner.points[0];
  if (advance_along(block.segment, *entry_, end) < -kBack) return false;
  if (!keeps_out(way_beside(block, *entry_, end))) return false;
  for (std::size_t i = 1; i < corner.points.size(); ++i)
    if (!keeps_out(way_behind(block, way_between(corner, i, block.segment.left_mm)))) return false;
  return true;
}

// A straight block behind the corner is longer than what the corner takes of it.
bool OvercutCheck::reaches(std::size_t next, const Corner& corner) const {
  const OffsetSegment& segment = queue_[next].block.segment;
  return segment.offset.is_arc || is_on_path(queue_[next].block, corner.points.back(), extensions_of(next));
}

// On its way the tool crosses what an outer corner ahead adds to a path. It cuts into nothing there, but from
// where it would be stopped behind it there is no way to that path.
bool OvercutCheck::passes_corner(const SeenBlock& block, Vec2 end) const {
  const double whole = advance_along(block.segment, *entry_, end);
  for (std::size_t i = next_of_contour(0); i < queue_.size(); i = next_of_contour(i)) {
    const SeenBlock& ahead = queue_[i].block;
    const double near = block.reach_mm + ahead.reach_mm + 3.0 * std::abs(ahead.segment.left_mm);
    const Vec2 apart = block.middle - ahead.middle;
    if (ahead.segment.offset.is_arc || dot(apart, apart) > near * near) continue;
    if (!block.segment.offset.is_arc && on_one_side(ahead.segment, *entry_, end)) continue;
    const Extensions added = extensions_of(i);
    if (added.before_mm <= 0.0 && added.behind_mm <= 0.0) continue;
    for (const Vec2 point : meeting_of_curves(block.segment.offset, ahead.segment.offset).points) {
      const double advance = advance_along(block.segment, *entry_, point);
      const bool on_way = advance > kBack && advance < whole - kBack;
      if (on_way && !is_on_path(ahead, point, {}) && is_on_path(ahead, point, added) &&
          takes_over(block, ahead, point))
        return true;
    }
  }
  return false;
}

bool OvercutCheck::keeps_out(const SeenWay& way) const {
  for (std::size_t i = next_of_contour(0); i < queue_.size(); i = next_of_contour(i))
    if (cuts_into(way, queue_[i].block, Place::ahead)) return false;
  for (std::size_t i = 0; i < behind_.size(); ++i)
    if (cuts_into(way, behind_[i], Place::behind)) return false;
  return true;
}

// The last block that is seen ends beside its own end.
bool OvercutCheck::ends_well(const SeenBlock& block) const {
  const Vec2 end = block.segment.offset.end;
  if (advance_along(block.segment, *entry_, end) < -kBack) return false;
  return keeps_out(way_beside(block, *entry_, end));
}

// The way on from the first block queued that gets farthest along it.
std::optional<OvercutCheck::Passage> OvercutCheck::passage_behind(const SeenBlock& block) const {
  const Leaving leaving{block, *entry_, 0, extensions_of(0)};
  auto direct = passage_from(leaving);
  auto around = passage_around_corners(leaving);
  const bool sooner = around && (!direct || around->advance_mm < direct->advance_mm - kBack);
  if (!sooner && !direct) return bridge_from(leaving);
  return sooner ? around : direct;
}

// The farthest point of its path to which the tool can go, and from there on beside another block.
std::optional<OvercutCheck::Passage> OvercutCheck::passage_from(const Leaving& leaving) const {
  std::optional<Passage> best;
  const OffsetSegment& own = leaving.block.segment;
  const PlanarSegment& path = own.offset;
  for (std::size_t to = next_of_contour(leaving.place); to < queue_.size(); to = next_of_contour(to)) {
    const OffsetSegment& other = queue_[to].block.segment;
    for (const Vec2 point : meeting_of_curves(path, other.offset).points)
      try_passage(leaving, to, point, best);
  }
  return best;
}

// Straight on to a block whose path lies on the same line: across what the tool is too large for.
std::optional<OvercutCheck::Passage> OvercutCheck::bridge_from(const Leaving& leaving) const {
  std::optional<Passage> best;
  const OffsetSegment& own = leaving.block.segment;
  for (std::size_t to = next_of_contour(leaving.place); to < queue_.size(); to = next_of_contour(to)) {
    const OffsetSegment& other = queue_[to].block.segment;
    if (own.offset.is_arc || other.offset.is_arc || !goes_on(own, other)) continue;
    for (const Vec2 point : {own.offset.end, other.offset.start}) try_bridge(leaving, to, point, best);
  }
  return best;
}

void OvercutCheck::try_passage(const Leaving& leaving, std::size_t to, Vec2 point,
                               std::optional<Passage>& best) const {
  const SeenBlock& ahead = queue_[to].block;
  if (!is_on_path(ahead, point, extensions_of(to)) || !takes_over(leaving.block, ahead, point)) return;
  if (!is_way_on(leaving, point, best)) return;
  best = Passage{to, corner_at(point), advance_along(leaving.block.segment, leaving.entry, point)};
}

void OvercutCheck::try_bridge(const Leaving& leaving, std::size_t to, Vec2 point,
                              std::optional<Passage>& best) const {
  const double wide = 2.0 * std::abs(leaving.block.segment.left_mm);
  const Leaving prolonged{leaving.block, leaving.entry, leaving.place, {wide, wide}};
  const Extensions own = extensions_of(to);
  if (!is_on_path(queue_[to].block, point, {wide, own.behind_mm}) || !is_way_on(prolonged, point, best))
    return;
  best = Passage{to, corner_at(point), advance_along(leaving.block.segment, leaving.entry, point)};
}

// The tool can go on to a point, farther than by the best passage so far.
bool OvercutCheck::is_way_on(const Leaving& leaving, Vec2 point, const std::optional<Passage>& best) const {
  const double advance = advance_along(leaving.block.segment, leaving.entry, point);
  if (advance < -kBack || (best && advance >= best->advance_mm - kBack)) return false;
  return is_on_path(leaving.block, point, leaving.extensions) &&
         keeps_out(way_beside(leaving.block, leaving.entry, point));
}

// The same, but from there on around a round corner: its own, or one between blocks ahead.
std::optional<OvercutCheck::Passage> OvercutCheck::passage_around_corners(const Leaving& leaving) const {
  const PlanarSegment& path = leaving.block.segment.offset;
  std::optional<Passage> best;
  for (std::size_t before = leaving.place; before < queue_.size(); before = next_of_contour(before)) {
    const std::optional<Corner> corner = round_corner_behind(before);
    if (!corner) continue;
    const SeenBlock around = seen_corner(queue_[before].block, *corner);
    const auto try_point = [&](Vec2 point) {
      if (!is_on_path(around, point, {}) || !takes_over(leaving.block, around, point)) return;
      if (!is_way_on(leaving, point, best)) return;
      if (auto passage = passage_around(leaving, point, before)) best = passage;
    };
    if (before == leaving.place)
      try_point(path.end);
    else
      for (const Vec2 point : meeting_of_curves(path, around.segment.offset).points) try_point(point);
  }
  return best;
}

// From a point of the round corner behind a block around it, to the next block or off to one farther ahead.
std::optional<OvercutCheck::Passage> OvercutCheck::passage_around(const Leaving& leaving, Vec2 point,
                                                                  std::size_t before) const {
  const Corner corner = *round_corner_behind(before);
  const SeenBlock around = seen_corner(queue_[before].block, corner);
  Passage passage{next_of_contour(before), corner, 0.0};
  passage.corner.points[0] = point;
  passage.advance_mm = advance_along(leaving.block.segment, leaving.entry, point);
  if (!keeps_out(way_beside(around, point, corner.points[1]))) {
    const auto off = passage_from({around, point, before, {}});
    if (!off) return std::nullopt;
    passage.to = off->to;
    passage.corner.points[1] = off->corner.points[0];
  }
  if (distance(point, passage.corner.points[1]) < kSamePoint) passage.corner = corner_at(point);
  return passage;
}

std::optional<Corner> OvercutCheck::round_corner_behind(std::size_t place) const {
  const std::size_t next = next_of_contour(place);
  if (next == queue_.size()) return std::nullopt;
  const OffsetSegment& own = queue_[place].block.segment;
  Corner corner = crossover_corner(own, queue_[next].block.segment, rules(own.left_mm));
  if (corner.fault != CornerFault::none || !corner.round) return std::nullopt;
  return corner;
}

// A block's path goes on to where an outer corner turns, unless that is round.
Extensions OvercutCheck::extensions_of(std::size_t place) const {
  const OffsetSegment& own = queue_[place].block.segment;
  const auto prolonged = [&](const OffsetSegment& first, const OffsetSegment& next) {
    const double angle = workpiece_angle_deg(first.ends, next.begins, own.left_mm);
    if (is_inner(angle) || (policy_.rounds_acute && angle < kSharp)) return 0.0;
    return std::abs(own.left_mm) * std::tan(radians(0.5 * std::min(180.0 - angle, 90.0)));
  };
  Extensions extensions;
  // Where the tool enters the first block it stands already.
  extensions.before_mm = place == 0 ? HUGE_VAL : prolonged(queue_[last_of_contour(place)].block.segment, own);
  const std::size_t next = next_of_contour(place);
  if (next < queue_.size()) extensions.behind_mm = prolonged(own, queue_[next].block.segment);
  return extensions;
}

void OvercutCheck::lead_to(Entry& entry, const Passage& passage) {
  led_ = passage.corner;
  led_->fixed = true;
  for (std::size_t i = 1; i < passage.to; ++i)
    if (queue_[i].kind == Kind::contour) queue_[i].kind = Kind::skipped;
  passed_ = std::get<Move>(entry.action.what).end;
  entry_ = passage.corner.points.back();
}

}  // namespace kerf
