#include "dialect/omron/dialect.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dialect/omron/alarms.hpp"
#include "dialect/omron/codes.hpp"
#include "dialect/omron/compile.hpp"
#include "dialect/omron/rules.hpp"
#include "dialect/omron/settings.hpp"
#include "dialect/omron/variables.hpp"
#include "machine/contradictions.hpp"

namespace kerf::omron {
namespace {

std::shared_ptr<const BlockRules> make_rules(const Settings& settings, const Machine& machine) {
  return std::make_shared<const Rules>(controller_settings(settings, machine), machine);
}

AxisRates extended_rates(const Settings& settings, std::size_t set, Axis axis) {
  const auto number = [&](std::string_view key) {
    return settings.number(expanded(extended_key(key, set), axis));
  };
  AxisRates rates;
  rates.rapid = number("omron.extended_#.axis.*.rapid");
  rates.acceleration = number("omron.extended_#.axis.*.maximum_acceleration");
  rates.rapid_acceleration = number("omron.extended_#.axis.*.rapid_acceleration");
  return rates;
}

/// Up to version 1.01 rapid positioning runs at the greatest velocity of each motor.
void complete_machine(const Settings& settings, Machine& machine) {
  for (const Axis axis : machine.axes) {
    AxisSettings& own = machine.axis[index(axis)];
    if (settings.text("omron.cnc_version") != "1.02") own.rapid = own.max_feed;
    own.rapid_acceleration = settings.number(expanded("omron.axis.*.rapid_acceleration", axis));
    own.other_rates[kSkipRates - 1].rapid = settings.number(expanded("omron.axis.*.skip_velocity", axis));
    for (std::size_t set = 0; set < kExtendedSets; ++set)
      own.other_rates[kExtendedRates - 1 + set] = extended_rates(settings, set, axis);
  }
}

/// A motor may have the signal of another one that has a signal of its own.
void check_skip_inputs(const Settings& settings, std::vector<SettingsError>& errors) {
  const auto key_of = [](Axis axis) { return expanded("omron.axis.*.skip_input", axis); };
  for (const Axis axis : settings.axes()) {
    const auto other = axis_of(settings.text(key_of(axis)));
    if (!other) continue;
    const bool exists = settings.axes().contains(*other);
    if (exists && !axis_of(settings.text(key_of(*other)))) continue;
    errors.push_back(error_at(
        *settings.find(key_of(axis)),
        exists ? fmt::format("the skip input of {} has no signal of its own to share", letter(*other))
               : fmt::format("the machine has no axis {} whose skip input could be shared", letter(*other)),
        "name an axis whose skip input is none, position or time"));
  }
}

/// An M code has one timing.
void check_timings(const Settings& settings, std::vector<SettingsError>& errors) {
  constexpr std::string_view kOther = "omron.not_waiting_m_codes";
  const auto first = numbers_in(settings.text("omron.immediate_m_codes"), 0, kMCodes - 1);
  const auto second = numbers_in(settings.text(kOther), 0, kMCodes - 1);
  if (!first || !second) return;
  for (const int code : *first) {
    if (std::find(second->begin(), second->end(), code) == second->end()) continue;
    errors.push_back(error_at(*settings.find(kOther),
                              fmt::format("M{} stands in 'omron.immediate_m_codes' too", code),
                              "keep it in one of the two lists"));
    return;
  }
}

std::vector<SettingsError> contradictions(const Settings& settings) {
  std::vector<SettingsError> errors;
  const auto check = [&](std::string_view key, int least, int greatest) {
    if (numbers_in(settings.text(key), least, greatest)) return;
    errors.push_back(error_at(*settings.find(key),
                              fmt::format("'{}' is no list of numbers from {} to {}", key, least, greatest),
                              "write numbers and ranges with blanks between them, for example \"1 3 5-7\""));
  };
  check("omron.block_skip", 1, 31);
  check("omron.immediate_m_codes", 0, kMCodes - 1);
  check("omron.not_waiting_m_codes", 0, kMCodes - 1);
  check_skip_inputs(settings, errors);
  check_timings(settings, errors);
  return errors;
}

ToolpathPolicy toolpath_policy(const Settings& settings) {
  ToolpathPolicy policy;
  constexpr std::size_t kFarAhead = 60;  // blocks without movement that the controller looks across
  const bool prevents = settings.text("omron.overcut_operation_mode") == "prevention";
  policy.compensation.start_type = StartType::A;
  policy.compensation.small_angle_deg = 0.0;
  policy.compensation.blocks_without_motion = policy.compensation.interference_blocks = kFarAhead;
  policy.compensation.rounds_acute = true;
  policy.compensation.feed_at_edge = settings.text("omron.compensated_feed") == "edge";
  policy.compensation.stops_before_fault = true;
  policy.compensation.interference = prevents ? InterferenceCheck::avoid : InterferenceCheck::alarm;
  policy.compensation.sees_contour_ahead = true;
  policy.compensation.interference_alarm = &alarm_kind("overcut");
  policy.compensation.start_with_arc = &alarm_kind("compensation-start");
  policy.compensation.end_with_arc = &alarm_kind("compensation-end");
  policy.compensation.inner_arc_radius = &alarm_kind("compensation-radius");
  policy.compensation.no_crossover = &alarm_kind("compensation-path");
  policy.compensation.side_change = &alarm_kind("compensation-word");
  policy.compensation.corner_arc_outside = &alarm_kind("syntax");
  policy.limits = {&alarm_kind("over-travel"), false};
  return policy;
}

/// 1000.nc, or P1000.nc.
std::vector<std::string> file_names(std::int32_t number) {
  return {fmt::format("{}.nc", number), fmt::format("P{}.nc", number)};
}

std::string to_intermediate_code(const Source& source, std::int32_t number, std::vector<Alarm>& alarms) {
  std::vector<ParseFault> faults;
  const std::int32_t program = number >= 0 ? number : number_in_name(source.name());
  std::string text = intermediate_code(source.text(), program, faults);
  for (const ParseFault& fault : faults)
    alarms.push_back({&alarm_kind(fault.detail), fault.span, fault.message, {}});
  return text;
}

constexpr Conversion kConversions[] = {
    {"pmc", "intermediate code of the CNC Operator", to_intermediate_code},
};

}  // namespace

Dialect dialect() {
  Dialect d;
  d.name = "omron";
  d.title = "OMRON NJ/NY NC Integrated Controller";
  d.alarms = alarm_catalogue();
  d.codes = code_table();
  d.parameters = parameters();
  d.not_shared = keys_not_shared();
  d.defaults = default_machine();
  d.optional_stop_key = "omron.optional_stop";
  d.block_skip_key = "omron.all_block_skips";
  d.block_skip_list_key = "omron.block_skip";
  d.file_names = file_names;
  d.variable_number = variable_named;
  d.conversions = kConversions;
  d.complete_machine = complete_machine;
  d.contradictions = contradictions;
  d.rules = make_rules;
  d.feed_policy = [](const Settings&) { return FeedPolicy{}; };
  d.toolpath_policy = toolpath_policy;
  return d;
}

}  // namespace kerf::omron
