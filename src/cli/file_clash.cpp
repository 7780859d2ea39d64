#include "cli/file_clash.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <system_error>

namespace kerf {
namespace {

namespace fs = std::filesystem;

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const fs::file_status status = fs::status(a, error);
  if (fs::exists(status)) return fs::is_regular_file(status) && fs::equivalent(a, b, error);
  // A file that is yet to be made has no identity but its path.
  const fs::path one = fs::weakly_canonical(fs::absolute(a, error), error);
  const fs::path other = fs::weakly_canonical(fs::absolute(b, error), error);
  return !error && one == other;
}

}  // namespace

std::optional<std::string> file_clash(const std::vector<NamedFile>& inputs,
                                      const std::vector<NamedFile>& outputs) {
  std::vector<NamedFile> taken = inputs;
  for (const NamedFile& output : outputs) {
    for (const NamedFile& other : taken) {
      if (same_file(output.path, other.path)) {
        return fmt::format("{} '{}' would overwrite {} '{}'", output.role, output.path, other.role,
                           other.path);
      }
    }
    taken.push_back(output);
  }
  return std::nullopt;
}

}  // namespace kerf
