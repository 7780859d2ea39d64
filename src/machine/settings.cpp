#include "machine/settings.hpp"

#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <utility>

namespace kerf {
namespace {

[[noreturn]] void declaration_bug(std::string_view key, std::string_view what) {
  fmt::print(stderr, "bug: machine setting '{}': {}\n", key, what);
  std::abort();
}

std::string servo_number_key(Axis axis) {
  return expanded("axes.*.number", axis);
}

}  // namespace

Settings Settings::defaults(const Schema& schema) {
  Settings settings(schema);
  for (const auto& table : {schema.common, schema.dialect}) {
    for (const Parameter& parameter : table) {
      if (instance_of(parameter) == Instance::none) {
        settings.add_default(parameter, std::string(parameter.key));
      }
    }
  }
  for (const DefaultOverride& item : schema.defaults) {
    const KeyPath path = split_key(item.key);
    if (path.size() < 2) continue;
    const auto axis = axis_of(path[1]);
    const auto tool = tool_of(path[1]);
    if (path[0] == "axes" && axis) settings.add_axis(*axis);
    if (path[0] == "tools" && tool) settings.add_tool(*tool);
  }
  return settings;
}

template <class T>
const T& Settings::get(std::string_view key) const {
  const Setting* setting = find(key);
  if (!setting) declaration_bug(key, "no such key on this machine");
  const T* value = std::get_if<T>(&setting->value);
  if (!value) declaration_bug(key, "read as another type than declared");
  return *value;
}

bool Settings::boolean(std::string_view key) const {
  return get<bool>(key);
}

std::int64_t Settings::integer(std::string_view key) const {
  return get<std::int64_t>(key);
}

double Settings::number(std::string_view key) const {
  const Setting* setting = find(key);
  const bool is_integer = setting && std::holds_alternative<std::int64_t>(setting->value);
  return is_integer ? static_cast<double>(get<std::int64_t>(key)) : get<double>(key);
}

const std::string& Settings::text(std::string_view key) const {
  return get<std::string>(key);
}

std::array<double, 2> Settings::pair(std::string_view key) const {
  return get<std::array<double, 2>>(key);
}

const Setting* Settings::find(std::string_view key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}

std::vector<const Setting*> Settings::in_order() const {
  std::vector<const Setting*> all;
  all.reserve(values_.size());
  const auto add_instance_of = [&](const Parameter& parameter, std::string_view name) {
    all.push_back(find(expanded(parameter.key, name)));
  };
  for (const ParameterTable& table : tables_of(schema_)) {
    const auto add_table = [&](std::string_view name) {
      for (const Parameter* parameter : table.parameters) add_instance_of(*parameter, name);
    };
    if (table.header.find('*') == std::string_view::npos) {
      for (const Parameter* parameter : table.parameters) {
        if (instance_of(*parameter) == Instance::none) {
          add_instance_of(*parameter, {});
        } else {
          for (const Axis axis : axes_) add_instance_of(*parameter, std::string(1, letter(axis)));
        }
      }
    } else if (instance_of(*table.parameters.front()) == Instance::tool) {
      for (const std::int32_t number : tools_) add_table(std::to_string(number));
    } else {
      for (const Axis axis : axes_) add_table(std::string(1, letter(axis)));
    }
  }
  return all;
}

void Settings::add_axis(Axis axis) {
  if (axes_.contains(axis)) return;
  axes_.insert(axis);
  add_instance(Instance::axis, std::string(1, letter(axis)));
  number_axes();
}

void Settings::add_tool(std::int32_t number) {
  if (tools_.insert(number).second) add_instance(Instance::tool, std::to_string(number));
}

void Settings::replace_axes(AxisSet axes) {
  for (const Axis axis : axes_) remove_axis(axis);
  axes_ = {};
  for (const Axis axis : axes) add_axis(axis);
}

void Settings::assign(std::string_view key, Value value, ValueOrigin origin) {
  const auto found = values_.find(key);
  if (found == values_.end()) declaration_bug(key, "assigned, but no such key on this machine");
  found->second.value = std::move(value);
  found->second.origin = std::move(origin);
  if (key.starts_with("axes.") && key.ends_with(".number")) number_axes();
}

void Settings::add_instance(Instance kind, std::string_view name) {
  for (const auto& table : {schema_.common, schema_.dialect}) {
    for (const Parameter& parameter : table) {
      if (instance_of(parameter) == kind) add_default(parameter, expanded(parameter.key, name));
    }
  }
}

void Settings::add_default(const Parameter& parameter, const std::string& key) {
  auto value = value_from_text(parameter, key, default_text(schema_, parameter, key));
  if (!value) declaration_bug(key, value.error().message);
  values_.insert_or_assign(key, Setting{key, &parameter, *std::move(value), ValueOrigin{}});
}

void Settings::remove_axis(Axis axis) {
  const std::string name(1, letter(axis));
  for (const auto& table : {schema_.common, schema_.dialect}) {
    for (const Parameter& parameter : table) {
      if (instance_of(parameter) == Instance::axis) values_.erase(expanded(parameter.key, name));
    }
  }
}

/// Gives every axis without a servo number of its own the dialect's default one or, when another axis has
/// that, the lowest number left.
void Settings::number_axes() {
  std::set<std::int64_t> used;
  std::vector<Setting*> open;
  for (const Axis axis : axes_) {
    const auto found = values_.find(servo_number_key(axis));
    if (found == values_.end()) return;
    if (found->second.is_explicit()) {
      used.insert(std::get<std::int64_t>(found->second.value));
    } else {
      open.push_back(&found->second);
    }
  }
  for (Setting* setting : open) {
    const auto preset = value_from_text(*setting->parameter, setting->key,
                                        default_text(schema_, *setting->parameter, setting->key));
    std::int64_t number = preset ? std::get<std::int64_t>(*preset) : 1;
    if (used.count(number) != 0) {
      number = 1;
      while (used.count(number) != 0) ++number;
    }
    used.insert(number);
    setting->value = number;
  }
}

}  // namespace kerf
