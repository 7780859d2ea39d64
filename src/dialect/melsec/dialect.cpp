#include "dialect/melsec/dialect.hpp"

#include <fmt/format.h>

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/codes.hpp"
#include "dialect/melsec/compile.hpp"
#include "dialect/melsec/configuration.hpp"
#include "dialect/melsec/read_through.hpp"
#include "dialect/melsec/rules.hpp"
#include "dialect/melsec/settings.hpp"

namespace kerf::melsec {
namespace {

std::shared_ptr<const BlockRules> make_rules(const Settings& settings, const Machine& machine) {
  return std::make_shared<const Rules>(controller_settings(settings), machine);
}

void complete_machine(const Settings& settings, Machine& machine) {
  machine.motion.feed_of_all_axes = true;
  for (const Axis axis : machine.axes) {
    AxisSettings& own = machine.axis[index(axis)];
    AxisRates& accurate = own.other_rates[kHighAccuracyRates - 1];
    accurate.rapid = settings.number(expanded("melsec.axis.*.high_accuracy_rapid_speed", axis));
    accurate.max_feed = settings.number(expanded("melsec.axis.*.high_accuracy_cutting_clamp_speed", axis));
    own.master = axis_of(settings.text(expanded("melsec.axis.*.master_axis_name", axis)));
  }
}

FeedPolicy feed_policy(const Settings& settings) {
  FeedPolicy policy;
  const bool cancelled = settings.boolean("melsec.system.override_cancel_device");
  if (!cancelled) policy.feed_override = settings.number("melsec.system.cutting_override_device");
  policy.rapid_override = settings.number("melsec.system.rapid_override_device");
  return policy;
}

InterferenceCheck interference_check(std::string_view word) {
  if (word == "alarm") return InterferenceCheck::alarm;
  return word == "avoid" ? InterferenceCheck::avoid : InterferenceCheck::none;
}

ToolpathPolicy toolpath_policy(const Settings& settings) {
  ToolpathPolicy policy;
  const bool type_b = settings.text("melsec.work.tool_radius_compensation_type") == "B";
  policy.compensation.start_type = type_b ? StartType::B : StartType::A;
  policy.compensation.small_angle_deg = 0.0;
  policy.compensation.joint_gap_mm = settings.number("melsec.system.arc_deviation");
  policy.compensation.blocks_without_motion = 4;
  policy.compensation.type_b_beside = true;
  policy.compensation.joints_belong_to_next = true;
  policy.compensation.start_waits = true;
  policy.compensation.resumes_unjoined = true;
  policy.compensation.changes_in_force = true;
  policy.compensation.starts_at_rest = true;
  policy.compensation.stop_ends_look_ahead = true;
  policy.compensation.corner_arc_inside = true;
  policy.compensation.small_arcs_turn_over = true;
  policy.compensation.drops_whole_turns = true;
  policy.compensation.stops_before_fault = true;
  policy.compensation.interference = interference_check(settings.text("melsec.work.interference_check"));
  policy.compensation.interference_alarm = &alarm_kind("031EH");
  policy.compensation.start_with_arc = &alarm_kind("0315H");
  policy.compensation.end_with_arc = &alarm_kind("0315H");
  policy.compensation.inner_arc_radius = &alarm_kind("031EH");
  policy.compensation.no_crossover = &alarm_kind("031DH");
  policy.compensation.side_change = &alarm_kind("0306H");
  policy.compensation.corner_arc_outside = &alarm_kind("0306H");
  policy.corner_override = {settings.number("melsec.system.corner_override"),
                            settings.number("melsec.system.corner_override_max_angle"),
                            settings.number("melsec.system.corner_override_length")};
  policy.normal_line = normal_line_policy(settings);
  policy.polar = polar_policy(settings);
  policy.limits = {&alarm_kind("0221H"), false};
  return policy;
}

}  // namespace

Dialect dialect() {
  Dialect d;
  d.name = "melsec";
  d.title = "MELSEC iQ-R G-code control";
  d.file_extension = ".gcd";
  d.alarms = alarm_catalogue();
  d.codes = code_table();
  d.parameters = parameters();
  d.shared = shared_parameters();
  d.not_shared = keys_not_shared();
  d.highest_tool = kCompensations;
  d.defaults = default_machine();
  d.key_alarms = key_alarms();
  d.shared_names = shared_names();
  d.store_names = "O001.gcd to O256.gcd";
  d.file_names = [](std::int32_t number) { return std::vector{fmt::format("O{:03}.gcd", number)}; };
  d.is_stored = [](std::string_view file_name) { return stored_number(file_name).has_value(); };
  d.store_bytes = kLargestStore;
  d.store_over = &alarm_kind("0041H");
  d.complete = complete_limits;
  d.complete_machine = complete_machine;
  d.contradictions = contradictions;
  d.is_subprogram = is_subprogram;
  d.read_through = read_through;
  d.rules = make_rules;
  d.feed_policy = feed_policy;
  d.toolpath_policy = toolpath_policy;
  return d;
}

}  // namespace kerf::melsec
