#include "machine/schema.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <set>

#include "machine/common_parameters.hpp"
#include "machine/value.hpp"

namespace kerf {
namespace {

constexpr std::string_view kBareKeyCharacters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";

/// Takes the first segment off a dotted key.
std::string_view take_segment(std::string_view& rest) {
  const std::string_view segment = rest.substr(0, rest.find('.'));
  rest.remove_prefix(std::min(rest.size(), segment.size() + 1));
  return segment;
}

/// What the path's last segment is according to one declaration.
KeyStep follow(const Parameter& parameter, const KeyPath& path) {
  std::string_view pattern = parameter.key;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (pattern.empty()) return {};
    const bool last = i + 1 == path.size();
    const std::string_view segment = take_segment(pattern);
    const Instance instance = segment == "*" ? instance_of(parameter) : Instance::none;
    if (instance == Instance::axis && !axis_of(path[i])) {
      return {last ? KeyStep::Kind::not_an_axis : KeyStep::Kind::unknown};
    }
    if (instance == Instance::tool && !tool_of(path[i])) {
      return {last ? KeyStep::Kind::not_a_tool : KeyStep::Kind::unknown};
    }
    if (instance == Instance::none && segment != path[i]) return {};
    if (last && pattern.empty()) return {KeyStep::Kind::parameter, &parameter, instance};
    if (last) return {KeyStep::Kind::section, nullptr, instance};
  }
  return {};
}

std::string_view table_header(std::string_view key) {
  std::string_view header = key.substr(0, key.rfind('.') == std::string_view::npos ? 0 : key.rfind('.'));
  if (key.ends_with(".*")) header = header.substr(0, header.rfind('.'));
  return header;
}

template <class Visit>
void for_each_parameter(const Schema& schema, Visit visit) {
  for (const Parameter& parameter : schema.common) visit(parameter);
  for (const Parameter& parameter : schema.dialect) visit(parameter);
}

}  // namespace

KeyStep follow(const Schema& schema, const KeyPath& path) {
  // A declared word wins over a wildcard that refuses it, so the best answer of all declarations counts.
  const auto rank = [](KeyStep::Kind kind) {
    switch (kind) {
      case KeyStep::Kind::parameter:
        return 3;
      case KeyStep::Kind::section:
        return 2;
      case KeyStep::Kind::not_an_axis:
      case KeyStep::Kind::not_a_tool:
        return 1;
      case KeyStep::Kind::unknown:
        return 0;
    }
    return 0;
  };
  KeyStep best;
  for_each_parameter(schema, [&](const Parameter& parameter) {
    const KeyStep step = follow(parameter, path);
    if (rank(step.kind) > rank(best.kind)) best = step;
  });
  if (best.instance == Instance::tool && tool_of(path.back()).value_or(0) > schema.highest_tool)
    return {KeyStep::Kind::not_a_tool};
  return best;
}

std::optional<Axis> axis_of(std::string_view segment) {
  return segment.size() == 1 ? axis_from_letter(segment[0]) : std::nullopt;
}

std::optional<std::int32_t> tool_of(std::string_view segment) {
  std::int32_t number = 0;
  const auto [end, error] = std::from_chars(segment.data(), segment.data() + segment.size(), number);
  const bool whole = error == std::errc{} && end == segment.data() + segment.size();
  if (!whole || segment[0] == '0' || number < 1 || number > kHighestToolNumber) return std::nullopt;
  return number;
}

Instance instance_of(const Parameter& parameter) {
  if (parameter.key.find('*') == std::string_view::npos) return Instance::none;
  return parameter.key.starts_with("tools.*") ? Instance::tool : Instance::axis;
}

std::string expanded(std::string_view key, std::string_view instance) {
  std::string text(key);
  if (const std::size_t star = text.find('*'); star != std::string::npos) text.replace(star, 1, instance);
  return text;
}

std::string expanded(std::string_view key, Axis axis) {
  const char name = letter(axis);
  return expanded(key, std::string_view(&name, 1));
}

KeyPath split_key(std::string_view key) {
  KeyPath path;
  for (;;) {
    const std::size_t dot = key.find('.');
    path.emplace_back(key.substr(0, dot));
    if (dot == std::string_view::npos) return path;
    key.remove_prefix(dot + 1);
  }
}

std::string joined(const KeyPath& path) {
  std::string text;
  for (const std::string& segment : path) {
    if (!text.empty()) text += '.';
    const bool bare = !segment.empty() && segment.find_first_not_of(kBareKeyCharacters) == std::string::npos;
    text += bare ? segment : fmt::format("\"{}\"", printable(segment));
  }
  return printable(text);
}

std::vector<ParameterTable> tables_of(const Schema& schema) {
  std::vector<ParameterTable> tables;
  for_each_parameter(schema, [&](const Parameter& parameter) {
    const std::string_view header = table_header(parameter.key);
    auto table = std::find_if(tables.begin(), tables.end(),
                              [&](const ParameterTable& known) { return known.header == header; });
    if (table == tables.end()) table = tables.insert(tables.end(), ParameterTable{header, {}});
    table->parameters.push_back(&parameter);
  });
  return tables;
}

std::string_view name_in_table(const Parameter& parameter) {
  std::string_view key = parameter.key;
  if (key.ends_with(".*")) key.remove_suffix(2);
  return key.substr(key.rfind('.') + 1);
}

std::string_view default_text(const Schema& schema, const Parameter& parameter, std::string_view key) {
  const auto find = [](std::span<const DefaultOverride> overrides, std::string_view wanted) {
    return std::find_if(overrides.begin(), overrides.end(),
                        [&](const DefaultOverride& item) { return item.key == wanted; });
  };
  for (const std::string_view wanted : {key, parameter.key}) {
    const auto found = find(schema.defaults, wanted);
    if (found != schema.defaults.end()) return found->value;
  }
  const std::span<const DefaultOverride> shared = common_defaults();
  const auto found = find(shared, key);
  return found != shared.end() ? found->value : parameter.default_value;
}

const AlarmKind* alarm_of(const Schema& schema, const Parameter& parameter) {
  const auto found = std::find_if(schema.alarms.begin(), schema.alarms.end(),
                                  [&](const KeyAlarm& item) { return item.key == parameter.key; });
  return found == schema.alarms.end() ? nullptr : found->kind;
}

std::vector<std::string> schema_faults(const Schema& schema) {
  std::vector<std::string> faults;
  std::set<std::string_view> keys;
  const auto check_default = [&](const Parameter& parameter, std::string_view key, std::string_view value) {
    const auto read = value_from_text(parameter, key, value);
    if (!read) faults.push_back(fmt::format("default of {}: {}", key, read.error().message));
  };
  for_each_parameter(schema, [&](const Parameter& parameter) {
    if (!keys.insert(parameter.key).second)
      faults.push_back(fmt::format("{} is declared twice", parameter.key));
    if (parameter.help.empty()) faults.push_back(fmt::format("{} has no help", parameter.key));
    if ((parameter.type == ValueType::word) == parameter.choices.empty()) {
      faults.push_back(fmt::format("{}: choices go with words", parameter.key));
    }
    check_default(parameter, parameter.key, parameter.default_value);
  });
  for (const DefaultOverride& item : schema.defaults) {
    const auto exact = [&](const Parameter& parameter) { return parameter.key == item.key; };
    const KeyStep step = follow(schema, split_key(item.key));
    const Parameter* parameter = step.parameter;
    for (const std::span<const Parameter> table : {schema.common, schema.dialect}) {
      const auto found = std::find_if(table.begin(), table.end(), exact);
      if (found != table.end()) parameter = &*found;
    }
    if (parameter) {
      check_default(*parameter, item.key, item.value);
    } else {
      faults.push_back(fmt::format("override of {}: no such key", item.key));
    }
  }
  return faults;
}

}  // namespace kerf
