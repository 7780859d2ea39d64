#include <fmt/format.h>
#include <utility>

#include "machine/key_check.hpp"
#include "machine/settings_file.hpp"

namespace kerf {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The declaration of a full key that exists on this machine or whose axis or tool its own table may add.
tl::expected<const Parameter*, Complaint> find_parameter(const Settings& settings, const KeyPath& path) {
  KeyPath prefix;
  for (std::size_t i = 0; i < path.size(); ++i) {
    prefix.push_back(path[i]);
    const KeyStep step = follow(settings.schema(), prefix);
    const bool last = i + 1 == path.size();
    const bool found = step.kind == KeyStep::Kind::section || (last && step.kind == KeyStep::Kind::parameter);
    if (!found) return tl::unexpected(unknown_key(settings, path, i, step));
    const bool lacks_axis =
        step.instance == Instance::axis && !settings.axes().contains(*axis_of(path[i])) && path[0] != "axes";
    if (lacks_axis) {
      return tl::unexpected(missing_axis(
          settings, prefix, fmt::format("--set with any key of 'axes.{}' adds the axis", prefix.back())));
    }
    if (last && step.kind == KeyStep::Kind::parameter) return step.parameter;
  }
  return tl::unexpected(section_not_value(path));
}

/// The controller's own alarm for a value of this key that is out of range, or null.
const AlarmKind* alarm_for(const Settings& settings, const KeyPath& path, const Complaint& complaint) {
  const Parameter* parameter = follow(settings.schema(), path).parameter;
  return complaint.out_of_range && parameter ? alarm_of(settings.schema(), *parameter) : nullptr;
}

tl::expected<void, Complaint> assign(Settings& settings, const KeyPath& path, std::string_view text) {
  const auto parameter = find_parameter(settings, path);
  if (!parameter) return tl::unexpected(parameter.error());
  const std::string key = joined(path);
  auto value = value_from_text(**parameter, key, text);
  if (!value) return tl::unexpected(std::move(value.error()));
  if (key == "dialect" && *value != settings.find(key)->value) {
    return tl::unexpected(
        Complaint{"the dialect decides which settings there are", "use the option --dialect"});
  }
  if (path[0] == "axes") settings.add_axis(*axis_of(path[1]));
  if (instance_of(**parameter) == Instance::tool) settings.add_tool(*tool_of(path[1]));
  settings.assign(key, *std::move(value), {ValueOrigin::Kind::assignment, {}, 0, 0});
  return {};
}

}  // namespace

tl::expected<void, SettingsError> apply_assignment(Settings& settings, std::string_view key_equals_value) {
  const std::string option = "--set " + printable(key_equals_value);
  const std::size_t equals = key_equals_value.find('=');
  if (equals == std::string_view::npos) {
    return tl::unexpected(SettingsError{option, 0, 0, "no '='", "write --set KEY=VALUE"});
  }
  const KeyPath path = split_key(trimmed(key_equals_value.substr(0, equals)));
  if (auto done = assign(settings, path, key_equals_value.substr(equals + 1)); !done) {
    Complaint& complaint = done.error();
    SettingsError error{option, 0, 0, std::move(complaint.message), std::move(complaint.remedy)};
    if (const AlarmKind* kind = alarm_for(settings, path, complaint)) name_alarm(error, *kind);
    return tl::unexpected(std::move(error));
  }
  return {};
}

}  // namespace kerf
