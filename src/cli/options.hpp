#pragma once
// Options that several subcommands share.

#include <optional>
#include <string>
#include <vector>

#include "cli/console.hpp"

namespace kerf {

struct CommonOptions {
  std::optional<std::string> dialect;
  std::optional<std::string> machine_file;
  std::vector<std::string> assignments;
  bool optional_stop = false;
  std::vector<std::string> block_skips;  ///< "true" for all blocks with a slash, or the number of a signal
  std::optional<std::string> program_dir;
  ColorChoice color = ColorChoice::automatic;
  bool verbose = false;
};

}  // namespace kerf
