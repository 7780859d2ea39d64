#include "dialect/melsec/settings.hpp"

#include <limits>

#include "execute/code_table.hpp"

namespace kerf::melsec {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr auto kBoolean = ValueType::boolean;
constexpr auto kInteger = ValueType::integer;
constexpr auto kNumber = ValueType::number;
constexpr auto kText = ValueType::text;
constexpr auto kWord = ValueType::word;
constexpr std::string_view kAxisNames = "0=none|1=X|2=Y|3=Z|4=A|5=B|6=C|7=U|8=V|9=W";

constexpr Parameter kParameters[] = {
    {"melsec.system.initial_interpolation_mode", kWord, "\"G01\"", "", -kNoLimit, kNoLimit, "0=G01|1=G00",
     "Motion code in force after a reset."},
    {"melsec.system.initial_plane", kWord, "\"G17\"", "", -kNoLimit, kNoLimit, "1=G17|2=G18|3=G19",
     "Plane in force after a reset."},
    {"melsec.system.initial_absolute_mode", kWord, "\"G91\"", "", -kNoLimit, kNoLimit, "0=G91|1=G90",
     "Absolute or incremental values after a reset."},
    {"melsec.system.arc_deviation", kNumber, "0.01", "mm", 0.0001, 0.1, "",
     "Allowed difference between the radius at the start and at the end of an arc."},
    {"melsec.system.arc_center_compensation", kNumber, "0.0", "mm", -0.1, 0.01, "",
     "Up to this difference of chord and diameter the centre of an R arc moves to the middle of the chord; "
     "below 0: never, 0: 0.0002 mm."},
    {"melsec.system.base_axis_i", kWord, "\"X\"", "", -kNoLimit, kNoLimit, kAxisNames,
     "Axis of the centre word I, first axis of G17."},
    {"melsec.system.base_axis_j", kWord, "\"Y\"", "", -kNoLimit, kNoLimit, kAxisNames,
     "Axis of the centre word J, second axis of G17."},
    {"melsec.system.base_axis_k", kWord, "\"Z\"", "", -kNoLimit, kNoLimit, kAxisNames,
     "Axis of the centre word K, first axis of G18."},
    {"melsec.system.common_all_points", kInteger, "0", "points", 0, 900, "",
     "Common variables for all systems; their numbers follow those for each system."},
    {"melsec.system.common_system_points", kInteger, "0", "points", 0, 900, "",
     "Common variables for each system, from #100."},
    {"melsec.system.common_all_start_device", kText, "\"\"", "", -kNoLimit, kNoLimit, "",
     "First device of the common variables for all systems."},
    {"melsec.system.common_system_start_device", kText, "\"\"", "", -kNoLimit, kNoLimit, "",
     "First device of the common variables for each system."},
    {"melsec.system.local_start_device", kText, "\"\"", "", -kNoLimit, kNoLimit, "",
     "First device of the local variables; without it there are none."},
    {"melsec.system.per_axis_tolerable_acceleration", kInteger, "0", "", 0, 1, "",
     "1: high-accuracy control keeps the tolerable acceleration of each axis."},
    {"melsec.work.coordinate_rotation_type", kInteger, "0", "", 0, 1, "",
     "Start point of the first move behind G68: 0: where it is, 1: taken as turned along."},
    {"melsec.axis.*.rotation_axis_type", kInteger, "0", "", 0, 3, "",
     "0: turns without end, 1: the same and takes the shorter way, 3: positions run on like those of a "
     "linear axis."},
    {"melsec.keep_arguments", kBoolean, "false", "", -kNoLimit, kNoLimit, "",
     "The signal that lets local variables without an argument keep their values at G65 (Rq.3385)."},
};

constexpr DefaultOverride kDefaultMachine[] = {
    {"dialect", "\"melsec\""},      {"machine.name", "\"MELSEC machine\""},
    {"axes.X.number", "1"},         {"axes.Y.number", "2"},
    {"axes.Z.number", "3"},         {"axes.C.number", "4"},
    {"axes.C.type", "\"rotary\""},  {"axes.*.rapid", "20000.0"},
    {"axes.*.max_feed", "10000.0"},
};

std::optional<Axis> axis_named(const std::string& name) {
  return name.size() == 1 ? axis_from_letter(name[0]) : std::nullopt;
}

}  // namespace

std::span<const Parameter> parameters() {
  return kParameters;
}

std::span<const DefaultOverride> default_machine() {
  return kDefaultMachine;
}

ControllerSettings controller_settings(const Settings& s) {
  ControllerSettings c;
  c.initial_motion = code_named(s.text("melsec.system.initial_interpolation_mode"));
  c.initial_plane = code_named(s.text("melsec.system.initial_plane"));
  c.initial_distance = code_named(s.text("melsec.system.initial_absolute_mode"));
  c.arc_deviation = s.number("melsec.system.arc_deviation");
  c.arc_center_compensation = s.number("melsec.system.arc_center_compensation");
  c.base = {axis_named(s.text("melsec.system.base_axis_i")), axis_named(s.text("melsec.system.base_axis_j")),
            axis_named(s.text("melsec.system.base_axis_k"))};
  c.variables.common =
      s.integer("melsec.system.common_system_points") + s.integer("melsec.system.common_all_points");
  c.variables.locals = !s.text("melsec.system.local_start_device").empty();
  c.axis_tolerance = s.integer("melsec.system.per_axis_tolerable_acceleration") == 1;
  c.rotation_takes_start = s.integer("melsec.work.coordinate_rotation_type") == 1;
  for (const Axis axis : s.axes()) {
    if (s.text(expanded("axes.*.type", axis)) != "rotary") continue;
    const std::int64_t type = s.integer(expanded("melsec.axis.*.rotation_axis_type", axis));
    if (type <= 1) c.endless.insert(axis);
    if (type == 1) c.shortest.insert(axis);
  }
  c.keep_arguments = s.boolean("melsec.keep_arguments");
  return c;
}

void complete_machine(const Settings& settings, Machine& machine) {
  for (const Axis axis : controller_settings(settings).endless) machine.axis[index(axis)].endless = true;
}

}  // namespace kerf::melsec
