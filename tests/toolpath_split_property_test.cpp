// Whether a straight line of a contour is one block or several in one line makes no difference to the path of
// the tool. Where this holds, and where it does not, because the interference check sees three blocks and no
// more:
//
// - with any check, and without: the lines are divided where the tool touches them, no matter how short the
// pieces
//   between are;
// - on "avoid" one piece in front of an inner corner, or behind it, may be shorter than what the tool leaves
// of the
//   line there. On "alarm" this gives the alarm, and without the check the tool cuts into the piece;
// - two such pieces of one line are the alarm on "avoid", too.

#include <gtest/gtest.h>

#include "toolpath_closed_contours.hpp"

namespace kerf {
namespace {

using namespace toolpath_test;

/// The stretch of a block that the tool touches.
struct Stretch {
  double first = 0.0;
  double last = 1.0;
};

/// The contour's blocks keep away from each other, so this is one stretch around the middle of a block.
Stretch touched(const Course& course, std::size_t index, double left) {
  const Block& block = course.blocks[index];
  const auto is_free = [&](double part) {
    const Vec2 tool = beside(block, part, left);
    for (std::size_t i = index == 0 ? 0 : index - 1; i < std::min(index + 2, course.blocks.size()); ++i)
      if (distance_from(course.blocks[i], tool) < (1.0 - 1e-9) * std::abs(left)) return false;
    return true;
  };
  double middle = 0.5;
  for (int i = 1; i < 64 && !is_free(middle); ++i) middle = i / 64.0;
  const auto border = [&](double outside) {
    if (is_free(outside)) return outside;
    double inside = middle;
    for (int i = 0; i < 50; ++i) {
      const double half = 0.5 * (inside + outside);
      (is_free(half) ? inside : outside) = half;
    }
    return inside;
  };
  return {border(0.0), border(1.0)};
}

void divide(const Block& block, std::vector<double> parts, Contour& out) {
  std::sort(parts.begin(), parts.end());
  Vec2 at = block.start;
  for (const double part : parts) {
    const Vec2 to = point_at(block, part);
    if (distance(at, to) < 1e-5 || distance(to, block.end) < 1e-5) continue;
    out.push_back(line(at, to));
    at = to;
  }
  out.push_back(line(at, block.end));
}

/// Every line in one to four pieces, divided where the tool touches it.
Course divided(const Course& course, double left, std::mt19937& random) {
  Course out = course;
  out.blocks.clear();
  for (std::size_t i = 0; i < course.blocks.size(); ++i) {
    const Block& block = course.blocks[i];
    if (block.arc) {
      out.blocks.push_back(block);
      continue;
    }
    const Stretch stretch = touched(course, i, left);
    std::vector<double> parts(random() % 4);
    for (double& part : parts) part = between(random, stretch.first, stretch.last);
    divide(block, parts, out.blocks);
  }
  return out;
}

/// One piece at an end of one line is shorter than what the tool leaves of it. False when there is no such
/// place.
bool divide_beyond(const Course& course, double left, std::mt19937& random, Course& out) {
  const std::size_t first = random() % course.blocks.size();
  for (std::size_t n = 0; n < course.blocks.size(); ++n) {
    const std::size_t i = (first + n) % course.blocks.size();
    if (i == 0 || i + 1 == course.blocks.size() || course.blocks[i].arc) continue;
    const Stretch stretch = touched(course, i, left);
    const double length = length_of(course.blocks[i]);
    const bool at_end = (1.0 - stretch.last) * length > 0.05 * std::abs(left);
    if (!at_end && stretch.first * length < 0.05 * std::abs(left)) continue;
    const double inwards = between(random, 0.1, 0.9);
    const double part = at_end ? 1.0 - inwards * (1.0 - stretch.last) : inwards * stretch.first;
    out = course;
    out.blocks.erase(out.blocks.begin() + static_cast<std::ptrdiff_t>(i));
    Contour pieces;
    divide(course.blocks[i], {part}, pieces);
    out.blocks.insert(out.blocks.begin() + static_cast<std::ptrdiff_t>(i), pieces.begin(), pieces.end());
    return pieces.size() == 2;
  }
  return false;
}

TEST(SplitProperty, PiecesOfALineGiveThePathOfTheLine) {
  static constexpr InterferenceCheck kChecks[] = {InterferenceCheck::none, InterferenceCheck::alarm,
                                                  InterferenceCheck::avoid};
  const int count = contours(300);
  std::mt19937 random(43);
  double worst = 0.0;
  std::size_t pieces = 0;
  for (int i = 0; i < count; ++i) {
    const Closed closed = random_closed(random, kChecks[i % 3], false, 1e-3, 1e4);
    const Course other = divided(closed.course, left_mm(closed.cutting), random);
    pieces += other.blocks.size() - closed.course.blocks.size();
    const ToolPath whole = tool_path(closed.course, closed.cutting);
    const ToolPath path = tool_path(other, closed.cutting);
    ASSERT_EQ(whole.alarm, nullptr) << "contour " << i;
    ASSERT_EQ(path.alarm, nullptr) << "contour " << i << ", block " << path.alarm_block << ", tool "
                                   << closed.cutting.tool;
    const double difference = difference_between(whole, path);
    worst = std::max(worst, difference / closed.cutting.tool);
    EXPECT_LT(difference, 3e-6 + 1e-8 * closed.cutting.tool) << "contour " << i;
  }
  EXPECT_GT(pieces, static_cast<std::size_t>(count));
  std::printf("%d contours, %zu joints more, largest difference %.3g of the radius\n", count, pieces, worst);
}

TEST(SplitProperty, AvoidingTakesAwayOnePieceThatTheToolDoesNotTouch) {
  const int count = contours(300);
  std::mt19937 random(47);
  int found = 0;
  int refused = 0;
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    Closed closed = random_closed(random, InterferenceCheck::avoid, false, 1e-3, 1e4);
    Course other;
    if (!divide_beyond(closed.course, left_mm(closed.cutting), random, other)) continue;
    ++found;
    const ToolPath whole = tool_path(closed.course, closed.cutting);
    const ToolPath path = tool_path(other, closed.cutting);
    ASSERT_EQ(path.alarm, nullptr) << "contour " << i << ", block " << path.alarm_block;
    const double difference = difference_between(whole, path);
    worst = std::max(worst, difference / closed.cutting.tool);
    EXPECT_LT(difference, 3e-6 + 1e-8 * closed.cutting.tool) << "contour " << i;
    closed.cutting.check = InterferenceCheck::alarm;
    refused += tool_path(other, closed.cutting).alarm == &kInterference ? 1 : 0;
  }
  EXPECT_GT(found, count / 2);
  EXPECT_EQ(refused, found);
  std::printf("%d contours, largest difference %.3g of the radius\n", found, worst);
}

// A square corner in which a tool of radius 5 leaves 5 mm of both lines.
TEST(SplitProperty, TwoPiecesThatTheToolDoesNotTouchAreTooMuch) {
  const auto alarm_of = [](const Contour& blocks) {
    const Course course{blocks, {-30, 10}, {40, 40}};
    return tool_path(course, {Side::left, 5.0, InterferenceCheck::avoid, StartType::A, kPlaneXY}).alarm;
  };
  const Vec2 start{-30, 0};
  const Vec2 corner{30, 0};
  const Block wall = line(corner, {30, 40});
  EXPECT_EQ(alarm_of({line(start, corner), wall}), nullptr);
  EXPECT_EQ(alarm_of({line(start, {27, 0}), line({27, 0}, corner), wall}), nullptr);
  EXPECT_EQ(alarm_of({line(start, {26, 0}), line({26, 0}, {28, 0}), line({28, 0}, corner), wall}),
            &kInterference);
}

}  // namespace
}  // namespace kerf
