#include "syntax/source.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace kerf {
namespace {

/// A file descriptor that closes itself; standard input is left open.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ > STDIN_FILENO) ::close(value_);
  }
  int get() const { return value_; }

 private:
  int value_;
};

SourceError system_error(const std::string& path, int error) {
  std::string remedy = "check the name and the rights of the file";
  if (error == ENOENT) remedy = "check the spelling of the name and the folder";
  if (error == EACCES) remedy = "give the user the right to read the file";
  return {fmt::format("cannot read {}: {}", path, std::strerror(error)), std::move(remedy)};
}

/// Reads until the end of the data or until `capacity` bytes; -1 on error.
ssize_t read_fully(int descriptor, char* data, std::size_t capacity) {
  std::size_t done = 0;
  while (done < capacity) {
    const ssize_t count = ::read(descriptor, data + done, capacity - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return -1;
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return static_cast<ssize_t>(done);
}

/// Asks for large pages, which spares thousands of page faults on a long program; no harm when refused.
void prefer_large_pages(char* data, std::size_t size) {
  constexpr std::uintptr_t kPage = std::uintptr_t{2} << 20;
  const auto begin = (reinterpret_cast<std::uintptr_t>(data) + kPage - 1) / kPage * kPage;
  const auto end = (reinterpret_cast<std::uintptr_t>(data) + size) / kPage * kPage;
  if (end > begin)
    ::madvise(data + (begin - reinterpret_cast<std::uintptr_t>(data)), end - begin, MADV_HUGEPAGE);
}

tl::expected<std::shared_ptr<const Source>, SourceError> read_sized(const std::string& path, int descriptor,
                                                                    std::size_t size) {
  auto data = std::make_unique_for_overwrite<char[]>(size + Source::kBehind);
  prefer_large_pages(data.get(), size);
  const ssize_t count = read_fully(descriptor, data.get(), size);
  if (count < 0) return tl::unexpected(system_error(path, errno));
  return std::make_shared<const Source>(path, std::move(data), static_cast<std::size_t>(count));
}

tl::expected<std::shared_ptr<const Source>, SourceError> read_stream(const std::string& path,
                                                                     int descriptor) {
  std::size_t capacity = std::size_t{1} << 16;
  auto data = std::make_unique_for_overwrite<char[]>(capacity + Source::kBehind);
  std::size_t size = 0;
  for (;;) {
    const ssize_t count = read_fully(descriptor, data.get() + size, capacity - size);
    if (count < 0) return tl::unexpected(system_error(path, errno));
    size += static_cast<std::size_t>(count);
    if (size < capacity) break;
    if (capacity >= Source::kMaxPipeBytes) {
      return tl::unexpected(
          SourceError{fmt::format("{}: more than {} MiB through a pipe", path, capacity >> 20),
                      "write the text to a file first"});
    }
    auto larger = std::make_unique_for_overwrite<char[]>(capacity * 2 + Source::kBehind);
    std::copy_n(data.get(), size, larger.get());
    data = std::move(larger);
    capacity *= 2;
  }
  return std::make_shared<const Source>(path, std::move(data), size);
}

}  // namespace

Source::Source(std::string name, std::unique_ptr<char[]> data, std::size_t size)
    : name_(std::move(name)), data_(std::move(data)), size_(size) {
  std::fill_n(data_.get() + size_, kBehind, '\n');
}

tl::expected<std::shared_ptr<const Source>, SourceError> Source::open(const std::string& path,
                                                                      std::string_view kind) {
  if (path == "-") return read_stream("standard input", STDIN_FILENO);
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) return tl::unexpected(system_error(path, errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return tl::unexpected(system_error(path, errno));
  if (S_ISDIR(status.st_mode)) {
    return tl::unexpected(SourceError{fmt::format("{} is a folder, not a file with the {}", path, kind),
                                      fmt::format("name the file of the {} inside the folder", kind)});
  }
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    return read_sized(path, file.get(), static_cast<std::size_t>(status.st_size));
  }
  return read_stream(path, file.get());
}

std::shared_ptr<const Source> Source::from_text(std::string name, std::string_view text) {
  auto data = std::make_unique_for_overwrite<char[]>(text.size() + kBehind);
  std::copy(text.begin(), text.end(), data.get());
  return std::make_shared<const Source>(std::move(name), std::move(data), text.size());
}

}  // namespace kerf
