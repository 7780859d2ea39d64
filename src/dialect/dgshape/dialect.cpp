#include "dialect/dgshape/dialect.hpp"

#include <fmt/format.h>

#include "dialect/dgshape/alarms.hpp"
#include "dialect/dgshape/codes.hpp"
#include "dialect/dgshape/rules.hpp"
#include "dialect/dgshape/settings.hpp"
#include "machine/contradictions.hpp"

namespace kerf::dgshape {
namespace {

std::shared_ptr<const BlockRules> make_rules(const Settings& settings, const Machine& machine) {
  return std::make_shared<const Rules>(controller_settings(settings), machine);
}

std::vector<SettingsError> contradictions(const Settings& settings) {
  std::vector<SettingsError> errors;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    if (settings.axes().contains(axis)) continue;
    errors.push_back({"axes", 0, 0, fmt::format("the machine has no axis {}", letter(axis)),
                      "a file with [axes.] tables describes all axes: X, Y and Z, and A when there is one"});
  }
  for (const auto& error : {wrong_order(settings, "dgshape.feed_min", "dgshape.feed_max"),
                            wrong_order(settings, "dgshape.spindle_min", "dgshape.spindle_max")}) {
    if (error) errors.push_back(*error);
  }
  return errors;
}

FeedPolicy feed_policy(const Settings& settings) {
  const ControllerSettings c = controller_settings(settings);
  return {c.feed_min, c.feed_max, c.feed_resolution, c.feed_override, c.rapid_override};
}

ToolpathPolicy toolpath_policy(const Settings& settings) {
  const ControllerSettings c = controller_settings(settings);
  ToolpathPolicy policy;
  policy.compensation.start_type = c.offset_type_b ? StartType::B : StartType::A;
  policy.compensation.joint_gap_mm = c.arc_tolerance;
  policy.compensation.start_with_arc = &alarm_kind("offset-start-arc");
  policy.compensation.end_with_arc = &alarm_kind("offset-end-arc");
  policy.compensation.inner_arc_radius = &alarm_kind("inner-arc-radius");
  policy.compensation.no_crossover = &alarm_kind("no-crossover");
  policy.compensation.side_change = &alarm_kind("offset-change");
  policy.compensation.corner_arc_outside = &alarm_kind("corner-arc");
  policy.limits = {&alarm_kind("over-travel"), c.clip_over_travel};
  return policy;
}

}  // namespace

namespace {

/// Nothing at all counts as well: a program that is still to be named.
bool begins_with_data_mark(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos || text[first] == '%';
}

}  // namespace

Dialect dialect() {
  Dialect d;
  d.name = "dgshape";
  d.title = "DGSHAPE NC code";
  d.alarms = alarm_catalogue();
  d.codes = code_table();
  d.parameters = parameters();
  d.defaults = default_machine();
  d.optional_stop_key = "dgshape.optional_stop";
  d.block_skip_key = "dgshape.block_skip";
  d.recognises = begins_with_data_mark;
  d.contradictions = contradictions;
  d.rules = make_rules;
  d.feed_policy = feed_policy;
  d.toolpath_policy = toolpath_policy;
  return d;
}

}  // namespace kerf::dgshape
