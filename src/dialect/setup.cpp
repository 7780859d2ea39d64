#include "dialect/setup.hpp"

#include <fmt/format.h>

#include "base/edit_distance.hpp"
#include "machine/build_machine.hpp"
#include "machine/settings_file.hpp"

namespace kerf {
namespace {

SettingsError unknown_dialect(std::string_view name, const ValueOrigin& place) {
  std::string remedy = "dialects are ";
  const std::string_view near = nearest_word(name, dialects(), &Dialect::name);
  if (!near.empty()) remedy = fmt::format("did you mean {}? {}", near, remedy);
  for (const Dialect& dialect : dialects())
    remedy += fmt::format("{}{}", &dialect == dialects().data() ? "" : ", ", dialect.name);
  return {std::string(place.file), place.line, place.column,
          fmt::format("there is no dialect '{}'", printable(name)), remedy};
}

tl::expected<const Dialect*, SettingsError> choose_dialect(const SetupOptions& options,
                                                           std::string_view program_name,
                                                           std::string_view program_text) {
  std::optional<std::string> name = options.dialect;
  ValueOrigin place;
  place.file = "--dialect";
  if (!name && options.machine_text) {
    if (auto said = dialect_of(*options.machine_text, options.machine_file)) {
      name = std::move(said->name);
      place = std::move(said->place);
    }
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
  const Dialect& chosen = **dialect;
  if (options.optional_stop && !chosen.optional_stop_key.empty())
    assignments.push_back(fmt::format("{}=true", (*dialect)->optional_stop_key));
  if (options.block_skip && !chosen.block_skip_key.empty())
    assignments.push_back(fmt::format("{}=true", (*dialect)->block_skip_key));
  if (!options.block_skip_numbers.empty()) {
    const std::string numbers = fmt::format("{}", fmt::join(options.block_skip_numbers, " "));
    if (chosen.block_skip_list_key.empty())
      errors.push_back({"--block-skip=" + numbers, 0, 0,
                        fmt::format("{} has no numbers of block skips", chosen.title),
                        "write --block-skip alone"});
    else
      assignments.push_back(fmt::format("{}=\"{}\"", chosen.block_skip_list_key, numbers));
  }
  for (const std::string& assignment : assignments) {
    if (auto set = apply_assignment(settings, assignment); !set) errors.push_back(std::move(set.error()));
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  if (chosen.complete != nullptr) chosen.complete(settings);
  auto machine = build_machine(settings);
  if (!machine) errors = std::move(machine.error());
  if (chosen.contradictions != nullptr) {
    for (SettingsError& error : chosen.contradictions(settings)) errors.push_back(std::move(error));
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  if (chosen.complete_machine != nullptr) chosen.complete_machine(settings, *machine);
  auto rules = (*dialect)->rules(settings, *machine);
  const FeedPolicy feed = (*dialect)->feed_policy(settings);
  const ToolpathPolicy toolpath = (*dialect)->toolpath_policy(settings);
  InterpreterOptions interpreter;
  interpreter.block_skip = !chosen.block_skip_key.empty() && settings.boolean(chosen.block_skip_key);
  return Controller{*dialect, std::move(settings), std::move(*machine), std::move(rules), feed,
                    toolpath, interpreter};
}

}  // namespace kerf
