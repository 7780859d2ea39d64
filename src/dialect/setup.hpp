#pragma once
// From options to a controller ready to run: dialect, machine, rules and policies.

#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "dialect/dialect.hpp"
#include "execute/interpreter.hpp"
#include "machine/settings_error.hpp"

namespace kerf {

struct SetupOptions {
  std::optional<std::string> dialect;  ///< name; otherwise from the machine file, otherwise from the program
  std::optional<std::string> machine_text;  ///< contents of the machine file
  std::string machine_file;                 ///< its name, for messages
  std::vector<std::string> assignments;     ///< `--set` values, KEY=VALUE
  bool optional_stop = false;
  bool block_skip = false;
  std::vector<std::string> block_skip_numbers;  ///< of single signals, where the dialect has several
};

/// A controller without a program.
struct Controller {
  const Dialect* dialect = nullptr;
  Settings settings;
  Machine machine;
  std::shared_ptr<const BlockRules> rules;
  FeedPolicy feed_policy;
  ToolpathPolicy toolpath_policy;
  InterpreterOptions interpreter_options;
};

/// The program decides on the dialect where nothing else does; of its text the beginning is enough. Errors
/// are those of the machine file and the assignments, all in one pass.
tl::expected<Controller, std::vector<SettingsError>> make_controller(const SetupOptions& options,
                                                                     std::string_view program_name = {},
                                                                     std::string_view program_text = {});

}  // namespace kerf
