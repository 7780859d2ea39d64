// The declarations of the [melsec] section, in the order and under the headings of the manual's chapter 4.

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/settings.hpp"

namespace kerf::melsec {
namespace {

constexpr std::string_view kModal = "Modal initial setting";
constexpr std::string_view kControl = "Control setting";
constexpr std::string_view kOverride = "Override setting";
constexpr std::string_view kPlane = "Plane composition";
constexpr std::string_view kNormalLine = "Normal line control";
constexpr std::string_view kAuxiliary = "Auxiliary function";
constexpr std::string_view kPolar = "Polar coordinate interpolation";
constexpr std::string_view kAccuracy = "High-accuracy control";
constexpr std::string_view kMacro = "Macro control";
constexpr std::string_view kTimeConstant = "Speed/time constant";
constexpr std::string_view kRotary = "Rotation axis information";
constexpr std::string_view kTandem = "Tandem function";
constexpr std::string_view kToolRadius = "Tool radius compensation";
constexpr std::string_view kRotation = "Program coordinate rotation";

constexpr std::string_view kAxisNames = "0=none|1=X|2=Y|3=Z|4=A|5=B|6=C|7=U|8=V|9=W";
constexpr double kLongest = 9999.9999;      // mm, eight digits of the least increment
constexpr double kFastestRapid = 1000000;   // mm/min
constexpr double kFastestCutting = 999999;  // mm/min

struct Range {
  double low;
  double high;
};

constexpr Parameter word(std::string_view group, std::string_view key, std::string_view default_value,
                         std::string_view choices, std::string_view help) {
  return {.key = key,
          .type = ValueType::word,
          .default_value = default_value,
          .choices = choices,
          .help = help,
          .group = group};
}

constexpr Parameter axis_name(std::string_view group, std::string_view key, std::string_view default_value,
                              std::string_view help) {
  return word(group, key, default_value, kAxisNames, help);
}

constexpr Parameter number(std::string_view group, std::string_view key, std::string_view default_value,
                           std::string_view unit, Range range, std::string_view help) {
  return {.key = key,
          .type = ValueType::number,
          .default_value = default_value,
          .unit = unit,
          .minimum = range.low,
          .maximum = range.high,
          .help = help,
          .group = group};
}

constexpr Parameter integer(std::string_view group, std::string_view key, std::string_view default_value,
                            std::string_view unit, Range range, std::string_view help) {
  Parameter parameter = number(group, key, default_value, unit, range, help);
  parameter.type = ValueType::integer;
  return parameter;
}

constexpr Parameter boolean(std::string_view group, std::string_view key, std::string_view help) {
  return {.key = key, .type = ValueType::boolean, .default_value = "false", .help = help, .group = group};
}

constexpr Parameter device(std::string_view key, std::string_view help) {
  return {.key = key, .type = ValueType::text, .default_value = "\"\"", .help = help, .group = kMacro};
}

constexpr Parameter kParameters[] = {
    // 4.1 System parameters
    word(kModal, "melsec.system.initial_interpolation_mode", "\"G01\"", "0=G01|1=G00",
         "Motion code in force after a reset."),
    word(kModal, "melsec.system.initial_plane", "\"G17\"", "0=G17|1=G17|2=G18|3=G19",
         "Plane in force after a reset."),
    word(kModal, "melsec.system.initial_absolute_mode", "\"G91\"", "0=G91|1=G90",
         "Absolute or incremental values after a reset."),

    word(kControl, "melsec.system.g00_non_interpolation", "\"line\"", "0=line|1=each-axis",
         "Path of G00: straight to the end, or each axis as fast as it can."),
    word(kControl, "melsec.system.deceleration_check", "\"0000H\"",
         "0=0000H|1=0001H|2=0002H|16=0010H|17=0011H|18=0012H|32=0020H|33=0021H|34=0022H",
         "When a block is complete, last digit G00, the one before G01 to G03:\n"
         "0 command deceleration, 1 smoothing, 2 in-position."),
    word(kControl, "melsec.system.g1_g1_deceleration_check", "\"on\"", "0=off|1=on",
         "Deceleration check where an axis turns round between two G01 blocks."),
    number(kControl, "melsec.system.arc_deviation", "0.01", "mm", {0.0001, 0.1},
           "Allowed difference between the radius at the start and at the end of an arc."),
    number(kControl, "melsec.system.arc_center_compensation", "0.0", "mm", {-0.1, 0.01},
           "Up to this difference of chord and diameter the centre of an R arc moves to the middle of the "
           "chord;\nbelow 0: never, 0: 0.0002 mm."),

    number(kOverride, "melsec.system.corner_override", "0.0", "percent", {0, 100},
           "Feed before an inside corner under G62; 0 or 100: unchanged."),
    number(kOverride, "melsec.system.corner_override_max_angle", "0.0", "degree", {0, 180},
           "Largest angle of a corner that G62 slows down for; 0 or 180: none."),
    number(kOverride, "melsec.system.corner_override_length", "0.0", "mm", {0, kLongest},
           "How long before a corner G62 slows down; 0: not at all."),
    integer(kOverride, "melsec.system.rapid_override_device", "100", "percent", {0, 100},
            "What the device of the fast forward override holds."),
    integer(kOverride, "melsec.system.cutting_override_device", "100", "percent", {0, 327},
            "What the device of the cutting feed override holds."),
    boolean(kOverride, "melsec.system.override_cancel_device",
            "Whether the device of the override cancel is on: the cutting feed override is 100."),

    axis_name(kPlane, "melsec.system.base_axis_i", "\"X\"", "Axis of the centre word I, first axis of G17."),
    axis_name(kPlane, "melsec.system.base_axis_j", "\"Y\"", "Axis of the centre word J, second axis of G17."),
    axis_name(kPlane, "melsec.system.base_axis_k", "\"Z\"", "Axis of the centre word K, first axis of G18."),

    axis_name(kNormalLine, "melsec.system.normal_line_axis", "\"none\"",
              "Rotary axis that keeps the tool square to the path."),
    word(kNormalLine, "melsec.system.normal_line_type", "\"I\"", "0=I|1=II",
         "I: turns the shorter way at a joint, II: turns as G41.1 or G42.1 says."),
    number(kNormalLine, "melsec.system.normal_line_min_angle", "0.0", "degree", {0, 360},
           "Smallest turn at a joint."),
    number(kNormalLine, "melsec.system.normal_line_rotating_speed", "2000.0", "degree/min", {1, 100000},
           "Speed of the turn at a joint, type I."),
    number(kNormalLine, "melsec.system.normal_line_min_move", "0.0", "mm", {0, kLongest},
           "A shorter block does not turn the axis at the joint before it."),
    number(kNormalLine, "melsec.system.normal_line_radius", "0.0", "mm", {0, kLongest},
           "From the centre of the axis to the tip of the tool, type II."),
    number(kNormalLine, "melsec.system.normal_line_insert_radius", "0.0", "mm", {0, kLongest},
           "Radius of the arc put into a corner, type I."),

    word(kAuxiliary, "melsec.system.m_binary", "\"BCD\"", "0=BCD|1=unsigned|-1=signed",
         "How M codes are put out."),

    axis_name(kPolar, "melsec.system.polar_linear_axis", "\"none\"",
              "Linear axis of G12.1, one of the base axes."),
    axis_name(kPolar, "melsec.system.polar_rotary_axis", "\"none\"", "Rotary axis of G12.1."),

    number(kAccuracy, "melsec.system.pre_accel_max_speed", "2000.0", "mm/min", {1, kFastestCutting},
           "Speed reached in the time constant before interpolation; no axis may cut faster."),
    number(kAccuracy, "melsec.system.pre_accel_time_constant", "100.0", "ms", {1, 5000},
           "Time constant of the acceleration before interpolation."),
    word(kAccuracy, "melsec.system.per_axis_tolerable_acceleration", "\"common\"", "0=common|1=each-axis",
         "Acceleration that bounds the speed at corners: one for all axes, or each axis its own."),
    number(kAccuracy, "melsec.system.corner_deceleration_angle", "5.0", "degree", {1, 89},
           "A joint that turns further is a corner."),
    number(kAccuracy, "melsec.system.corner_accuracy_coefficient", "0.0", "percent", {-1000, 99},
           "Higher: sharper corners, taken more slowly."),
    number(kAccuracy, "melsec.system.curve_accuracy_coefficient", "0.0", "percent", {-1000, 99},
           "Higher: arcs nearer to their radius, taken more slowly."),
    word(kAccuracy, "melsec.system.arc_deceleration_enable", "\"off\"", "0=off|1=on",
         "Slow down where an arc begins and ends."),
    number(kAccuracy, "melsec.system.arc_deceleration_speed", "1.0", "mm/min", {1, kFastestCutting},
           "Speed where an arc begins and ends."),

    integer(kMacro, "melsec.system.common_all_points", "0", "points", {0, 900},
            "Common variables for all systems; their numbers follow those for each system."),
    integer(kMacro, "melsec.system.common_system_points", "0", "points", {0, 900},
            "Common variables for each system, from #100."),
    device("melsec.system.common_all_start_device",
           "First device of the common variables for all systems, such as D6000; 4 words a variable."),
    device("melsec.system.common_system_start_device",
           "First device of the common variables for each system; 4 words a variable."),
    device("melsec.system.local_start_device",
           "First device of the local variables, 660 words; without it there are none."),

    // 4.2 Axis parameters
    number(kTimeConstant, "melsec.axis.*.g0_time_constant", "1000.0", "ms", {1, 4000},
           "Time from standstill to the speed of a G00."),
    number(kTimeConstant, "melsec.axis.*.g1_time_constant", "1000.0", "ms", {1, 4000},
           "Time from standstill to the cutting feed."),
    word(kRotary, "melsec.axis.*.rotation_axis_type", "\"shortcut-invalid\"",
         "0=shortcut-invalid|1=shortcut-valid|3=linear",
         "How a rotary axis counts: by the turn, by the turn and the shorter way, or as a linear axis."),
    axis_name(kTandem, "melsec.axis.*.master_axis_name", "\"none\"",
              "The axis that this one, U, V or W, moves along with."),
    number(kAccuracy, "melsec.axis.*.high_accuracy_rapid_speed", "0.0", "mm/min", {0, kFastestRapid},
           "Rapid speed in high-accuracy control; 0: the rapid of the axis."),
    number(kAccuracy, "melsec.axis.*.high_accuracy_cutting_clamp_speed", "0.0", "mm/min",
           {0, kFastestCutting},
           "Highest cutting speed in high-accuracy control; 0: the max_feed of the axis."),
    number(kAccuracy, "melsec.axis.*.axis_pre_accel_max_speed", "0.0", "mm/min", {0, kFastestCutting},
           "Speed of the acceleration of this axis at corners; 0: the rapid of the axis."),
    number(kAccuracy, "melsec.axis.*.axis_pre_accel_time_constant", "0.0", "ms", {0, 5000},
           "Time of the acceleration of this axis at corners; 0: g0_time_constant."),
    number(kAccuracy, "melsec.axis.*.axis_accuracy_coefficient", "0.0", "percent", {-1000, 99},
           "Higher: this axis takes corners more slowly."),

    // 4.3 Work parameters
    word(kToolRadius, "melsec.work.tool_radius_compensation_type", "\"A\"", "0=A|1=B",
         "How compensation starts and ends: at right angles, or at the intersection with the next block."),
    word(kToolRadius, "melsec.work.interference_check", "\"alarm\"", "0=alarm|1=invalid|2=avoid",
         "Where the tool would cut into the contour: alarm, no check, or another path."),
    word(kToolRadius, "melsec.work.radius_or_diameter", "\"radius\"", "0=radius|1=diameter",
         "What the compensation amounts in [tools] are."),
    word(kRotation, "melsec.work.coordinate_rotation_type", "\"type-0\"", "0=type-0|1=type-1",
         "First move after G68: from where the axes stand, or as if the start had turned as well."),

    // A signal of chapter 3 that programs depend on.
    boolean({}, "melsec.keep_arguments",
            "The signal that lets local variables without an argument keep their values at G65 (Rq.3385)."),
};

// The manual's defaults, with the speeds and time constants of a small machining centre. No axis may cut
// faster than pre_accel_max_speed (0015H), and the limits of an axis that turns without end are equal
// (0024H).
constexpr DefaultOverride kDefaultMachine[] = {
    {"dialect", "\"melsec\""},
    {"machine.name", "\"MELSEC machine\""},
    {"axes.X.number", "1"},
    {"axes.Y.number", "2"},
    {"axes.Z.number", "3"},
    {"axes.C.number", "4"},
    {"axes.C.type", "\"rotary\""},
    {"axes.C.limits", "[0.0, 0.0]"},
    {"axes.*.rapid", "20000.0"},
    {"axes.*.max_feed", "10000.0"},
    {"melsec.system.pre_accel_max_speed", "10000.0"},
    {"melsec.axis.*.g0_time_constant", "100.0"},
    {"melsec.axis.*.g1_time_constant", "100.0"},
};

constexpr SharedName kSharedNames[] = {
    {"melsec.system.number_of_axes_on_line", "give each axis of the line a table such as [axes.X]"},
    {"melsec.axis.*.axis_number", "set 'axes.*.number'"},
    {"melsec.axis.*.axis_name", "the name of the table [axes.*] names the axis"},
    {"melsec.axis.*.rotation_axis", "set 'axes.*.type' to \"linear\" or \"rotary\""},
    {"melsec.axis.*.software_limit_minus", "set 'axes.*.limits' to [low, high]"},
    {"melsec.axis.*.software_limit_plus", "set 'axes.*.limits' to [low, high]"},
    {"melsec.axis.*.rapid_speed", "set 'axes.*.rapid'"},
    {"melsec.axis.*.cutting_clamp_speed", "set 'axes.*.max_feed'"},
    {"melsec.work.tool_radius_amount", "set 'tools.1.radius' and so on"},
    {"melsec.work.tool_length_amount", "set 'tools.1.length' and so on"},
    {"melsec.work.work_offset_x", "set 'offsets.G54.X' and so on"},
    {"melsec.work.work_offset_y", "set 'offsets.G54.Y' and so on"},
    {"melsec.work.work_offset_z", "set 'offsets.G54.Z' and so on"},
    {"melsec.work.work_offset_a", "set 'offsets.G54.A' and so on"},
    {"melsec.work.work_offset_b", "set 'offsets.G54.B' and so on"},
    {"melsec.work.work_offset_c", "set 'offsets.G54.C' and so on"},
    {"melsec.work.work_offset_u", "set 'offsets.G54.U' and so on"},
    {"melsec.work.work_offset_v", "set 'offsets.G54.V' and so on"},
    {"melsec.work.work_offset_w", "set 'offsets.G54.W' and so on"},
};

}  // namespace

std::span<const Parameter> parameters() {
  return kParameters;
}

std::span<const DefaultOverride> default_machine() {
  return kDefaultMachine;
}

std::span<const SharedName> shared_names() {
  return kSharedNames;
}

std::span<const KeyAlarm> key_alarms() {
  static const KeyAlarm kAlarms[] = {
      {"axes.*.number", &alarm_kind("0020H")},
      {"axes.*.limits", &alarm_kind("0024H")},
      {"axes.*.start", &alarm_kind("0101H")},
      {"melsec.system.common_all_points", &alarm_kind("0016H")},
      {"melsec.system.common_system_points", &alarm_kind("0016H")},
  };
  return kAlarms;
}

}  // namespace kerf::melsec
