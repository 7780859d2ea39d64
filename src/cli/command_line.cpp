#include "cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/edit_distance.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/version.hpp"

namespace kerf {
namespace {

/// What the chosen subcommand does, set by its parser.
using CommandAction = std::function<int()>;

void add_dialect_option(CLI::App& command, CommonOptions& options) {
  command
      .add_option(
          "--dialect", options.dialect,
          "Controller the program is written for (dgshape, melsec, omron); otherwise from the machine file, "
          "otherwise from the program")
      ->type_name("NAME");
}

void add_set_option(CLI::App& command, CommonOptions& options) {
  command.add_option("--set", options.assignments, "Set one key of the machine file; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

/// --dialect, --machine, --set
CLI::Option* add_machine_options(CLI::App& command, CommonOptions& options) {
  add_dialect_option(command, options);
  CLI::Option* machine =
      command.add_option("--machine", options.machine_file, "Machine file (TOML); see `kerf machine init`")
          ->type_name("FILE");
  add_set_option(command, options);
  return machine;
}

/// Turns the word of --color into the number of its choice.
std::string color_number(std::string& word) {
  constexpr std::array<std::string_view, 3> kWords{"auto", "always", "never"};
  for (std::size_t i = 0; i < kWords.size(); ++i) {
    if (edit_distance(word, kWords[i]) != 0) continue;
    word = std::to_string(i);
    return {};
  }
  return "'" + word + "' is not one of auto, always or never";
}

/// The above and --optional-stop, --block-skip, --program-dir, --color, -v
void add_program_options(CLI::App& command, CommonOptions& options) {
  add_machine_options(command, options);
  command.add_flag("--optional-stop", options.optional_stop, "M01 stops the program");
  command
      .add_flag("--block-skip", options.block_skips,
                "Leave out blocks that begin with /; --block-skip=N those with /N (OMRON), repeatable")
      ->type_name("");
  command
      .add_option("--program-dir", options.program_dir,
                  "Where subprograms are looked up (default: the folder of FILE)")
      ->type_name("DIR");
  command.add_option("--color", options.color, "Colours in diagnostics: auto, always or never")
      ->transform(CLI::Validator(color_number, ""))
      ->type_name("WHEN");
  command.add_flag("-v,--verbose", options.verbose, "Say what is being done, on standard error");
}

/// When `command` is the one on the command line, `action` becomes `run` with the options it was given.
template <class Options>
void choose(CLI::App& command, CommandAction& action, const std::shared_ptr<Options>& options,
            int (*run)(const Options&)) {
  command.callback([&action, options, run] { action = [options, run] { return run(*options); }; });
}

void add_check(CLI::App& app, CommandAction& action) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Check programs: every alarm with place, cause and remedy");
  command->add_option("FILE", options->files, "NC programs, or folders of programs (- for standard input)")
      ->required()
      ->type_name("");
  command->add_option("--max-alarms", options->max_alarms, "Stop checking a program after so many alarms")
      ->capture_default_str()
      ->check(CLI::Range(1, 1'000'000));
  command->add_option("--junit", options->junit, "Write the results as JUnit XML")->type_name("OUT.xml");
  command->add_option("--sarif", options->sarif, "Write the alarms as SARIF 2.1.0")->type_name("OUT.sarif");
  add_program_options(*command, options->common);
  command->footer(
      "Examples:\n"
      "  kerf check part.nc\n"
      "  kerf check --machine mill.toml *.nc\n"
      "  kerf check programs/ --junit check.xml --sarif check.sarif\n"
      "  kerf check part.nc --set dgshape.decimal_point=all");
  choose(*command, action, options, check_command);
}

void add_path(CLI::App& app, CommandAction& action) {
  auto options = std::make_shared<PathOptions>();
  CLI::App* command = app.add_subcommand("path", "Print where the tool really goes, step by step");
  command->add_option("FILE", options->file, "NC program (- for standard input)")->required()->type_name("");
  auto* json = command->add_flag("--json", options->json, "JSON Lines, one event a line");
  command->add_flag("--quiet", options->quiet, "Execute and print only the counts")->excludes(json);
  add_program_options(*command, options->common);
  command->footer(
      "Examples:\n"
      "  kerf path part.nc\n"
      "  kerf path part.nc --json | jq 'select(.event==\"move\") | .end'\n"
      "  kerf path part.nc --set tools.1.radius=3");
  choose(*command, action, options, path_command);
}

void add_run(CLI::App& app, CommandAction& action) {
  auto options = std::make_shared<RunCommandOptions>();
  CLI::App* command =
      app.add_subcommand("run", "Play a program on the simulated machine: time, path, pictures");
  command->add_option("FILE", options->file, "NC program (- for standard input)")->required()->type_name("");
  command->add_flag("--json", options->json, "Print the summary as one JSON object");
  command->add_option("--plot", options->plot, "Write a picture of the toolpath")->type_name("OUT.svg");
  command->add_option("--report", options->report, "Write a report: one page that needs no network")
      ->type_name("OUT.html");
  command->add_option("--trace", options->trace, "Write one row for each control cycle")
      ->type_name("OUT.csv");
  command->add_flag("--realtime", options->realtime, "Run at the speed of the machine");
  add_program_options(*command, options->common);
  command->footer(
      "Examples:\n"
      "  kerf run part.nc\n"
      "  kerf run part.nc --report part.html --plot part.svg\n"
      "  kerf run part.nc --trace part.csv --set machine.cycle_ms=0.5\n"
      "  kerf run part.nc --json --set axes.X.acceleration=1500");
  choose(*command, action, options, run_command);
}

void add_convert(CLI::App& app, CommandAction& action) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command =
      app.add_subcommand("convert", "Write a program in another form: OMRON intermediate code");
  command->add_option("FILE", options->file, "NC program (- for standard input)")->required()->type_name("");
  command->add_option("--to", options->to, "The form: pmc")->required()->type_name("FORM");
  command->add_option("-o,--output", options->output, "Where to (default: standard output)")
      ->type_name("OUT");
  command
      ->add_option("--number", options->number, "Program number (default: the one in the name of FILE, or 1)")
      ->check(CLI::Range(1, 9999))
      ->type_name("N");
  add_program_options(*command, options->common);
  command->footer(
      "Examples:\n"
      "  kerf convert 1000.nc --to pmc\n"
      "  kerf convert plate.nc --number 12 --to pmc -o plate.pmc");
  choose(*command, action, options, convert_command);
}

void add_codes(CLI::App& app, CommandAction& action) {
  auto options = std::make_shared<CodesOptions>();
  CLI::App* command = app.add_subcommand("codes", "List every G, M and other word with group and format");
  command->add_flag("--json", options->json, "JSON Lines, one word a line");
  add_machine_options(*command, options->common);
  command->footer("Example:\n  kerf codes --dialect dgshape");
  choose(*command, action, options, codes_command);
}

void add_alarms(CLI::App& app, CommandAction& action) {
  auto options = std::make_shared<AlarmsOptions>();
  CLI::App* command = app.add_subcommand("alarms", "List every alarm, or explain one");
  command->add_option("CODE", options->code, "Alarm code or word, for example arc-radius")->type_name("");
  command->add_flag("--json", options->json, "JSON");
  add_machine_options(*command, options->common);
  command->footer("Examples:\n  kerf alarms\n  kerf alarms arc-radius");
  choose(*command, action, options, alarms_command);
}

void add_machine(CLI::App& app, CommandAction& action) {
  auto options = std::make_shared<MachineOptions>();
  CLI::App* command = app.add_subcommand("machine", "Write, validate or show a machine file");
  command->require_subcommand(1);

  CLI::App* init = command->add_subcommand("init", "Write a commented default machine file");
  init->add_option("FILE", options->file, "Where to (default and -: standard output)")->type_name("");
  init->add_flag("--force", options->force, "Overwrite an existing file");
  add_dialect_option(*init, options->common);
  init->footer(
      "Examples:\n"
      "  kerf machine init mill.toml\n"
      "  kerf machine init --dialect dgshape | less");
  choose(*init, action, options, machine_init_command);

  CLI::App* check = command->add_subcommand("check", "Validate a machine file");
  check->add_option("FILE", options->file, "Machine file (TOML)")->required()->type_name("");
  add_dialect_option(*check, options->common);
  add_set_option(*check, options->common);
  check->footer("Example:\n  kerf machine check mill.toml");
  choose(*check, action, options, machine_check_command);

  CLI::App* show = command->add_subcommand("show", "Show every effective value and where it comes from");
  CLI::Option* file =
      show->add_option("FILE", options->file, "Machine file (TOML; default: --machine)")->type_name("");
  file->excludes(add_machine_options(*show, options->common));
  show->footer(
      "Examples:\n"
      "  kerf machine show --dialect dgshape\n"
      "  kerf machine show mill.toml --set axes.X.rapid=8000");
  choose(*show, action, options, machine_show_command);
  command->footer(
      "Examples:\n"
      "  kerf machine init mill.toml\n"
      "  kerf machine check mill.toml\n"
      "  kerf machine show mill.toml --set axes.X.rapid=8000");
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// The command on the command line, its own command included, and how it is called.
struct Chosen {
  const CLI::App* app = nullptr;
  std::string name = "kerf";
  int words = 1;  ///< of the command line that name it
};

Chosen chosen_command(const CLI::App& app) {
  Chosen chosen{&app};
  while (!chosen.app->get_subcommands().empty()) {
    chosen.app = chosen.app->get_subcommands().front();
    chosen.name += " " + chosen.app->get_name();
    ++chosen.words;
  }
  return chosen;
}

/// What was meant by the first argument the command does not know; empty when all are known.
int unknown_word(const Chosen& chosen, const std::string& word) {
  const bool option = word.front() == '-';
  const std::vector<std::string> known =
      option ? names_of_options(*chosen.app) : names_of_commands(*chosen.app);
  const std::string_view near = nearest_word(word.substr(0, word.find('=')), known);
  std::string remedy = "`" + chosen.name + " --help` shows the usage";
  if (!near.empty())
    remedy = "did you mean " +
             (option ? std::string(near) : "`" + chosen.name + " " + std::string(near) + "`") + "?";
  print_error("'" + chosen.name + "' has no " + (option ? "option " : "command ") + word, remedy);
  return kExitUsage;
}

int usage_error(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const Chosen chosen = chosen_command(app);
  const bool needs_command = !names_of_commands(*chosen.app).empty();
  if (needs_command && argc > chosen.words) return unknown_word(chosen, argv[chosen.words]);
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    const std::vector<std::string> extras = chosen.app->remaining();
    if (!extras.empty() && extras.front().starts_with("--")) return unknown_word(chosen, extras.front());
  }
  print_error(error.what(), "`" + chosen.name + " --help` shows the usage");
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
  add_convert(app, action);
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
