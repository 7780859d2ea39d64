// kerf machine init | check | show: machine files.

#include <fmt/format.h>
#include <memory>
#include <sys/stat.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/job.hpp"
#include "machine/machine_text.hpp"
#include "report/atomic_file.hpp"

namespace kerf {
namespace {

struct MachineOptions {
  CommonOptions common;
  std::optional<std::string> file;
  bool force = false;
};

int init(const MachineOptions& options) {
  const auto controller = prepare_controller(options.common);
  if (!controller) return kExitUsage;
  const std::string text = init_text(schema_of(*controller->dialect), controller->dialect->name);
  if (!options.file) {
    ResultStream out;
    out.text() = text;
    out.flush();
    return out.good() ? kExitGood : kExitUsage;
  }
  struct stat status {};
  if (!options.force && ::stat(options.file->c_str(), &status) == 0) {
    print_error(fmt::format("{} exists already", *options.file),
                "choose another name, or overwrite it with --force");
    return kExitUsage;
  }
  if (const auto written = write_file(*options.file, text); !written) {
    print_error(written.error().message, written.error().remedy);
    return kExitUsage;
  }
  return kExitGood;
}

int check(MachineOptions options) {
  options.common.machine_file = options.file;
  const auto controller = prepare_controller(options.common);
  if (!controller) return kExitUsage;
  ResultStream out;
  out.text() =
      fmt::format("{}: good, a {} machine '{}' with {} axes\n", *options.file, controller->dialect->title,
                  controller->machine.name, controller->machine.axes.size());
  out.flush();
  return out.good() ? kExitGood : kExitUsage;
}

int show(MachineOptions options) {
  if (options.file) options.common.machine_file = options.file;
  const auto controller = prepare_controller(options.common);
  if (!controller) return kExitUsage;
  ResultStream out;
  out.text() = show_text(controller->settings);
  out.flush();
  return out.good() ? kExitGood : kExitUsage;
}

}  // namespace

void add_machine(CLI::App& app, CommandAction& action) {
  auto options = std::make_shared<MachineOptions>();
  CLI::App* command = app.add_subcommand("machine", "Write, validate or show a machine file");
  command->require_subcommand(1);

  CLI::App* init_command = command->add_subcommand("init", "Write a commented default machine file");
  init_command->add_option("FILE", options->file, "Where to (default: standard output)")->type_name("");
  init_command->add_flag("--force", options->force, "Overwrite an existing file");
  add_machine_options(*init_command, options->common);
  init_command->callback([&action, options] { action = [options] { return init(*options); }; });

  CLI::App* check_command = command->add_subcommand("check", "Validate a machine file");
  check_command->add_option("FILE", options->file, "Machine file (TOML)")->required()->type_name("");
  add_machine_options(*check_command, options->common);
  check_command->callback([&action, options] { action = [options] { return check(*options); }; });

  CLI::App* show_command =
      command->add_subcommand("show", "Show every effective value and where it comes from");
  show_command->add_option("FILE", options->file, "Machine file (TOML)")->type_name("");
  add_machine_options(*show_command, options->common);
  show_command->callback([&action, options] { action = [options] { return show(*options); }; });
  command->footer(
      "Examples:\n"
      "  kerf machine init mill.toml\n"
      "  kerf machine check mill.toml\n"
      "  kerf machine show mill.toml --set axes.X.rapid=8000");
}

}  // namespace kerf
