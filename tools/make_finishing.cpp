// Writes examples/dgshape/finishing.nc, a three-axis finishing pass as a CAM system posts it: short straight
// moves along parallel lines over a smooth surface. With a number of blocks it writes a larger part of the
// same kind, for bench/.
//
//   make_finishing [BLOCKS] > finishing.nc
//
// The surface is h(x, y) = a (cos(kx x) cos(ky y) - 1) with two waves a part; the ball nose touches it, so
// the centre of the ball is the surface point plus the radius along the surface normal, and the programmed
// tip is one radius lower.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kBallRadius_mm = 2.0;
constexpr double kPointSpacing_mm = 0.25;
constexpr double kLineSpacing_mm = 0.475;
constexpr double kAmplitude_mm = 2.0;
constexpr double kWave_mm = 30.0;
constexpr int kLeastBlocks = 20'000;

struct Surface {
  double height;
  double slope_x;
  double slope_y;
};

Surface surface(double x, double y) {
  const double k = 2.0 * kPi / kWave_mm;
  return {kAmplitude_mm * (std::cos(k * x) * std::cos(k * y) - 1.0),
          -kAmplitude_mm * k * std::sin(k * x) * std::cos(k * y),
          -kAmplitude_mm * k * std::cos(k * x) * std::sin(k * y)};
}

// Height of the ball's tip when its centre stands over (x, y): the contact point is found by a few
// fixed-point steps.
double tip_height(double x, double y) {
  double contact_x = x;
  double contact_y = y;
  double tip = 0.0;
  for (int i = 0; i < 40; ++i) {
    const Surface s = surface(contact_x, contact_y);
    const double norm = std::sqrt(1.0 + s.slope_x * s.slope_x + s.slope_y * s.slope_y);
    contact_x = x + kBallRadius_mm * s.slope_x / norm;
    contact_y = y + kBallRadius_mm * s.slope_y / norm;
    tip = s.height + kBallRadius_mm / norm - kBallRadius_mm;
  }
  return tip;
}

void write_program(int points, int lines) {
  std::printf(
      "%%\n"
      "O00000104\n"
      "(WAVE RELIEF, %.0f X %.0f MM, MODELLING WAX)\n"
      "(FINISHING WITH T7, BALL NOSE 4 MM: %d LINES OF %d POINTS)\n"
      "(ORIGIN: FRONT LEFT CORNER, Z0 ON TOP)\n"
      "G21\n"
      "G90G17G40G49G56\n"
      "N100M06T7\n"
      "G00X0.0Y0.0\n"
      "G43H7Z10.0\n"
      "S12000M03\n"
      "Z2.0\n"
      "G01F1800.0\n",
      (points - 1) * kPointSpacing_mm, (lines - 1) * kLineSpacing_mm, lines, points);
  for (int line = 0; line < lines; ++line) {
    const double y = line * kLineSpacing_mm;
    for (int i = 0; i < points; ++i) {
      const double x = (line % 2 == 0 ? i : points - 1 - i) * kPointSpacing_mm;
      if (i == 0) {
        std::printf("X%.3fY%.3fZ%.3f\n", x, y, tip_height(x, y));
      } else {
        std::printf("X%.3fZ%.3f\n", x, tip_height(x, y));
      }
    }
  }
  std::printf(
      "G00Z10.0\n"
      "M05\n"
      "M06T0\n"
      "M30\n"
      "%%\n");
}

}  // namespace

int main(int argc, char** argv) {
  const int blocks = argc > 1 ? std::atoi(argv[1]) : kLeastBlocks;
  if (blocks < kLeastBlocks || blocks > 100'000'000) {
    std::fprintf(stderr, "make_finishing: the number of blocks is %d to 100000000\n", kLeastBlocks);
    return 2;
  }
  // The part keeps its shape, 3 : 2, and its spacings; it grows with the number of blocks.
  const double scale = std::sqrt(static_cast<double>(blocks) / kLeastBlocks);
  const int points = std::max(2, static_cast<int>(std::lround(240.0 * scale)) + 1);
  const int lines = static_cast<int>(std::ceil(static_cast<double>(blocks) / points));
  write_program(points, lines);
  return std::ferror(stdout) != 0 ? 1 : 0;
}
