#include "cli/program_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace kerf {
namespace {

constexpr std::array<std::string_view, 11> kExtensions{".gcd", ".nc",  ".ncd", ".cnc", ".tap", ".prn",
                                                       ".mpf", ".eia", ".iso", ".ngc", ".prg"};

bool is_program(const std::filesystem::directory_entry& entry) {
  std::error_code ignored;
  if (!entry.is_regular_file(ignored)) return false;
  std::string extension = entry.path().extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

}  // namespace

std::vector<std::string> program_files_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (is_program(*entry)) files.push_back(entry->path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace kerf
