#pragma once
// The [melsec] section of the machine file: the G-code control parameters of chapter 4 of the manual.

#include <array>
#include <optional>
#include <span>

#include "base/axis.hpp"
#include "execute/macro_variables.hpp"
#include "execute/modal.hpp"
#include "execute/toolpath_policy.hpp"
#include "machine/parameter.hpp"
#include "machine/settings.hpp"

namespace kerf::melsec {

struct ControllerSettings {
  CodeNumber initial_motion = code(1);
  CodeNumber initial_plane = code(17);
  CodeNumber initial_distance = code(91);
  double arc_deviation = 0.01;              ///< mm
  double arc_center_compensation = 0.0;     ///< mm; below 0: none, 0: two least increments
  std::array<std::optional<Axis>, 3> base;  ///< I, J, K
  NormalLinePolicy normal_line;
  std::optional<Axis> polar_linear;  ///< axes of polar coordinate interpolation
  std::optional<Axis> polar_rotary;
  AxisSet endless;   ///< rotation axes of type 0 and 1
  AxisSet shortest;  ///< those of type 1: absolute values are reached the shorter way
  MacroVariableLayout variables;
  bool each_axis = false;             ///< G00 moves every axis by itself
  bool axis_tolerance = false;        ///< tolerable acceleration control for each axis
  bool rotation_takes_start = false;  ///< coordinate rotation type 1: the start point turns along
  bool keep_arguments = false;
  bool diameters = false;  ///< the amounts of the D numbers are diameters
};

std::span<const Parameter> parameters();
/// Keys that all dialects share, with the ranges and under the headings of the manual.
std::span<const Parameter> shared_parameters();
/// Shared keys of which the manual knows nothing.
std::span<const std::string_view> keys_not_shared();
std::span<const DefaultOverride> default_machine();
/// The details codes of values that single keys, shared ones too, cannot have.
std::span<const KeyAlarm> key_alarms();
/// The parameters of the manual that a shared key sets.
std::span<const SharedName> shared_names();
ControllerSettings controller_settings(const Settings& settings);
NormalLinePolicy normal_line_policy(const Settings& settings);
PolarPolicy polar_policy(const Settings& settings);

}  // namespace kerf::melsec
