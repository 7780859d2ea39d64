#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "report/svg_path.hpp"

namespace kerf {
namespace {

struct Segment {
  Point2 from;
  Point2 to;
};

/// The straight strokes of path data made of M and l commands.
std::vector<Segment> segments_of(const std::string& data) {
  std::vector<Segment> segments;
  Point2 pen;
  char command = ' ';
  const char* at = data.c_str();
  const auto number = [&at] {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    EXPECT_NE(end, at);
    at = end;
    return value;
  };
  while (*at != '\0') {
    if (*at == 'M' || *at == 'l') command = *at++;
    const double x = number();
    const double y = number();
    if (command == 'M') {
      pen = {x, y};
    } else {
      segments.push_back({pen, {pen.x + x, pen.y + y}});
      pen = segments.back().to;
    }
  }
  return segments;
}

double distance(Point2 p, const Segment& s) {
  const double dx = s.to.x - s.from.x;
  const double dy = s.to.y - s.from.y;
  const double square = dx * dx + dy * dy;
  const double t =
      square > 0.0 ? std::clamp(((p.x - s.from.x) * dx + (p.y - s.from.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - s.from.x - t * dx, p.y - s.from.y - t * dy);
}

TEST(ReportSvgPath, JoinsStrokesOfOneLine) {
  SvgPath path(0.05);
  path.line({10, 10}, {20, 10});
  path.line({20, 10}, {35.5, 10});
  path.line({35.5, 10}, {35.5, 4});
  EXPECT_EQ(path.finish(), "M10 10l25.5 0 0-6");
}

TEST(ReportSvgPath, LiftsThePenBetweenStrokesThatDoNotMeet) {
  SvgPath path(0.05);
  path.line({0, 0}, {10, 0});
  path.line({20, 5}, {30, 5});
  EXPECT_EQ(path.finish(), "M0 0l10 0M20 5l10 0");
}

TEST(ReportSvgPath, KeepsAPathThatTurnsBack) {
  SvgPath path(0.05);
  path.line({0, 0}, {10, 0});
  path.line({10, 0}, {-5, 0});
  EXPECT_EQ(path.finish(), "M0 0l10 0-15 0");
}

TEST(ReportSvgPath, DrawsRepeatedStrokesOnce) {
  SvgPath path(0.05);
  for (int pass = 0; pass < 5; ++pass) {
    path.line({0, 0}, {10, 0});
    path.line({10, 0}, {10, 10});
    path.line({10, 10}, {0, 0});
  }
  EXPECT_EQ(path.finish(), "M0 0l10 0 0 10-10-10");
}

TEST(ReportSvgPath, ArcsStayArcs) {
  SvgPath path(0.05);
  path.line({0, 0}, {10, 0});
  path.arc({10, 0}, {20, 10}, {10, 10, true});
  path.arc({20, 10}, {20, 10.01}, {10, 10, true});  // shorter than a picture shows
  path.arc({20, 10.01}, {10, 20}, {10, 5, false});
  EXPECT_EQ(path.finish(), "M0 0l10 0a10 10 0 0 1 10 10l0 0.01a10 5 0 0 0-10 9.99");
}

TEST(ReportSvgPath, EmptyHasNoData) {
  SvgPath path(0.05);
  EXPECT_EQ(path.finish(), "");
}

// Whatever is left out lies within the tolerance of what is drawn, and the drawing is much smaller.
TEST(ReportSvgPath, EveryPointLiesWithinTheTolerance) {
  constexpr double kTolerance = 0.1;
  std::mt19937 random(99);
  std::uniform_real_distribution<double> turn(-0.2, 0.2);
  std::vector<Point2> points{{500, 500}};
  double heading = 0.0;
  for (int i = 0; i < 1500; ++i) {
    heading += turn(random) + (i % 200 == 0 ? 2.5 : 0.0);
    const Point2 last = points.back();
    points.push_back({last.x + 0.07 * std::cos(heading), last.y + 0.07 * std::sin(heading)});
  }
  SvgPath path(kTolerance);
  for (std::size_t i = 1; i < points.size(); ++i) path.line(points[i - 1], points[i]);
  const auto segments = segments_of(path.finish());
  ASSERT_FALSE(segments.empty());
  EXPECT_LT(segments.size(), points.size() / 3);
  // Two places are taken for one within the rounding of 0.005 and the repetition grid of twice the tolerance.
  for (const Point2& point : points) {
    double nearest = 1e9;
    for (const Segment& segment : segments) nearest = std::min(nearest, distance(point, segment));
    ASSERT_LE(nearest, 3.0 * kTolerance + 0.01);
  }
}

TEST(ReportSvgPath, ACircleOfTinyStrokesKeepsItsShape) {
  constexpr double kTolerance = 0.05;
  constexpr int kParts = 20'000;
  SvgPath path(kTolerance);
  const auto at = [](int i) {
    const double angle = 6.283185307179586 * i / kParts;
    return Point2{100.0 + 80.0 * std::cos(angle), 100.0 + 80.0 * std::sin(angle)};
  };
  for (int i = 0; i < kParts; ++i) path.line(at(i), at(i + 1));
  const auto segments = segments_of(path.finish());
  EXPECT_LT(segments.size(), 200U);
  for (const Segment& s : segments) {
    const Point2 middle{(s.from.x + s.to.x) / 2.0, (s.from.y + s.to.y) / 2.0};
    ASSERT_NEAR(std::hypot(middle.x - 100.0, middle.y - 100.0), 80.0, 2.0 * kTolerance + 0.01);
  }
}

}  // namespace
}  // namespace kerf
