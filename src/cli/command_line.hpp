#pragma once
// The kerf command: its subcommands, options and help.

namespace kerf {

/// Exit status 0: the program ran to its end; 1: an alarm stopped it; 2: wrong usage, or a file that cannot
/// be read or is not a program at all.
int run_command_line(int argc, char** argv);

}  // namespace kerf
