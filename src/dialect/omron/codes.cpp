#include "dialect/omron/codes.hpp"

#include <algorithm>
#include <array>

namespace kerf::omron {
namespace {

// Manual 1-2, 1-4 and 1-5.
constexpr CodeRow kCodes[] = {
    {'G', 0, Group::motion, "G00", "Rapid positioning", "modal", "Rapid positioning",
     "G00 X_ Y_ Z_ A_ B_ C_"},
    {'G', 10, Group::motion, "G01", "Rapid positioning", "modal", "Linear interpolation",
     "G01 F_ ta_ td_ ts_ X_ Y_ Z_ A_ B_ C_"},
    {'G', 20, Group::motion, "G02", "Rapid positioning", "modal", "Circular interpolation, clockwise",
     "G02 F_ ta_ td_ ts_ X_ Y_ Z_ I_ J_ K_ A_ B_ C_ | G02 F_ ta_ td_ ts_ X_ Y_ Z_ R_ A_ B_ C_"},
    {'G', 30, Group::motion, "G03", "Rapid positioning", "modal", "Circular interpolation, counterclockwise",
     "G03 F_ ta_ td_ ts_ X_ Y_ Z_ I_ J_ K_ A_ B_ C_ | G03 F_ ta_ td_ ts_ X_ Y_ Z_ R_ A_ B_ C_"},
    {'G', 40, Group::one_shot, "G04", "", "one-shot", "Dwell", "G04 F_ | G04 P_ | G04 X_"},
    {'G', 90, Group::one_shot, "G09", "", "one-shot", "Exact stop", "G09"},
    {'G', 170, Group::plane, "G17", "Plane", "modal", "X-Y plane", "G17"},
    {'G', 180, Group::plane, "G18", "Plane", "modal", "Z-X plane", "G18"},
    {'G', 190, Group::plane, "G19", "Plane", "modal", "Y-Z plane", "G19"},
    {'G', 200, Group::unit, "G20", "Unit", "modal", "Inch input", "G20"},
    {'G', 210, Group::unit, "G21", "Unit", "modal", "Metric input", "G21"},
    {'G', 280, Group::one_shot, "G28", "", "one-shot", "Return to the reference point",
     "G28 X_ Y_ Z_ A_ B_ C_"},
    {'G', 300, Group::one_shot, "G30", "", "one-shot", "Return to the 2nd, 3rd or 4th reference point",
     "G30 X_ Y_ Z_ A_ B_ C_ | G30 P2 X_ Y_ Z_ A_ B_ C_ | G30 P3 X_ Y_ Z_ A_ B_ C_ | G30 P4 X_ Y_ Z_ A_ B_ "
     "C_"},
    {'G', 310, Group::one_shot, "G31", "", "one-shot", "Skip", "G31 X_ Y_ Z_ A_ B_ C_"},
    {'G', 400, Group::radius_compensation, "G40", "Tool radius", "modal", "Tool radius compensation off",
     "G40"},
    {'G', 410, Group::radius_compensation, "G41", "Tool radius", "modal", "Tool radius compensation, left",
     "G41"},
    {'G', 420, Group::radius_compensation, "G42", "Tool radius", "modal", "Tool radius compensation, right",
     "G42"},
    {'G', 430, Group::length_compensation, "G43", "Tool length offset", "modal", "Tool offset, positive",
     "G43"},
    {'G', 440, Group::length_compensation, "G44", "Tool length offset", "modal", "Tool offset, negative",
     "G44"},
    {'G', 490, Group::length_compensation, "G49", "Tool length offset", "modal", "Tool offset off", "G49"},
    {'G', 500, Group::scaling, "G50", "Scaling", "modal", "Scaling off", "G50"},
    {'G', 501, Group::mirror, "G50.1", "Mirroring", "modal", "Mirroring off", "G50.1"},
    {'G', 510, Group::scaling, "G51", "Scaling", "modal", "Scaling",
     "G51 X_ Y_ Z_ P_ | G51 X_ Y_ Z_ I_ J_ K_"},
    {'G', 511, Group::mirror, "G51.1", "Mirroring", "modal", "Mirroring", "G51.1 X_ Y_ Z_"},
    {'G', 520, Group::one_shot, "G52", "", "one-shot", "Local coordinate system",
     "G52 X_ Y_ Z_ A_ B_ C_ | G52 X0 Y0 Z0 A0 B0 C0 | G52"},
    {'G', 530, Group::one_shot, "G53", "", "one-shot", "Dimension shift cancel: machine coordinates",
     "G53 X_ Y_ Z_ A_ B_ C_"},
    {'G', 540, Group::work_system, "G54", "Coordinate system selection", "modal", "Work coordinate system 1",
     "G54"},
    {'G', 550, Group::work_system, "G55", "Coordinate system selection", "modal", "Work coordinate system 2",
     "G55"},
    {'G', 560, Group::work_system, "G56", "Coordinate system selection", "modal", "Work coordinate system 3",
     "G56"},
    {'G', 570, Group::work_system, "G57", "Coordinate system selection", "modal", "Work coordinate system 4",
     "G57"},
    {'G', 580, Group::work_system, "G58", "Coordinate system selection", "modal", "Work coordinate system 5",
     "G58"},
    {'G', 590, Group::work_system, "G59", "Coordinate system selection", "modal", "Work coordinate system 6",
     "G59"},
    {'G', 610, Group::path_mode, "G61", "Path control", "modal", "Exact stop mode", "G61"},
    {'G', 640, Group::path_mode, "G64", "Path control", "modal", "Continuous-path mode", "G64"},
    {'G', 680, Group::rotation, "G68", "Rotation", "modal", "Coordinate system rotation", "G68 X_ Y_ Z_ R_"},
    {'G', 690, Group::rotation, "G69", "Rotation", "modal", "Rotation off", "G69"},
    {'G', 740, Group::fixed_cycle, "G74", "Fixed cycle", "modal", "Left-handed tapping cycle",
     "G74 X_ Y_ Z_ R_ P_ K_"},
    {'G', 800, Group::fixed_cycle, "G80", "Fixed cycle", "modal", "Fixed cycle off", "G80"},
    {'G', 840, Group::fixed_cycle, "G84", "Fixed cycle", "modal", "Tapping cycle", "G84 X_ Y_ Z_ R_ P_ K_"},
    {'G', 900, Group::distance, "G90", "Distance", "modal", "Absolute", "G90"},
    {'G', 910, Group::distance, "G91", "Distance", "modal", "Incremental", "G91"},
    {'G', 980, Group::return_level, "G98", "Return level", "modal",
     "Fixed cycle returns to the initial level", "G98"},
    {'G', 990, Group::return_level, "G99", "Return level", "modal",
     "Fixed cycle returns to the R point level", "G99"},
    {'G', 5000, Group::multi_block, "G500", "Multi-block acceleration/deceleration", "modal",
     "Multi-block acceleration/deceleration on", "G500 | G500 P_"},
    {'G', 5010, Group::multi_block, "G501", "Multi-block acceleration/deceleration", "modal",
     "Multi-block acceleration/deceleration off", "G501 | G501 P_"},
    {'M', 0, Group::one_shot, "M00", "", "one-shot", "Program stop", "M00"},
    {'M', 10, Group::one_shot, "M01", "", "one-shot", "Optional stop", "M01"},
    {'M', 20, Group::one_shot, "M02", "", "one-shot", "End of program", "M02"},
    {'M', 300, Group::one_shot, "M30", "", "one-shot", "End of program", "M30"},
    {'M', 30, Group::one_shot, "M03", "", "one-shot", "Spindle clockwise", "M03 [S_]"},
    {'M', 40, Group::one_shot, "M04", "", "one-shot", "Spindle counterclockwise", "M04 [S_]"},
    {'M', 50, Group::one_shot, "M05", "", "one-shot", "Spindle off", "M05"},
    {'M', 190, Group::one_shot, "M19", "", "one-shot", "Spindle orientation", "M19"},
    {'M', 980, Group::one_shot, "M98", "", "one-shot", "Subprogram call", "M98 P_ [L_]"},
    {'M', 990, Group::one_shot, "M99", "", "one-shot", "End of subprogram", "M99"},
    {0, 0, Group::one_shot, "M0 to M191", "Words", "", "Auxiliary function output",
     "M{0-191} [VA_ VB_ VC_ VD_ VE_ VF_ VG_ VH_]"},
    {0, 0, Group::one_shot, "N", "Words", "", "Block number; the line of the source counts", "N_"},
    {0, 0, Group::one_shot, "/", "Words", "", "Optional skip", "/{1-31} in front of the block"},
    {0, 0, Group::one_shot, "F", "Words", "", "Feedrate, command units/min", "F_ (above 0)"},
    {0, 0, Group::one_shot, "S", "Words", "", "Spindle speed, r/min", "S_ (0 and above)"},
    {0, 0, Group::one_shot, "ta", "Words", "", "Acceleration time, ms", "ta_ (0 to 250000)"},
    {0, 0, Group::one_shot, "td", "Words", "", "Deceleration time, ms", "td_ (0 to 250000)"},
    {0, 0, Group::one_shot, "ts", "Words", "", "Jerk time, ms", "ts_ (0 to 125000)"},
    {0, 0, Group::one_shot, "X Y Z A B C", "Words", "", "Axis words, command units or degrees",
     "X_ or X[L_], X[Q_], X[P_]"},
    {0, 0, Group::one_shot, "I J K", "Words", "", "Centre of an arc from its start; magnifications of G51",
     "I_ J_ K_"},
    {0, 0, Group::one_shot, "R", "Words", "", "Radius of an arc; angle of G68; R point of a cycle", "R_"},
    {0, 0, Group::one_shot, "P", "Words", "",
     "Dwell, program, reference point, magnification or parameter set, by the code", "P_"},
    {0, 0, Group::one_shot, "L", "Words", "", "Number of calls", "M98 P_ L_ (0 to 10000)"},
    {0, 0, Group::one_shot, "K", "Words", "", "Repetitions of a cycle", "K_ (0 to 10000)"},
};

constexpr CodeNumber kHighest = code(501);

/// Row of each G code, kNone where there is none.
constexpr std::uint8_t kNone = 0xFF;
using Index = std::array<std::uint8_t, kHighest + 1>;

constexpr Index make_index() {
  Index index{};
  std::fill(index.begin(), index.end(), kNone);
  for (std::size_t i = 0; i < std::size(kCodes); ++i) {
    if (kCodes[i].letter == 'G') index[kCodes[i].number] = static_cast<std::uint8_t>(i);
  }
  return index;
}

constexpr Index kIndex = make_index();

}  // namespace

std::span<const CodeRow> code_table() {
  return kCodes;
}

const CodeRow* find_g_code(CodeNumber number) {
  if (number > kHighest || kIndex[number] == kNone) return nullptr;
  return &kCodes[kIndex[number]];
}

}  // namespace kerf::omron
