#include "dialect/setup.hpp"

#include <fmt/format.h>

#include "machine/build_machine.hpp"
#include "machine/settings_file.hpp"

namespace kerf {
namespace {

SettingsError unknown_dialect(std::string_view name, std::string_view place) {
  std::string known;
  for (const Dialect& dialect : dialects())
    known += fmt::format("{}{}", known.empty() ? "" : ", ", dialect.name);
  return {std::string(place), 0, 0, fmt::format("there is no dialect '{}'", name),
          fmt::format("use one of: {}", known)};
}

tl::expected<const Dialect*, SettingsError> choose_dialect(const SetupOptions& options,
                                                           std::string_view program_name,
                                                           std::string_view program_text) {
  std::optional<std::string> name = options.dialect;
  std::string_view place = "--dialect";
  if (!name && options.machine_text) {
    name = dialect_of(*options.machine_text);
    place = options.machine_file;
  }
  if (!name) return &detect_dialect(program_name, program_text);
  const Dialect* found = find_dialect(*name);
  if (found == nullptr) return tl::unexpected(unknown_dialect(*name, place));
  return found;
}

}  // namespace

tl::expected<Controller, std::vector<SettingsError>> make_controller(const SetupOptions& options,
                                                                     std::string_view program_name,
                                                                     std::string_view program_text) {
  const auto dialect = choose_dialect(options, program_name, program_text);
  if (!dialect) return tl::unexpected(std::vector{dialect.error()});
  Settings settings = Settings::defaults(schema_of(**dialect));
  std::vector<SettingsError> errors;
  if (options.machine_text) {
    if (auto read = apply_toml(settings, *options.machine_text, options.machine_file); !read) {
      errors = std::move(read.error());
    }
  }
  std::vector<std::string> assignments = options.assignments;
  if (options.optional_stop) assignments.push_back(fmt::format("{}=true", (*dialect)->optional_stop_key));
  if (options.block_skip) assignments.push_back(fmt::format("{}=true", (*dialect)->block_skip_key));
  for (const std::string& assignment : assignments) {
    if (auto set = apply_assignment(settings, assignment); !set) errors.push_back(std::move(set.error()));
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  auto machine = build_machine(settings);
  if (!machine) return tl::unexpected(std::move(machine.error()));

  auto rules = (*dialect)->rules(settings, *machine);
  const FeedPolicy feed = (*dialect)->feed_policy(settings);
  const ToolpathPolicy toolpath = (*dialect)->toolpath_policy(settings);
  const InterpreterOptions interpreter{settings.boolean((*dialect)->block_skip_key)};
  return Controller{*dialect, std::move(settings), std::move(*machine), std::move(rules), feed,
                    toolpath, interpreter};
}

}  // namespace kerf
