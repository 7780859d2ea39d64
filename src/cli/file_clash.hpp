#pragma once
// Output files that would overwrite an input of the same command, or each other.

#include <optional>
#include <string>
#include <vector>

namespace kerf {

/// A file of the command line and what it is there: {"part.nc", "the program"}.
struct NamedFile {
  std::string path;
  std::string role;
};

/// What is wrong with the names of the outputs, for people; nothing when they are good. An output is compared
/// with the inputs and the outputs before it by the file it leads to, through links and other spellings.
/// Devices and pipes may be named more than once.
std::optional<std::string> file_clash(const std::vector<NamedFile>& inputs,
                                      const std::vector<NamedFile>& outputs);

}  // namespace kerf
