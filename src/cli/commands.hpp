#pragma once
// The subcommands: each adds itself to the command line and returns its exit status.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace kerf {

/// What the chosen subcommand does, set by its parser.
using CommandAction = std::function<int()>;

void add_check(CLI::App& app, CommandAction& action);
void add_path(CLI::App& app, CommandAction& action);
void add_run(CLI::App& app, CommandAction& action);
void add_codes(CLI::App& app, CommandAction& action);
void add_alarms(CLI::App& app, CommandAction& action);
void add_machine(CLI::App& app, CommandAction& action);

}  // namespace kerf
