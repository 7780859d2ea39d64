// A contour that is mirrored, turned and moved gives the path mirrored, turned and moved, or the same alarm.

#include <gtest/gtest.h>

#include "toolpath_closed_contours.hpp"

namespace kerf {
namespace {

using namespace toolpath_test;

/// First mirrored at the x axis, then turned around the origin, then moved.
struct Placing {
  bool mirrored = false;
  double turned_deg = 0.0;
  Vec2 moved;

  Vec2 operator()(Vec2 point) const {
    const Vec2 image = mirrored ? Vec2{point.x, -point.y} : point;
    return moved + rotated(image, turned_deg);
  }
  Block operator()(Block block) const {
    block.start = (*this)(block.start);
    block.end = (*this)(block.end);
    block.center = (*this)(block.center);
    if (mirrored) block.sweep_deg = -block.sweep_deg;
    return block;
  }
  Cutting operator()(Cutting cutting) const {
    if (mirrored) cutting.side = cutting.side == Side::left ? Side::right : Side::left;
    return cutting;
  }
  Course operator()(Course course) const {
    course.before = (*this)(course.before);
    course.behind = (*this)(course.behind);
    for (Block& block : course.blocks) block = (*this)(block);
    return course;
  }
  ToolPath operator()(ToolPath path) const {
    for (Way& way : path.ways) way.shape = (*this)(way.shape);
    return path;
  }
};

double extent_of(const Course& course) {
  double extent = 0.0;
  for (const Block& block : course.blocks) extent = std::max(extent, length(block.end - course.before));
  return extent;
}

Placing random_placing(std::mt19937& random, double extent) {
  Placing placing;
  placing.mirrored = between(random, 0, 1) < 0.5;
  const int kind = static_cast<int>(random() % 3);
  if (kind == 0) return placing;
  placing.turned_deg = kind == 1 ? 90.0 * static_cast<double>(random() % 4) : between(random, -180, 180);
  placing.moved = between(random, 0, 3) * extent * direction_at(between(random, -180, 180));
  return placing;
}

struct Count {
  int alarms = 0;
  int other_alarms = 0;
  double worst = 0.0;  ///< of the radius
  int worst_of = -1;
};

template <class Make>
Count compare(int count, Make make) {
  static constexpr InterferenceCheck kChecks[] = {InterferenceCheck::none, InterferenceCheck::alarm,
                                                  InterferenceCheck::avoid};
  std::mt19937 random(53);
  Count counted;
  for (int i = 0; i < count; ++i) {
    Cutting cutting;
    const Course course = make(random, kChecks[i % 3], cutting);
    const Placing placing = random_placing(random, extent_of(course));
    const ToolPath path = tool_path(course, cutting);
    const ToolPath other = tool_path(placing(course), placing(cutting));
    counted.alarms += path.alarm != nullptr ? 1 : 0;
    if (path.alarm != other.alarm || path.alarm_block != other.alarm_block) {
      ++counted.other_alarms;
      std::printf("contour %d: alarm at %zu and %zu\n", i, path.alarm_block, other.alarm_block);
      continue;
    }
    const double difference = difference_between(placing(path), other) / cutting.tool;
    if (difference <= counted.worst) continue;
    counted.worst = difference;
    counted.worst_of = i;
  }
  std::printf("%d of %d with an alarm, largest difference %.3g of the radius (contour %d)\n", counted.alarms,
              count, counted.worst, counted.worst_of);
  return counted;
}

TEST(SymmetryProperty, ChainsOfShortBlocks) {
  const int count = contours(1000);
  const Count counted = compare(count, [](std::mt19937& random, InterferenceCheck check, Cutting& cutting) {
    cutting = random_cutting(random, check, magnitude_between(random, 0.1, 1e4));
    return random_chain(random, cutting.tool);
  });
  EXPECT_EQ(counted.other_alarms, 0);
  EXPECT_LT(counted.worst, 1e-4);
  EXPECT_GT(counted.alarms, count / 10);
}

TEST(SymmetryProperty, ClosedContours) {
  const Count counted =
      compare(contours(300), [](std::mt19937& random, InterferenceCheck check, Cutting& cutting) {
        const Closed closed = random_closed(random, check, true, 0.1, 1e4);
        cutting = closed.cutting;
        return closed.course;
      });
  EXPECT_EQ(counted.other_alarms, 0);
  EXPECT_LT(counted.worst, 1e-4);
}

}  // namespace
}  // namespace kerf
