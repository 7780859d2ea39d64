#pragma once
// Random open contours with features smaller and larger than the tool: steps, notches, slots, bumps and arcs.
// They run along an axis and never cross themselves.

#include "toolpath_contours.hpp"

namespace kerf::toolpath_test {

/// Builds a contour by steps along and across its run, in radii of the tool.
struct RoughContour {
  Contour blocks;
  Vec2 at;

  void go(double along, double across) {
    const Vec2 to = at + Vec2{along, across};
    blocks.push_back(line(at, to));
    at = to;
  }
  void bow(double along, double across, double sweep_deg) {
    const Vec2 to = at + Vec2{along, across};
    blocks.push_back(arc_between(at, to, sweep_deg));
    at = to;
  }
};

/// One feature, as high as `height` (negative: deep) and about as wide as `width`.
inline void add_feature(RoughContour& contour, std::mt19937& random, double height, double width) {
  const double side = height < 0.0 ? -1.0 : 1.0;
  switch (random() % 8) {
    case 0:  // a step
      return contour.go(0, height);
    case 1: {  // a step in several short blocks
      const int count = 2 + static_cast<int>(random() % 5);
      for (int i = 0; i < count; ++i)
        contour.go(width / count * between(random, 0.5, 1.5), height / count * between(random, 0.0, 2.0));
      return;
    }
    case 2:  // a point or a V
      contour.go(0.5 * width, height);
      return contour.go(0.5 * width, -height);
    case 3:  // a rib or a slot
      contour.go(0, height);
      contour.go(width, 0);
      return contour.go(0, -height);
    case 4: {  // one that widens towards its end
      const double wider = between(random, 0.0, 0.4) * width;
      contour.go(1.1 * wider, 0);
      contour.go(-wider, height);
      contour.go(width + 2.0 * wider, 0);
      contour.go(-wider, -height);
      return contour.go(1.1 * wider, 0);
    }
    case 5:  // a round one, up to half a circle
      return contour.bow(width, 0, -side * between(random, 20, 180));
    case 6: {  // rounded ends of a step
      const double radius = std::min(width, std::abs(height)) * between(random, 0.1, 0.5);
      contour.bow(radius, side * radius, side * 90);
      contour.go(0, height - side * 2.0 * radius);
      return contour.bow(radius, side * radius, -side * 90);
    }
    default:  // a bevel
      return contour.go(width, height);
  }
}

inline Vec2 mapped(Vec2 point, double scale, double turn, bool mirrored) {
  return rotated(scale * Vec2{point.x, mirrored ? -point.y : point.y}, turn);
}

/// Whether the tool runs inside of an arc that is too small for it.
inline bool is_too_small(const Block& block, const Cutting& cutting) {
  const bool inside = (block.sweep_deg > 0.0) == (cutting.side == Side::left);
  return block.arc && inside && distance(block.start, block.center) < 1.001 * cutting.tool;
}

/// Inner arcs too small for the tool, which no check can do anything about, are straight lines.
inline Course random_rough(std::mt19937& random, const Cutting& cutting) {
  const double tool = cutting.tool;
  RoughContour contour;
  contour.go(between(random, 4, 10), 0);
  const int count = 1 + static_cast<int>(random() % 6);
  for (int i = 0; i < count; ++i) {
    const double height = magnitude_between(random, 0.03, 4.0) * (between(random, 0, 1) < 0.5 ? -1.0 : 1.0);
    add_feature(contour, random, height, magnitude_between(random, 0.03, 6.0));
    contour.go(magnitude_between(random, 0.03, 8.0), 0);
  }
  contour.go(between(random, 4, 10), 0);
  const double turn = between(random, -180, 180);
  const bool mirrored = between(random, 0, 1) < 0.5;
  Course course;
  for (const Block& block : contour.blocks) {
    if (length_of(block) * tool < 1e-3) continue;  // mm
    Block own{mapped(block.start, tool, turn, mirrored), mapped(block.end, tool, turn, mirrored), block.arc,
              mapped(block.center, tool, turn, mirrored), mirrored ? -block.sweep_deg : block.sweep_deg};
    course.blocks.push_back(is_too_small(own, cutting) ? line(own.start, own.end) : own);
  }
  course.before = mapped({-5, 0}, tool, turn, mirrored);
  course.behind = mapped(contour.at + Vec2{5, 0}, tool, turn, mirrored);
  return course;
}

}  // namespace kerf::toolpath_test
