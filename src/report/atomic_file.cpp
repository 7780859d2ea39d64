#include "report/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace kerf {
namespace {

std::string_view remedy_for(int error) {
  switch (error) {
    case ENOENT:
      return "create the folder first, or name one that exists";
    case ENOTDIR:
      return "a part of the path is a file; name a folder that exists";
    case EACCES:
    case EPERM:
      return "name a folder you may write to";
    case EROFS:
      return "the disk is read-only; name another place";
    case ENOSPC:
    case EDQUOT:
      return "free some space on the disk, or name another place";
    case EISDIR:
      return "name a file inside the folder";
    case ENAMETOOLONG:
      return "choose a shorter name";
    case EFBIG:
      return "the file grew beyond what is allowed; write less, or raise the limit (ulimit -f)";
    case EPIPE:
      return "the reader of the pipe ended early";
    default:
      return "check the disk and the path";
  }
}

tl::unexpected<FileError> failure(const std::string& path, int error) {
  FileError reason{fmt::format("cannot write {}: {}", path, std::strerror(error)), {}};
  reason.remedy = remedy_for(error);
  return tl::unexpected(std::move(reason));
}

/// The place a symbolic link leads to, whether there is a file yet or not, or the path itself.
std::string followed(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr int kMostLinks = 40;
  std::error_code error;
  fs::path place = path;
  for (int i = 0; i < kMostLinks && fs::is_symlink(place, error); ++i) {
    const fs::path target = fs::read_symlink(place, error);
    if (error) return path;
    place = place.parent_path() / target;  // an absolute target replaces the folder
  }
  return place.string();
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

/// A new file beside `path`, hidden, with the permissions a new file gets.
struct Temporary {
  std::string name;
  int descriptor = -1;
};

Temporary create_beside(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::size_t name_begin = slash == std::string::npos ? 0 : slash + 1;
  const std::string folder = path.substr(0, name_begin);
  // A shortened name keeps the temporary within the longest name a file system allows.
  const std::string name = path.substr(name_begin, 200);
  constexpr int kAttempts = 1000;
  for (int i = 0; i < kAttempts; ++i) {
    Temporary temporary{fmt::format("{}.{}.{}-{}.tmp", folder, name, ::getpid(), i), -1};
    temporary.descriptor = ::open(temporary.name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (temporary.descriptor >= 0 || errno != EEXIST) return temporary;
  }
  return {};
}

/// Makes the new name itself durable. A file system that cannot do so still has the file.
void sync_folder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

tl::expected<AtomicFile, FileError> AtomicFile::open(const std::string& path) {
  if (path.empty()) return tl::unexpected(FileError{"cannot write a file without a name", "name a file"});
  std::string target = followed(path);
  struct stat existing {};
  const bool exists = ::stat(target.c_str(), &existing) == 0;
  if ((exists && S_ISDIR(existing.st_mode)) || path.back() == '/') return failure(path, EISDIR);
  if (exists && !S_ISREG(existing.st_mode)) {
    const int device = ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
    if (device < 0) return failure(path, errno);
    return AtomicFile(path, "", device);
  }
  if (exists && ::access(target.c_str(), W_OK) != 0) return failure(path, errno);
  Temporary temporary = create_beside(target);
  if (temporary.descriptor < 0) return failure(path, errno);
  // Best effort: on a file system without permissions the new file keeps its own.
  if (exists && ::fchmod(temporary.descriptor, existing.st_mode & 07777U) != 0) errno = 0;
  return AtomicFile(std::move(target), std::move(temporary.name), temporary.descriptor);
}

AtomicFile::AtomicFile(std::string path, std::string temporary, int descriptor)
    : path_(std::move(path)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this != &other) {
    discard();
    path_ = std::move(other.path_);
    temporary_ = std::move(other.temporary_);
    descriptor_ = std::exchange(other.descriptor_, -1);
  }
  return *this;
}

AtomicFile::~AtomicFile() {
  discard();
}

void AtomicFile::discard() {
  if (descriptor_ < 0) return;
  ::close(std::exchange(descriptor_, -1));
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

tl::expected<void, FileError> AtomicFile::write(std::string_view contents) {
  while (!contents.empty()) {
    const ::ssize_t written = ::write(descriptor_, contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failure(path_, errno);
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

tl::expected<void, FileError> AtomicFile::commit() {
  if (temporary_.empty()) {
    if (::close(std::exchange(descriptor_, -1)) != 0) return failure(path_, errno);
    return {};
  }
  const bool durable = ::fsync(descriptor_) == 0;
  const bool named = durable && ::rename(temporary_.c_str(), path_.c_str()) == 0;
  if (!named) {
    const int error = errno;
    discard();
    return failure(path_, error);
  }
  ::close(std::exchange(descriptor_, -1));
  sync_folder(folder_of(path_));
  return {};
}

tl::expected<void, FileError> write_file(const std::string& path, std::string_view contents) {
  auto file = AtomicFile::open(path);
  if (!file) return tl::unexpected(file.error());
  if (auto written = file->write(contents); !written) return written;
  return file->commit();
}

}  // namespace kerf
