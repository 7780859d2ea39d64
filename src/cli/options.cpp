#include "cli/options.hpp"

#include <map>

namespace kerf {

void add_machine_options(CLI::App& command, CommonOptions& options) {
  command.add_option(
      "--dialect", options.dialect,
      "Controller the program is written for (dgshape); otherwise from the machine file, otherwise "
      "from the program");
  command.add_option("--machine", options.machine_file, "Machine file (TOML); see `kerf machine init`")
      ->type_name("FILE");
  command.add_option("--set", options.assignments, "Set one key of the machine file; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_program_options(CLI::App& command, CommonOptions& options) {
  add_machine_options(command, options);
  command.add_flag("--optional-stop", options.optional_stop, "M01 stops the program");
  command.add_flag("--block-skip", options.block_skip, "Leave out blocks that begin with /");
  command
      .add_option("--program-dir", options.program_dir,
                  "Where subprograms are looked up (default: the folder of FILE)")
      ->type_name("DIR");
  static const std::map<std::string, ColorChoice> kColors{
      {"auto", ColorChoice::automatic}, {"always", ColorChoice::always}, {"never", ColorChoice::never}};
  command.add_option("--color", options.color, "Colours in diagnostics: auto, always or never")
      ->transform(CLI::CheckedTransformer(kColors, CLI::ignore_case).description(""))
      ->type_name("WHEN");
  command.add_flag("-v,--verbose", options.verbose, "Say what is being done, on standard error");
}

}  // namespace kerf
