#include "dialect/melsec/settings.hpp"

#include "execute/code_table.hpp"

namespace kerf::melsec {
namespace {

std::optional<Axis> axis_named(const std::string& name) {
  return name.size() == 1 ? axis_from_letter(name[0]) : std::nullopt;
}

}  // namespace

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
  c.keep_arguments = s.boolean("melsec.keep_arguments");
  return c;
}

}  // namespace kerf::melsec
