#pragma once
// Random closed contours whose blocks keep away from each other, except from their neighbours: what the tool
// cuts beside one block can then only be that block or a neighbour.

#include "toolpath_contours.hpp"

namespace kerf::toolpath_test {

inline double turn_between(const Block& first, const Block& next) {
  const Vec2 in = direction_of(first, 1.0);
  const Vec2 out = direction_of(next, 0.0);
  return degrees(std::atan2(cross(in, out), dot(in, out)));
}

/// Whether two blocks have no more than their joint in common: seen from there, a block lies between its
/// tangent and its chord.
inline bool meet_only_at_joint(const Block& first, const Block& next) {
  const auto turn = [](Vec2 from, Vec2 to) { return degrees(std::atan2(cross(from, to), dot(from, to))); };
  const Vec2 back = -direction_of(first, 1.0);
  const double first_spread = turn(back, first.start - first.end);
  const double next_spread = turn(direction_of(next, 0.0), next.end - next.start);
  const double between_tangents = turn(back, direction_of(next, 0.0));
  for (const double apart : {between_tangents - 360.0, between_tangents, between_tangents + 360.0}) {
    const double low = apart + std::min(next_spread, 0.0);
    const double high = apart + std::max(next_spread, 0.0);
    if (low <= std::max(first_spread, 0.0) && high >= std::min(first_spread, 0.0)) return false;
  }
  return true;
}

/// 4 to 12 corners at all distances around the origin, joined by lines and arcs, counterclockwise.
inline Contour random_ring(std::mt19937& random) {
  const int count = static_cast<int>(between(random, 4, 13));
  std::vector<Vec2> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = 360.0 * (i + between(random, 0.05, 0.95)) / count;
    corners.push_back(between(random, 30, 100) * direction_at(angle));
  }
  Contour ring;
  for (int i = 0; i < count; ++i) {
    const Vec2 start = corners[static_cast<std::size_t>(i)];
    const Vec2 end = corners[static_cast<std::size_t>((i + 1) % count)];
    const double bend = between(random, 5, 80) * (between(random, 0, 1) < 0.5 ? -1.0 : 1.0);
    ring.push_back(between(random, 0, 1) < 0.6 ? line(start, end) : arc_between(start, end, bend));
  }
  return ring;
}

inline bool is_simple_at_joints(const Contour& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (!meet_only_at_joint(ring[i], ring[(i + 1) % ring.size()])) return false;
  return true;
}

inline Contour reversed(const Contour& ring) {
  Contour back;
  for (auto block = ring.rbegin(); block != ring.rend(); ++block)
    back.push_back({block->end, block->start, block->arc, block->center, -block->sweep_deg});
  return back;
}

/// Not more than the shortest distance between two blocks.
inline double distance_between(const Block& a, const Block& b) {
  constexpr int kParts = 32;
  const auto bound = [](const Block& of, const Block& other) {
    double nearest = HUGE_VAL;
    for (int i = 0; i <= kParts; ++i)
      nearest = std::min(nearest, distance_from(other, point_at(of, i / double{kParts})));
    return nearest - 0.5 * length_of(of) / kParts;
  };
  return std::max(bound(a, b), bound(b, a));
}

/// How far blocks keep away from those that are not their neighbours. Blocks on both sides of one shorter
/// than `small` are neighbours.
inline double clearance_of(const Contour& ring, double small) {
  const std::size_t count = ring.size();
  const auto is_small = [&](std::size_t i) { return length_of(ring[i % count]) < small; };
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      const std::size_t ahead = j - i;
      const std::size_t around = count - ahead;
      if (around < 2 || (ahead == 2 && is_small(i + 1)) || (around == 2 && is_small(j + 1))) continue;
      nearest = std::min(nearest, distance_between(ring[i], ring[j]));
    }
  }
  return nearest;
}

/// Puts a block shorter than the tool or little longer into corners and lines: chamfers, roundings and steps.
inline Contour with_small_blocks(const Contour& ring, double tool, std::mt19937& random) {
  Contour out = ring;
  for (std::size_t i = 0; i < out.size(); ++i) {
    Block& block = out[i];
    Block& next = out[(i + 1) % out.size()];
    if (block.arc || next.arc || i + 1 == out.size()) continue;
    const double kind = between(random, 0, 1);
    if (kind > 0.75) continue;
    const double turn = turn_between(block, next);
    const Vec2 in = direction_of(block, 1.0);
    const Vec2 after = direction_of(next, 0.0);
    const double length = between(random, 0.02, 1.5) * tool;
    if (kind < 0.5 && std::abs(turn) > 2.0 && std::abs(turn) < 150.0) {
      const double back = 0.5 * length / std::cos(radians(0.5 * turn));
      block.end = block.end - back * in;
      next.start = next.start + back * after;
      const Block small =
          kind < 0.25 ? line(block.end, next.start) : arc_between(block.end, next.start, turn);
      out.insert(out.begin() + static_cast<std::ptrdiff_t>(i) + 1, small);
      ++i;
    } else if (kind >= 0.5) {
      const Vec2 middle = point_at(block, 0.5);
      const Vec2 to = middle + length * rotated(in, between(random, -80, 80));
      const Block rest = line(to, block.end);
      block.end = middle;
      out.insert(out.begin() + static_cast<std::ptrdiff_t>(i) + 1, {line(middle, to), rest});
      i += 2;
    }
  }
  return out;
}

inline Contour scaled(Contour contour, double factor) {
  for (Block& block : contour) {
    block.start = factor * block.start;
    block.end = factor * block.end;
    block.center = factor * block.center;
  }
  return contour;
}

/// Once around. Either from the middle of a line, to which the tool comes from its own side; or from an outer
/// corner of two lines, with blocks that prolong them. False when there is no such place.
inline bool course_around(const Contour& ring, const Cutting& cutting, std::mt19937& random, Course& course) {
  const double tool = cutting.tool;
  const double side = cutting.side == Side::left ? 1.0 : -1.0;
  const std::size_t count = ring.size();
  const std::size_t first = random() % count;
  course.blocks.clear();
  if (between(random, 0, 1) < 0.5) {
    const Block& block = ring[first];
    if (block.arc || length_of(block) < 8.0 * tool) return false;
    const Vec2 middle = point_at(block, 0.5);
    const Vec2 away = side * left_of(direction_of(block, 0.0));
    course.before = middle + 6.0 * tool * rotated(away, between(random, -70, 70));
    course.behind = middle + 6.0 * tool * rotated(away, between(random, -70, 70));
    course.blocks.push_back(line(middle, block.end));
    for (std::size_t i = 1; i < count; ++i) course.blocks.push_back(ring[(first + i) % count]);
    course.blocks.push_back(line(block.start, middle));
    return distance_between(course.blocks[0], course.blocks[count - 1]) > 2.5 * tool &&
           distance_between(course.blocks[1], course.blocks[count]) > 2.5 * tool;
  }
  const Block& next = ring[first];
  const Block& last = ring[(first + count - 1) % count];
  if (next.arc || last.arc || -side * turn_between(last, next) < 60.0) return false;
  const Vec2 begin = next.start - 8.0 * tool * direction_of(next, 0.0);
  const Vec2 end = last.end + 8.0 * tool * direction_of(last, 1.0);
  for (int i = 0; i <= 8; ++i) {
    const double part = i / 16.0;
    const Vec2 at_begin = begin + part * (next.start - begin);
    const Vec2 at_end = end + part * (last.end - end);
    if (distance_from(ring, at_begin) < 2.5 * tool || distance_from(ring, at_end) < 2.5 * tool) return false;
  }
  course.before = begin + 6.0 * tool * direction_at(between(random, -180, 180));
  course.behind = end + 6.0 * tool * direction_at(between(random, -180, 180));
  course.blocks.push_back(line(begin, next.start));
  for (std::size_t i = 0; i < count; ++i) course.blocks.push_back(ring[(first + i) % count]);
  course.blocks.push_back(line(last.end, end));
  return true;
}

/// Arcs as chords that miss them by less than a ten thousandth of their radius.
inline std::vector<Vec2> polygon_of(const Contour& ring) {
  std::vector<Vec2> corners;
  for (const Block& block : ring) {
    const int parts = block.arc ? 64 : 1;
    for (int i = 0; i < parts; ++i) corners.push_back(point_at(block, i / double(parts)));
  }
  return corners;
}

/// Positive counterclockwise.
inline double area_of(const std::vector<Vec2>& polygon) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    doubled += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * doubled;
}

inline bool is_inside(const std::vector<Vec2>& polygon, Vec2 point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[(i + 1) % polygon.size()];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// A closed contour, compensated once around.
struct Closed {
  Contour ring;
  Course course;
  Cutting cutting;
};

/// The tool is so small that what is no neighbour is farther away than 2.5 times its radius; with
/// `small_blocks` some blocks are shorter than that. Tools from `least` to `largest` mm.
inline Closed random_closed(std::mt19937& random, InterferenceCheck check, bool small_blocks, double least,
                            double largest) {
  constexpr double kClear = 2.5;
  for (;;) {
    Closed closed;
    closed.ring = random_ring(random);
    if (!is_simple_at_joints(closed.ring)) continue;
    double tool = clearance_of(closed.ring, 0.0) / kClear * between(random, 0.05, 1.0);
    if (!(tool > 0.1)) continue;
    if (small_blocks) {
      tool *= 0.5;
      closed.ring = with_small_blocks(closed.ring, tool, random);
      if (clearance_of(closed.ring, kClear * tool) < kClear * tool) continue;
    }
    if (between(random, 0, 1) < 0.5) closed.ring = reversed(closed.ring);
    closed.cutting = random_cutting(random, check, magnitude_between(random, least, largest));
    closed.ring = scaled(closed.ring, closed.cutting.tool / tool);
    if (course_around(closed.ring, closed.cutting, random, closed.course)) return closed;
  }
}

/// Whether the tool cuts nowhere more than `allowed` mm into the ring, or comes to its wrong side.
inline bool stays_out(const Closed& closed, const ToolPath& path, double allowed, double& deepest) {
  const std::vector<Vec2> polygon = polygon_of(closed.ring);
  const bool inside = (closed.cutting.side == Side::left) == (area_of(polygon) > 0.0);
  bool out = true;
  for (const Way& way : path.ways) {
    if (!is_of_contour(way, closed.course)) continue;
    for (int i = 0; i <= 24; ++i) {
      const Vec2 point = point_at(way.shape, i / 24.0);
      const double cut = closed.cutting.tool - distance_from(closed.ring, point);
      deepest = std::max(deepest, cut);
      out = out && cut <= allowed && is_inside(polygon, point) == inside;
    }
  }
  return out;
}

}  // namespace kerf::toolpath_test
