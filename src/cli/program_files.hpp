#pragma once
// The program files that a folder holds.

#include <string>
#include <vector>

namespace kerf {

/// Files of the folder itself whose names end like those of NC programs, sorted by name.
std::vector<std::string> program_files_in(const std::string& folder);

}  // namespace kerf
