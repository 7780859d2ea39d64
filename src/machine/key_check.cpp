#include "machine/key_check.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "machine/nearest_key.hpp"

namespace kerf {
namespace {

std::string axis_letters(AxisSet axes) {
  std::string text;
  for (const Axis axis : axes) {
    if (!text.empty()) text += ' ';
    text += letter(axis);
  }
  return text;
}

constexpr AxisSet kAllAxes{Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C, Axis::U, Axis::V, Axis::W};

/// What to write for a name of the manual that stands for a shared key.
std::optional<std::string> shared_key(const Schema& schema, const KeyPath& path) {
  for (const SharedName& name : schema.shared_names) {
    const KeyPath pattern = split_key(name.key);
    std::string instance;
    bool same = pattern.size() == path.size();
    for (std::size_t i = 0; same && i < path.size(); ++i) {
      if (pattern[i] == "*") instance = path[i];
      same = pattern[i] == "*" || pattern[i] == path[i];
    }
    if (same) return expanded(name.remedy, instance);
  }
  return std::nullopt;
}

std::string suggestion(const Settings& settings, const KeyPath& path, std::size_t fault) {
  if (const auto nearest = nearest_key(settings.schema(), settings.axes(), path, fault)) {
    return fmt::format("did you mean '{}'?", *nearest);
  }
  constexpr std::size_t kLongestList = 160;
  const std::string names = names_beside(settings.schema(), path, fault);
  return names.empty() || names.size() > kLongestList ? std::string() : "known here: " + names;
}

}  // namespace

Complaint unknown_key(const Settings& settings, const KeyPath& path, std::size_t fault, const KeyStep& step) {
  const std::string segment = printable(path[fault]);
  if (step.kind == KeyStep::Kind::not_an_axis) {
    if (const auto axis =
            axis_from_letter(path[fault].size() == 1 ? static_cast<char>(path[fault][0] & ~0x20) : '-')) {
      KeyPath meant = path;
      meant[fault] = letter(*axis);
      return {fmt::format("'{}' in '{}' is no axis", segment, joined(path)),
              fmt::format("did you mean '{}'?", joined(meant))};
    }
    return {fmt::format("'{}' in '{}' is no axis", segment, joined(path)),
            fmt::format("axes are {}", axis_letters(kAllAxes))};
  }
  if (step.kind == KeyStep::Kind::not_a_tool) {
    const bool zero = !segment.empty() && segment.find_first_not_of('0') == std::string::npos;
    if (zero) {
      return {"tool number 0 cannot be set", "compensation number 0 is always 0; number tools from 1"};
    }
    return {fmt::format("'{}' in '{}' is no tool number", segment, joined(path)),
            fmt::format("tool numbers are 1 to {}, without leading zeros", settings.schema().highest_tool)};
  }
  const auto& foreign = settings.schema().foreign_sections;
  if (std::find(foreign.begin(), foreign.end(), path[0]) != foreign.end()) {
    return {fmt::format("'{}' is a setting of another dialect", joined(path)), "leave it out"};
  }
  if (auto remedy = shared_key(settings.schema(), path)) {
    return {fmt::format("'{}' is a setting that every dialect has", joined(path)), *std::move(remedy)};
  }
  return {fmt::format("unknown key '{}'", joined(path)), suggestion(settings, path, fault)};
}

Complaint missing_axis(const Settings& settings, const KeyPath& path, std::string_view remedy) {
  return {fmt::format("'{}': the machine has no axis {}", joined(path), path.back()),
          fmt::format("its axes are {}; {}", axis_letters(settings.axes()), remedy)};
}

Complaint section_not_value(const KeyPath& path) {
  return {fmt::format("'{}' is a section and has no value of its own", joined(path)), "set one of its keys"};
}

std::optional<Complaint> unknown_dialect(const Settings& settings, const std::string& name) {
  const Setting* current = settings.find("dialect");
  const std::string* own = current ? std::get_if<std::string>(&current->value) : nullptr;
  if (!own || own->empty() || *own == name) return std::nullopt;
  std::string names = *own;
  for (const std::string_view other : settings.schema().foreign_sections) {
    if (other == name) return std::nullopt;
    names += fmt::format(", {}", other);
  }
  return Complaint{fmt::format("unknown dialect '{}'", printable(name)), "dialects are " + names};
}

}  // namespace kerf
