#include "machine/machine_text.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <utility>
#include <vector>

namespace kerf {
namespace {

constexpr std::size_t kLineWidth = 100;

struct Heading {
  std::string_view table;
  std::string_view text;  ///< lines of a comment
};

constexpr std::array kHeadings{
    Heading{"machine", "The machine as a whole."},
    Heading{"axes.*",
            "One table an axis: X Y Z A B C U V W. A file with any of these tables lists all axes of the\n"
            "machine. Rotary axes have degree wherever mm stands."},
    Heading{"offsets", "Work coordinate systems. Axes that are left out are 0."},
    Heading{"motion", "Planning and simulation of the motion."},
};

std::string heading_of(std::string_view header, const Schema& schema, std::string_view dialect_name) {
  if (header == "tools.*") {
    return fmt::format("Tools, by tool or compensation number (1 to {}; number 0 is always 0).",
                       schema.highest_tool);
  }
  for (const Heading& heading : kHeadings) {
    if (heading.table == header) return std::string(heading.text);
  }
  const bool by_axis = header.find('*') != std::string_view::npos;
  return fmt::format("Settings of {} alone{}.", dialect_name.empty() ? "this controller" : dialect_name,
                     by_axis ? ", one table an axis" : "");
}

bool has_wildcard(std::string_view header) {
  return header.find('*') != std::string_view::npos;
}

/// `0.05 to 100 ms; default 1.0`
std::string facts(const Parameter& parameter, std::string_view default_value) {
  std::string text = range_text(parameter);
  if (!parameter.unit.empty()) {
    text += fmt::format("{}{}", text.empty() ? "" : " ", parameter.unit);
  } else if (text.empty() && parameter.type == ValueType::boolean) {
    text = "true or false";
  }
  return fmt::format("{}{}default {}", text, text.empty() ? "" : "; ", default_value);
}

void add_comment(std::string& out, std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    out += fmt::format("# {}\n", line);
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
}

/// The meaning of a key and its facts, on one line where they fit. `name` is given for the keys of inline
/// tables.
void add_key_comment(std::string& out, const Parameter& parameter, std::string_view default_value,
                     std::string_view name = {}) {
  const std::string what =
      name.empty() ? std::string(parameter.help) : fmt::format("{}: {}", name, parameter.help);
  const std::string fact = facts(parameter, default_value);
  const bool one_line = what.size() + fact.size() + 5 <= kLineWidth;
  add_comment(out, fmt::format("{}{}({})", what, one_line ? " " : "\n  ", fact));
}

std::size_t longest_name(const ParameterTable& table) {
  std::size_t longest = 0;
  for (const Parameter* parameter : table.parameters) {
    longest = std::max(longest, name_in_table(*parameter).size());
  }
  return longest;
}

/// Writes the tables of the schema's default machine, one after the other.
class InitWriter {
 public:
  InitWriter(const Schema& schema, std::string_view dialect_name)
      : settings_(Settings::defaults(schema)), dialect_name_(dialect_name) {
    add_comment(out_, fmt::format("Machine file of kerf{}{}.", dialect_name.empty() ? "" : ", dialect ",
                                  dialect_name));
    add_comment(out_,
                "Lengths in mm, angles in degree, speeds a minute. A key that is left out has its default.\n"
                "`kerf machine check FILE` checks this file, `kerf machine show` lists the values in force.");
    for (const ParameterTable& table : tables_of(schema)) add_table(table);
  }

  std::string take() { return std::move(out_); }

 private:
  void add_table(const ParameterTable& table) {
    out_ += '\n';
    if (table.header.empty()) {
      add_keys(table, {}, true);
      return;
    }
    add_comment(out_, heading_of(table.header, settings_.schema(), dialect_name_));
    if (!has_wildcard(table.header)) {
      out_ += fmt::format("[{}]\n", table.header);
      add_keys(table, {}, true);
    } else if (instance_of(*table.parameters.front()) == Instance::tool) {
      add_tools(table);
    } else {
      add_axis_tables(table);
    }
  }

  void add_axis_tables(const ParameterTable& table) {
    bool first = true;
    for (const Axis axis : settings_.axes()) {
      const std::string name(1, letter(axis));
      if (!first) out_ += '\n';
      out_ += fmt::format("[{}]\n", expanded(table.header, name));
      add_keys(table, name, first);
      first = false;
    }
  }

  void add_keys(const ParameterTable& table, std::string_view instance, bool commented) {
    const std::size_t width = longest_name(table);
    std::string_view group;
    for (const Parameter* parameter : table.parameters) {
      if (commented && parameter->group != group) {
        const bool first = parameter == table.parameters.front();
        out_ += first ? "" : "\n";
        if (!parameter->group.empty()) out_ += fmt::format("# --- {} ---\n", parameter->group);
        group = parameter->group;
      }
      const bool by_axis = parameter->key.ends_with(".*");
      const std::string value =
          by_axis ? offsets(*parameter) : value_text(expanded(parameter->key, instance));
      if (commented) add_key_comment(out_, *parameter, by_axis ? parameter->default_value : value);
      out_ += fmt::format("{:<{}} = {}\n", name_in_table(*parameter), width, value);
    }
  }

  /// One line a tool. A machine without tools gets an example as a comment.
  void add_tools(const ParameterTable& table) {
    out_ += "[tools]\n";
    for (const Parameter* parameter : table.parameters) {
      add_key_comment(out_, *parameter, parameter->default_value, name_in_table(*parameter));
    }
    const auto line = [&](std::string_view mark, std::size_t width, std::string_view number, bool example) {
      std::vector<std::string> fields;
      for (const Parameter* parameter : table.parameters) {
        const std::string value =
            example ? std::string(parameter->default_value) : value_text(expanded(parameter->key, number));
        fields.push_back(fmt::format("{} = {}", name_in_table(*parameter), value));
      }
      out_ += fmt::format("{}{:<{}} = {{ {} }}\n", mark, number, width, fmt::join(fields, ", "));
    };
    const auto& numbers = settings_.tool_numbers();
    if (numbers.empty()) line("# ", 1, "1", true);
    const std::size_t width = numbers.empty() ? 1 : std::to_string(*numbers.rbegin()).size();
    for (const std::int32_t number : numbers) line("", width, std::to_string(number), false);
  }

  std::string offsets(const Parameter& parameter) const {
    std::vector<std::string> fields;
    for (const Axis axis : settings_.axes()) {
      fields.push_back(fmt::format("{} = {}", letter(axis), value_text(expanded(parameter.key, axis))));
    }
    return fields.empty() ? "{}" : fmt::format("{{ {} }}", fmt::join(fields, ", "));
  }

  std::string value_text(std::string_view key) const {
    if (key == "dialect") return toml_text(std::string(dialect_name_));
    return toml_text(settings_.find(key)->value);
  }

  Settings settings_;
  std::string_view dialect_name_;
  std::string out_;
};

std::string origin_text(const ValueOrigin& origin) {
  switch (origin.kind) {
    case ValueOrigin::Kind::preset:
      return "default";
    case ValueOrigin::Kind::file:
      return fmt::format("{}:{}", printable(origin.file), origin.line);
    case ValueOrigin::Kind::assignment:
      return "--set";
  }
  return {};
}

/// The unit of a setting on this machine: degree in place of mm for a rotary axis.
std::string unit_of(const Settings& settings, const Setting& setting) {
  std::string unit(setting.parameter->unit);
  if (instance_of(*setting.parameter) != Instance::axis || !unit.starts_with("mm")) return unit;
  const std::size_t star = setting.parameter->key.find('*');
  const Setting* type = settings.find(expanded("axes.*.type", setting.key.substr(star, 1)));
  if (type && type->value == Value(std::string("rotary"))) unit.replace(0, 2, "degree");
  return unit;
}

/// The TOML table a setting is shown in and its key there: axes.X and rapid, offsets and G54.X, tools
/// and 1.radius.
std::pair<std::string, std::string> shown_place(const Setting& setting) {
  const bool inline_table =
      setting.parameter->key.ends_with(".*") || instance_of(*setting.parameter) == Instance::tool;
  std::size_t dot = setting.key.rfind('.');
  if (inline_table && dot != std::string::npos) dot = setting.key.rfind('.', dot - 1);
  if (dot == std::string::npos) return {{}, setting.key};
  return {setting.key.substr(0, dot), setting.key.substr(dot + 1)};
}

struct ShownLine {
  std::string_view group;
  std::string name;
  std::string value;
  std::string comment;
};

void add_shown_table(std::string& out, std::string_view header, const std::vector<ShownLine>& lines) {
  std::size_t name_width = 0;
  std::size_t value_width = 0;
  for (const ShownLine& line : lines) {
    name_width = std::max(name_width, line.name.size());
    value_width = std::max(value_width, line.value.size());
  }
  if (!out.empty()) out += '\n';
  if (!header.empty()) out += fmt::format("[{}]\n", header);
  std::string_view group;
  for (const ShownLine& line : lines) {
    if (line.group != group) {
      if (&line != lines.data()) out += '\n';
      if (!line.group.empty()) out += fmt::format("# {}\n", line.group);
    }
    group = line.group;
    out +=
        fmt::format("{:<{}} = {:<{}}  # {}\n", line.name, name_width, line.value, value_width, line.comment);
  }
}

}  // namespace

std::string init_text(const Schema& schema, std::string_view dialect_name) {
  return InitWriter(schema, dialect_name).take();
}

std::string show_text(const Settings& settings) {
  std::string out;
  std::string header;
  std::vector<ShownLine> lines;
  for (const Setting* setting : settings.in_order()) {
    auto [table, name] = shown_place(*setting);
    if (table != header && !lines.empty()) {
      add_shown_table(out, header, lines);
      lines.clear();
    }
    header = table;
    const std::string unit = unit_of(settings, *setting);
    lines.push_back({setting->parameter->group, name, toml_text(setting->value),
                     fmt::format("{}{}{}", unit, unit.empty() ? "" : ", ", origin_text(setting->origin))});
  }
  if (!lines.empty()) add_shown_table(out, header, lines);
  if (settings.tool_numbers().empty()) {
    out += fmt::format("\n[tools]\n# none of 1 to {} is set: every radius and length is 0\n",
                       settings.schema().highest_tool);
  }
  return out;
}

}  // namespace kerf
