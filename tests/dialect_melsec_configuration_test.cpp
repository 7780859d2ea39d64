// The parameters of the MELSEC dialect: what does not go together, and which details code says so.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialect/melsec/configuration.hpp"
#include "dialect/melsec/word_device.hpp"
#include "dialect/setup.hpp"
#include "execute/interpreter.hpp"
#include "machine/machine_text.hpp"

namespace kerf {
namespace {

using melsec::DeviceFault;
using melsec::word_device;

using Made = tl::expected<Controller, std::vector<SettingsError>>;

Made melsec_of(const std::vector<std::string>& assignments, const std::string& file = {}) {
  SetupOptions options;
  options.dialect = "melsec";
  options.assignments = assignments;
  if (!file.empty()) options.machine_text = file;
  options.machine_file = "m.toml";
  return make_controller(options);
}

/// The codes of all complaints, with blanks between; empty when the machine is good.
std::string codes_of(const Made& made) {
  std::string codes;
  if (made) return codes;
  for (const SettingsError& error : made.error()) {
    codes += fmt::format("{}{}", codes.empty() ? "" : " ", error.alarm.empty() ? "-" : error.alarm);
  }
  return codes;
}

std::string text_of(const Made& made) {
  return made ? "" : error_text(made.error().front());
}

std::string run(const Controller& c, const std::string& blocks, AxisVector* end = nullptr) {
  Interpreter program(c.rules, Source::from_text("O001.gcd", "%\n" + blocks + "M02\n%\n"),
                      c.interpreter_options);
  while (const Action* action = program.next()) {
    if (const auto* alarm = std::get_if<Alarm>(&action->what)) return std::string(alarm->kind->detail);
  }
  if (end != nullptr) *end = program.state().registers.position;
  return {};
}

struct Example {
  std::string codes;  ///< in their order; empty: accepted
  std::vector<std::string> settings;
};

void PrintTo(const Example& example, std::ostream* out) {
  *out << fmt::format("{}: {}", example.codes, fmt::join(example.settings, ", "));
}

class MelsecConfiguration : public testing::TestWithParam<Example> {};

TEST_P(MelsecConfiguration, IsRefusedByItsDetailsCode) {
  EXPECT_EQ(codes_of(melsec_of(GetParam().settings)), GetParam().codes);
}

#define SYS "melsec.system."

INSTANTIATE_TEST_SUITE_P(
    BaseAxes, MelsecConfiguration,
    testing::Values(Example{"0010H", {SYS "base_axis_j=X"}}, Example{"0010H", {SYS "base_axis_k=W"}},
                    Example{"0010H 0010H 0010H", {SYS "base_axis_j=X", SYS "base_axis_k=X"}},
                    Example{"", {SYS "base_axis_j=0", SYS "base_axis_k=0"}},
                    Example{"", {SYS "base_axis_k=C"}}));

INSTANTIATE_TEST_SUITE_P(
    NormalLine, MelsecConfiguration,
    testing::Values(Example{"", {SYS "normal_line_axis=C"}}, Example{"0011H", {SYS "normal_line_axis=A"}},
                    Example{"0012H", {SYS "normal_line_axis=C", "axes.C.type=linear"}},
                    Example{"0012H", {SYS "normal_line_axis=C", SYS "base_axis_k=C"}},
                    Example{"0012H", {SYS "normal_line_axis=C", SYS "normal_line_rotating_speed=10001"}},
                    Example{"", {SYS "normal_line_axis=C", SYS "normal_line_rotating_speed=10000"}},
                    Example{"", {SYS "normal_line_rotating_speed=100000"}}));

INSTANTIATE_TEST_SUITE_P(
    Polar, MelsecConfiguration,
    testing::Values(
        Example{"", {SYS "polar_linear_axis=X", SYS "polar_rotary_axis=C"}},
        Example{"0013H", {SYS "polar_linear_axis=X"}}, Example{"0013H", {SYS "polar_rotary_axis=C"}},
        Example{"0013H", {SYS "polar_linear_axis=U", SYS "polar_rotary_axis=C"}},
        Example{"0013H", {SYS "polar_linear_axis=X", SYS "polar_rotary_axis=B"}},
        Example{"0014H", {SYS "polar_linear_axis=X", SYS "polar_rotary_axis=C", "axes.C.type=linear"}},
        Example{"0014H", {SYS "polar_linear_axis=X", SYS "polar_rotary_axis=C", SYS "normal_line_axis=C"}},
        Example{"0014H", {SYS "polar_linear_axis=X", SYS "polar_rotary_axis=C", SYS "base_axis_k=C"}},
        Example{"0014H", {"axes.U.number=5", SYS "polar_linear_axis=U", SYS "polar_rotary_axis=C"}},
        Example{
            "0014H",
            {"axes.A.number=5", SYS "base_axis_k=A", SYS "polar_linear_axis=A", SYS "polar_rotary_axis=C"}}));

INSTANTIATE_TEST_SUITE_P(
    HighAccuracy, MelsecConfiguration,
    testing::Values(Example{"0015H", {"axes.X.max_feed=10001"}}, Example{"", {"axes.X.max_feed=10000"}},
                    Example{"0015H", {"melsec.axis.X.high_accuracy_cutting_clamp_speed=10001"}},
                    Example{"", {"axes.X.max_feed=20000", SYS "pre_accel_max_speed=20000"}},
                    Example{"0015H", {"axes.X.max_feed=1000000", SYS "pre_accel_max_speed=999999"}}));

INSTANTIATE_TEST_SUITE_P(
    Macro, MelsecConfiguration,
    testing::Values(
        Example{"0016H",
                {SYS "common_all_points=401", SYS "common_system_points=500",
                 SYS "common_all_start_device=D0", SYS "common_system_start_device=D2000"}},
        Example{"",
                {SYS "common_all_points=400", SYS "common_system_points=500",
                 SYS "common_all_start_device=D0", SYS "common_system_start_device=D2000"}},
        Example{"0016H", {SYS "common_all_points=1"}}, Example{"0016H", {SYS "common_system_points=1"}},
        Example{"0016H", {SYS "common_system_points=901"}},
        Example{"0016H", {SYS "local_start_device=D7001"}}, Example{"", {SYS "local_start_device=D56684"}},
        Example{"0016H", {SYS "local_start_device=D56686"}}, Example{"0016H", {SYS "local_start_device=M0"}},
        Example{"2221H", {SYS "local_start_device=U0\\G1000"}},
        Example{"2221H", {SYS "local_start_device=U3E2\\HG0"}},
        Example{"0016H",
                {SYS "local_start_device=D7000", SYS "common_all_points=10",
                 SYS "common_all_start_device=D7658"}},
        Example{"",
                {SYS "local_start_device=D7000", SYS "common_all_points=10",
                 SYS "common_all_start_device=W1658"}},
        Example{"",
                {SYS "local_start_device=D7000", SYS "common_all_points=10",
                 SYS "common_all_start_device=D7660"}}));

INSTANTIATE_TEST_SUITE_P(Axes, MelsecConfiguration,
                         testing::Values(Example{"0020H", {"axes.X.number=1", "axes.Y.number=1"}},
                                         Example{"0020H", {"axes.X.number=65"}},
                                         Example{"", {"axes.X.number=64"}},
                                         Example{"-",
                                                 {"axes.A.number=5", "axes.B.number=6", "axes.U.number=7",
                                                  "axes.V.number=8", "axes.W.number=9"}},
                                         Example{"0101H", {"axes.X.limits=[-100,100]", "axes.X.start=150"}}));

INSTANTIATE_TEST_SUITE_P(
    Tandem, MelsecConfiguration,
    testing::Values(
        Example{"", {"axes.U.number=5", "melsec.axis.U.master_axis_name=X"}},
        Example{"", {"axes.U.number=5", "axes.U.type=rotary", "melsec.axis.U.master_axis_name=C"}},
        Example{"0023H", {"axes.U.number=5", SYS "base_axis_k=U", "melsec.axis.U.master_axis_name=X"}},
        Example{"0023H", {"axes.U.number=5", "melsec.axis.U.master_axis_name=W"}},
        Example{"0023H", {"axes.U.number=5", "melsec.axis.U.master_axis_name=U"}},
        Example{"0023H", {"axes.U.number=5", "melsec.axis.U.master_axis_name=C"}},
        Example{"0023H", {"axes.A.type=linear", "melsec.axis.A.master_axis_name=X"}},
        Example{"0023H",
                {"axes.U.number=5", "axes.V.number=6", "melsec.axis.U.master_axis_name=X",
                 "melsec.axis.V.master_axis_name=U"}},
        Example{
            "0023H",
            {"axes.U.type=rotary", "melsec.axis.U.rotation_axis_type=1", "melsec.axis.U.master_axis_name=C"}},
        Example{
            "",
            {"axes.U.number=5", "melsec.axis.U.rotation_axis_type=1", "melsec.axis.U.master_axis_name=X"}}));

INSTANTIATE_TEST_SUITE_P(
    Limits, MelsecConfiguration,
    testing::Values(Example{"0024H", {"axes.X.limits=[1,0]"}}, Example{"0024H", {"axes.X.limits=[0,0]"}},
                    Example{"", {"axes.X.limits=[0,1]"}}, Example{"0024H", {"axes.C.limits=[0,360]"}},
                    Example{"0024H", {"axes.C.limits=[360,0]"}}, Example{"", {"axes.C.limits=[5,5]"}},
                    Example{"", {"axes.C.limits=[0,360]", "melsec.axis.C.rotation_axis_type=3"}},
                    Example{"0024H", {"axes.C.limits=[0,0]", "melsec.axis.C.rotation_axis_type=3"}},
                    Example{"", {"axes.C.type=linear"}}, Example{"", {"axes.X.type=rotary"}}));

TEST(MelsecParameters, SeveralErrorsAreTold) {
  EXPECT_EQ(codes_of(melsec_of(
                {"axes.X.number=1", "axes.Y.number=1", SYS "base_axis_j=X", SYS "polar_linear_axis=X"})),
            "0020H 0010H 0013H");
}

TEST(MelsecParameters, TheTextNamesCodeKeyAndRemedy) {
  EXPECT_EQ(text_of(melsec_of({SYS "common_all_points=10"})),
            "--set melsec.system.common_all_points: 30FDH/0016H Macro control setting error: "
            "'melsec.system.common_all_points' = 10, and the variables have no devices; set "
            "'melsec.system.common_all_start_device', for example to \"D2000\"");
  EXPECT_EQ(
      text_of(melsec_of({SYS "arc_deviation=0.1001"})),
      "--set melsec.system.arc_deviation=0.1001: 'melsec.system.arc_deviation' = 0.1001 is out of range; "
      "the range is 0.0001 to 0.1 mm");
  EXPECT_EQ(text_of(melsec_of({}, "[axes.X]\nlimits = [1, 1]\n")).substr(0, 60),
            "m.toml:2:10: 30FDH/0024H Software limit setting error: 'axes");
}

TEST(MelsecParameters, NamesOfTheManualLeadToTheSharedKeys) {
  EXPECT_EQ(
      text_of(melsec_of({"melsec.axis.Y.rapid_speed=5000"})),
      "--set melsec.axis.Y.rapid_speed=5000: 'melsec.axis.Y.rapid_speed' is a setting that every dialect "
      "has; set 'axes.Y.rapid'");
  EXPECT_EQ(
      text_of(melsec_of({}, "[melsec.work]\nwork_offset_x = 1\n")),
      "m.toml:2:1: 'melsec.work.work_offset_x' is a setting that every dialect has; set 'offsets.G54.X' "
      "and so on");
}

TEST(MelsecParameters, TheDefaultMachineIsGoodAndWritesItself) {
  const Schema schema = schema_of(*find_dialect("melsec"));
  EXPECT_EQ(schema_faults(schema), std::vector<std::string>{});
  EXPECT_EQ(text_of(melsec_of({}, init_text(schema, "melsec"))), "");
  const std::string shown = show_text(melsec_of({})->settings);
  EXPECT_NE(shown.find("[melsec.system]\n# Modal initial setting\ninitial_interpolation_mode"),
            std::string::npos);
  EXPECT_NE(shown.find("\n\n# Plane composition\nbase_axis_i "), std::string::npos);
}

TEST(MelsecParameters, LimitsThatAreLeftOutFollowTheTypeOfTheAxis) {
  const auto limits = [](const std::vector<std::string>& assignments, const char* key) {
    return melsec_of(assignments)->settings.pair(key);
  };
  EXPECT_EQ(limits({}, "axes.C.limits"), (std::array{0.0, 0.0}));
  EXPECT_EQ(limits({"melsec.axis.C.rotation_axis_type=3"}, "axes.C.limits"),
            (std::array{-9999.9999, 9999.9999}));
  EXPECT_EQ(limits({"axes.C.type=linear"}, "axes.C.limits"), (std::array{-9999.9999, 9999.9999}));
  EXPECT_EQ(limits({"axes.B.number=5"}, "axes.B.limits"), (std::array{0.0, 0.0}));
}

TEST(MelsecParameters, AShortFileTakesTheDefaultsOfTheRest) {
  const Made made = melsec_of({},
                              "[axes.X]\nnumber = 1\n[melsec.system]\ncommon_all_points = 0\n"
                              "common_system_points = 0\nbase_axis_j = 0\nbase_axis_k = 0\n");
  ASSERT_EQ(text_of(made), "");
  EXPECT_DOUBLE_EQ(made->settings.number(SYS "arc_deviation"), 0.01);
  EXPECT_DOUBLE_EQ(made->settings.number(SYS "corner_deceleration_angle"), 5.0);
  EXPECT_EQ(made->settings.text(SYS "g1_g1_deceleration_check"), "on");
}

TEST(MelsecParameters, ThreeAxesNeedNothingElse) {
  const Made made = melsec_of({}, "[axes.X]\nnumber = 1\n[axes.Y]\nnumber = 2\n[axes.Z]\nnumber = 3\n");
  ASSERT_EQ(text_of(made), "");
  AxisVector end;
  EXPECT_EQ(run(*made, "G91 G01 X1. Y1. Z1. F100.\n", &end), "");
  EXPECT_EQ(end[Axis::Z], 1.0);
}

TEST(MelsecParameters, FourAxesMoveTogether) {
  const Made made = melsec_of({}, "[axes.X]\n[axes.Y]\n[axes.Z]\n[axes.A]\n");
  ASSERT_EQ(text_of(made), "");
  EXPECT_EQ(made->machine.axes.size(), 4);
  AxisVector end;
  EXPECT_EQ(run(*made, "G91 G00 X1. Y1. Z1. A1.\n", &end), "");
  for (const Axis axis : made->machine.axes) EXPECT_EQ(end[axis], 1.0) << letter(axis);
}

TEST(MelsecParameters, ADefaultMachineMovesInIncrements) {
  AxisVector end;
  EXPECT_EQ(run(*melsec_of({"axes.X.start=50"}), "G00 X10.\n", &end), "");
  EXPECT_EQ(end[Axis::X], 60.0);
}

TEST(MelsecParameters, UnusedBaseAxesOfASmallLineAreNone) {
  const std::string two = "[axes.X]\nnumber = 1\n[axes.Y]\nnumber = 2\n";
  EXPECT_EQ(codes_of(melsec_of({}, two)), "0010H");
  EXPECT_EQ(codes_of(melsec_of({SYS "base_axis_k=0"}, two)), "");
}

TEST(MelsecParameters, TheDefaultBaseAxesAreWrongForOneAxis) {
  const std::string one = "[axes.X]\nnumber = 1\n";
  EXPECT_EQ(codes_of(melsec_of({}, one)), "0010H 0010H");
  EXPECT_EQ(codes_of(melsec_of({SYS "base_axis_j=0", SYS "base_axis_k=0"}, one)), "");
}

TEST(WordDevice, ReadsWhatHoldsVariables) {
  EXPECT_EQ(word_device("D2000")->number, 2000);
  EXPECT_EQ(word_device("W1FFE")->number, 0x1FFE);
  EXPECT_EQ(word_device("#100")->number, 100);
  EXPECT_EQ(word_device("U3E1\\G1000")->number, 1000);
  EXPECT_EQ(word_device("U3E1\\HG10")->kind, melsec::DeviceKind::fixed_buffer);
  for (const char* text : {"D2000", "W1FFE", "#100", "U3E1\\G1000", "U3E1\\HG10"}) {
    EXPECT_EQ(melsec::device_text(*word_device(text)), text);
  }
}

TEST(WordDevice, RefusesTheRest) {
  for (const char* text :
       {"", "D", "D-2", "D2.", "M100", "2000", "d2000", "U3E1\\", "U3E1\\HG", "U\\G1", "W1G"}) {
    EXPECT_EQ(word_device(text).error(), DeviceFault::no_word_device) << text;
  }
  EXPECT_EQ(word_device("U3E0\\G1").error(), DeviceFault::other_cpu);
  EXPECT_EQ(word_device("U10\\G1").error(), DeviceFault::module);
}

}  // namespace
}  // namespace kerf
