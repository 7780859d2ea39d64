#include "cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <clocale>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/version.hpp"

namespace kerf {
namespace {

int edit_distance(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[b.size()];
}

/// "did you mean check?" for a first word that is no command.
std::string near_command(const CLI::App& app, const std::string& word) {
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (edit_distance(word, command->get_name()) <= 2)
      return "did you mean `kerf " + command->get_name() + "`?";
  }
  return "`kerf --help` lists the commands";
}

int usage_error(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const bool no_command = app.get_subcommands().empty();
  if (no_command && argc > 1 && argv[1][0] != '-') {
    print_error("there is no command '" + std::string(argv[1]) + "'", near_command(app, argv[1]));
  } else {
    const std::string command = no_command ? "kerf" : "kerf " + app.get_subcommands().front()->get_name();
    print_error(error.what(), "`" + command + " --help` shows the usage");
  }
  return kExitUsage;
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App app{"kerf: reads NC programs of industrial controllers, checks them, times them and draws them."};
  app.name("kerf");
  app.set_version_flag("--version", "kerf " + std::string(version()));
  app.require_subcommand(1);
  app.footer(
      "Examples:\n"
      "  kerf check part.nc                       every alarm, with place, cause and remedy\n"
      "  kerf run part.nc --report part.html      how long it takes, with pictures\n"
      "  kerf path part.nc --json                 where the tool really goes\n"
      "\n"
      "Exit status: 0 the program ran to its end; 1 an alarm stopped it; 2 wrong usage, or a\n"
      "file that cannot be read or is no program.");
  CommandAction action;
  add_check(app, action);
  add_path(app, action);
  add_run(app, action);
  add_codes(app, action);
  add_alarms(app, action);
  add_machine(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    return usage_error(app, error, argc, argv);
  }
  return action ? action() : kExitUsage;
}

}  // namespace kerf
