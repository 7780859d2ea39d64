#include "dialect/melsec/settings.hpp"

#include "dialect/melsec/alarms.hpp"
#include "execute/code_table.hpp"

namespace kerf::melsec {

ControllerSettings controller_settings(const Settings& s) {
  ControllerSettings c;
  c.initial_motion = code_named(s.text("melsec.system.initial_interpolation_mode"));
  c.initial_plane = code_named(s.text("melsec.system.initial_plane"));
  c.initial_distance = code_named(s.text("melsec.system.initial_absolute_mode"));
  c.arc_deviation = s.number("melsec.system.arc_deviation");
  c.arc_center_compensation = s.number("melsec.system.arc_center_compensation");
  c.base = {axis_of(s.text("melsec.system.base_axis_i")), axis_of(s.text("melsec.system.base_axis_j")),
            axis_of(s.text("melsec.system.base_axis_k"))};
  c.normal_line = normal_line_policy(s);
  c.polar_linear = axis_of(s.text("melsec.system.polar_linear_axis"));
  c.polar_rotary = axis_of(s.text("melsec.system.polar_rotary_axis"));
  c.variables.common =
      s.integer("melsec.system.common_system_points") + s.integer("melsec.system.common_all_points");
  if (!s.text("melsec.system.local_start_device").empty()) c.variables.locals = 33;
  c.each_axis = s.text("melsec.system.g00_non_interpolation") == "each-axis";
  c.axis_tolerance = s.text("melsec.system.per_axis_tolerable_acceleration") == "each-axis";
  c.rotation_takes_start = s.text("melsec.work.coordinate_rotation_type") == "type-1";
  for (const Axis axis : s.axes()) {
    if (s.text(expanded("axes.*.type", axis)) != "rotary") continue;
    const std::string& type = s.text(expanded("melsec.axis.*.rotation_axis_type", axis));
    if (type != "linear") c.endless.insert(axis);
    if (type == "shortcut-valid") c.shortest.insert(axis);
  }
  c.diameters = s.text("melsec.work.radius_or_diameter") == "diameter";
  c.keep_arguments = s.boolean("melsec.keep_arguments");
  return c;
}

NormalLinePolicy normal_line_policy(const Settings& s) {
  NormalLinePolicy policy;
  policy.axis = axis_of(s.text("melsec.system.normal_line_axis"));
  policy.one_way = s.text("melsec.system.normal_line_type") == "II";
  policy.least_angle_deg = s.number("melsec.system.normal_line_min_angle");
  policy.least_way_mm = s.number("melsec.system.normal_line_min_move");
  policy.turning_speed = s.number("melsec.system.normal_line_rotating_speed");
  policy.tool_radius_mm = s.number("melsec.system.normal_line_radius");
  policy.insert_radius_mm = s.number("melsec.system.normal_line_insert_radius");
  policy.wrong_way = &alarm_kind("0103H");
  return policy;
}

PolarPolicy polar_policy(const Settings& s) {
  PolarPolicy policy;
  policy.rotary = axis_of(s.text("melsec.system.polar_rotary_axis"));
  if (policy.rotary) {
    policy.endless = s.text(expanded("melsec.axis.*.rotation_axis_type", *policy.rotary)) != "linear";
  }
  return policy;
}

}  // namespace kerf::melsec
