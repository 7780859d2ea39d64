#pragma once
// The subcommands: what each is asked, and the function that does it and returns the exit status.

#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"

namespace kerf {

struct CheckOptions {
  CommonOptions common;
  std::vector<std::string> files;  ///< or folders of programs
  int max_alarms = 20;
  std::optional<std::string> junit;
  std::optional<std::string> sarif;
};
int check_command(const CheckOptions& options);

struct PathOptions {
  CommonOptions common;
  std::string file;
  bool json = false;
  bool quiet = false;
};
int path_command(const PathOptions& options);

struct RunCommandOptions {
  CommonOptions common;
  std::string file;
  bool json = false;
  bool realtime = false;
  std::optional<std::string> plot;
  std::optional<std::string> report;
  std::optional<std::string> trace;
};
int run_command(const RunCommandOptions& options);

struct ConvertOptions {
  CommonOptions common;
  std::string file;
  std::string to;
  std::optional<std::string> output;  ///< otherwise standard output
  std::int32_t number = -1;           ///< of the program; -1: as its file's name says
};
int convert_command(const ConvertOptions& options);

struct CodesOptions {
  CommonOptions common;
  bool json = false;
};
int codes_command(const CodesOptions& options);

struct AlarmsOptions {
  CommonOptions common;
  std::optional<std::string> code;
  bool json = false;
};
int alarms_command(const AlarmsOptions& options);

struct MachineOptions {
  CommonOptions common;
  std::optional<std::string> file;
  bool force = false;
};
int machine_init_command(const MachineOptions& options);
int machine_check_command(const MachineOptions& options);
int machine_show_command(const MachineOptions& options);

}  // namespace kerf
