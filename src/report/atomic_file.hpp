#pragma once
// Output files that appear whole or not at all.

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace kerf {

/// Why a file could not be written, for people.
struct FileError {
  std::string message;  ///< names the file and the cause
  std::string remedy;   ///< what to do about it
};

/// A file that is being written beside its final place and moved there by commit(). Until then, and when the
/// object is destroyed without a commit, an older file of that name stays as it was and nothing new is left
/// behind. A device or pipe (/dev/stdout) cannot be replaced and is written directly. A symbolic link is
/// followed.
class AtomicFile {
 public:
  /// Refuses a directory and a folder that does not exist or may not be written.
  static tl::expected<AtomicFile, FileError> open(const std::string& path);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  tl::expected<void, FileError> write(std::string_view contents);

  /// Makes the contents durable and gives the file its name. Nothing may be written afterwards.
  tl::expected<void, FileError> commit();

 private:
  AtomicFile(std::string path, std::string temporary, int descriptor);
  void discard();

  std::string path_;       ///< the final place
  std::string temporary_;  ///< empty: a device, written directly
  int descriptor_ = -1;    ///< -1: closed
};

/// Opens, writes and commits.
tl::expected<void, FileError> write_file(const std::string& path, std::string_view contents);

}  // namespace kerf
