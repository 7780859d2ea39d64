#include "machine/settings_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>
#include <utility>

#include "machine/contradictions.hpp"
#include "machine/key_check.hpp"

// The parser reports errors as values and refuses deep nesting by itself.
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_MAX_NESTED_VALUES 16
// Some assertions of toml++ 3.3 do not hold for malformed text that the parser then refuses properly, such as
// "[=]": they must neither abort the program nor be taken for granted by the optimiser.
#include <toml++/impl/preprocessor.h>
#undef TOML_ASSERT
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT(expr) static_assert(true)
#define TOML_ASSERT_ASSUME(expr) static_assert(true)
#include <toml++/toml.h>

namespace kerf {
namespace {

constexpr std::size_t kMostErrors = 100;

/// Each dot of a key nests a table, and the parser's tables are taken down by recursion; a key cannot go over
/// the end of its line.
constexpr std::size_t kMostDotsInLine = 100;

std::optional<SettingsError> unsafe_text(std::string_view text, std::string_view file) {
  if (text.size() > kLargestMachineFile) {
    return SettingsError{std::string(file), 0, 0, "the file is larger than 16 MiB",
                         "a machine file is small text"};
  }
  std::uint32_t line = 1;
  std::uint32_t column = 0;
  std::size_t dots = 0;
  for (const char c : text) {
    ++column;
    if (c == '\n') {
      ++line;
      column = 0;
      dots = 0;
    } else if (c == '.' && ++dots > kMostDotsInLine) {
      return SettingsError{std::string(file), line, column,
                           fmt::format("more than {} dots in one line", kMostDotsInLine), ""};
    }
  }
  return std::nullopt;
}

/// The parser's message without its "Error while parsing ...:", which says nothing to the reader of a machine
/// file.
SettingsError syntax_error(const toml::parse_error& error, std::string_view file) {
  std::string_view message = error.description();
  constexpr std::string_view kPreamble = "Error while parsing ";
  const std::size_t colon = message.find(": ");
  if (message.starts_with(kPreamble) && colon != std::string_view::npos) message.remove_prefix(colon + 2);
  const toml::source_position place = error.source().begin;
  return {std::string(file), place.line, place.column, fmt::format("not valid TOML: {}", printable(message)),
          ""};
}

std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::date:
      return "a date";
    case toml::node_type::time:
      return "a time";
    case toml::node_type::date_time:
      return "a date and time";
    default:
      return "this";
  }
}

std::optional<Value> value_of(const toml::node& node) {
  if (const auto* value = node.as_boolean()) return value->get();
  if (const auto* value = node.as_integer()) return value->get();
  if (const auto* value = node.as_floating_point()) return value->get();
  if (const auto* value = node.as_string()) return value->get();
  const toml::array* array = node.as_array();
  if (!array || array->size() != 2) return std::nullopt;
  std::array<double, 2> pair{};
  for (std::size_t i = 0; i < pair.size(); ++i) {
    if (const auto* integer = (*array)[i].as_integer()) {
      pair[i] = static_cast<double>(integer->get());
    } else if (const auto* number = (*array)[i].as_floating_point()) {
      pair[i] = number->get();
    } else {
      return std::nullopt;
    }
  }
  return pair;
}

/// A file with axis tables describes all axes of the machine.
std::string table_beside_others(std::string_view axis) {
  return fmt::format("add an [axes.{}] table beside those of all other axes", axis);
}

/// Walks the parsed file and fills the settings; collects what is wrong.
class FileReader {
 public:
  FileReader(Settings& settings, std::string_view file) : settings_(settings), file_(file) {}

  void read(const toml::table& root) {
    replace_axes(root);
    KeyPath path;
    read_table(root, path);
  }

  /// In the order of their places.
  std::vector<SettingsError> take_errors() {
    for (SettingsError& error : contradictions(settings_, faulty_axes_)) errors_.push_back(std::move(error));
    std::stable_sort(errors_.begin(), errors_.end(), [](const SettingsError& a, const SettingsError& b) {
      return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
    if (errors_.size() > kMostErrors) errors_.resize(kMostErrors);
    return std::move(errors_);
  }

 private:
  void replace_axes(const toml::table& root) {
    const toml::table* tables = root["axes"].as_table();
    if (!tables) return;
    AxisSet axes;
    for (const auto& [key, node] : *tables) {
      const auto axis = axis_of(key.str());
      if (axis && node.is_table()) axes.insert(*axis);
    }
    if (!axes.empty()) settings_.replace_axes(axes);
  }

  void read_table(const toml::table& table, KeyPath& path) {
    const auto& foreign = settings_.schema().foreign_sections;
    for (const auto& [key, node] : table) {
      if (errors_.size() >= kMostErrors) return;
      const bool is_foreign =
          path.empty() && std::find(foreign.begin(), foreign.end(), key.str()) != foreign.end();
      if (is_foreign) continue;
      path.emplace_back(key.str());
      read_node(key, node, path);
      path.pop_back();
    }
  }

  void read_node(const toml::key& key, const toml::node& node, KeyPath& path) {
    const KeyStep step = follow(settings_.schema(), path);
    if (step.kind != KeyStep::Kind::parameter && step.kind != KeyStep::Kind::section) {
      fail(path, key.source(), unknown_key(settings_, path, path.size() - 1, step));
      return;
    }
    if (step.instance == Instance::tool && node.is_table()) settings_.add_tool(*tool_of(path.back()));
    if (step.instance == Instance::axis && !settings_.axes().contains(*axis_of(path.back()))) {
      // An axis that is no table stays unknown to the machine; that it should be one is the better message.
      fail(path, key.source(),
           path[0] == "axes" ? section_not_value(path)
                             : missing_axis(settings_, path, table_beside_others(path.back())));
      return;
    }
    if (step.kind == KeyStep::Kind::section) {
      if (const toml::table* table = node.as_table()) {
        read_table(*table, path);
      } else {
        fail(path, node.source(), section_not_value(path));
      }
      return;
    }
    read_value(*step.parameter, node, path);
  }

  void read_value(const Parameter& parameter, const toml::node& node, const KeyPath& path) {
    const std::string key = joined(path);
    std::optional<Value> raw = value_of(node);
    if (!raw) {
      fail(path, node.source(), wrong_type(parameter, key, type_name(node)));
      return;
    }
    auto value = checked_value(parameter, key, *std::move(raw));
    if (!value) {
      const bool out_of_range = value.error().out_of_range;
      fail(path, node.source(), std::move(value.error()));
      const AlarmKind* kind = alarm_of(settings_.schema(), parameter);
      if (out_of_range && kind) name_alarm(errors_.back(), *kind);
      return;
    }
    if (key == "dialect") {
      if (auto complaint = unknown_dialect(settings_, std::get<std::string>(*value))) {
        fail(path, node.source(), *std::move(complaint));
        return;
      }
    }
    const toml::source_position place = node.source().begin;
    settings_.assign(key, *std::move(value), {ValueOrigin::Kind::file, file_, place.line, place.column});
  }

  void fail(const KeyPath& path, const toml::source_region& source, Complaint complaint) {
    // What follows from a value that was not understood would only distract.
    if (path.size() > 1 && path[0] == "axes") {
      if (const auto axis = axis_of(path[1])) faulty_axes_.insert(*axis);
    }
    errors_.push_back({file_, source.begin.line, source.begin.column, std::move(complaint.message),
                       std::move(complaint.remedy)});
  }

  Settings& settings_;
  std::string file_;
  AxisSet faulty_axes_;
  std::vector<SettingsError> errors_;
};

}  // namespace

tl::expected<void, std::vector<SettingsError>> apply_toml(Settings& settings, std::string_view text,
                                                          std::string_view file_name) {
  if (auto error = unsafe_text(text, file_name)) return tl::unexpected(std::vector{*std::move(error)});
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) return tl::unexpected(std::vector{syntax_error(parsed.error(), file_name)});

  Settings changed = settings;
  FileReader reader(changed, file_name);
  reader.read(parsed.table());
  std::vector<SettingsError> errors = reader.take_errors();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  settings = std::move(changed);
  return {};
}

std::optional<NamedDialect> dialect_of(std::string_view toml_text, std::string_view file_name) {
  if (unsafe_text(toml_text, {})) return std::nullopt;
  const toml::parse_result parsed = toml::parse(toml_text);
  if (!parsed) return std::nullopt;
  const toml::value<std::string>* name = parsed.table()["dialect"].as_string();
  if (name == nullptr) return std::nullopt;
  const toml::source_position place = name->source().begin;
  return NamedDialect{name->get(),
                      {ValueOrigin::Kind::file, std::string(file_name), place.line, place.column}};
}

}  // namespace kerf
