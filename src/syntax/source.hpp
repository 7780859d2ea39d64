#pragma once
// The bytes of an NC program and the name they came from.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace kerf {

/// Why a file could not be read, for people.
struct SourceError {
  std::string message;  ///< what is wrong, with the file's name
  std::string remedy;
};

/// An immutable text, shared by everything that points into it. The kBehind bytes behind the text are always
/// line feeds, so that readers need no end check inside a line and may read a number in one piece.
class Source {
 public:
  /// Reads a regular file, a pipe, or standard input for "-". Text from pipes is limited to kMaxPipeBytes.
  /// `kind` is what the file should be, for messages.
  static tl::expected<std::shared_ptr<const Source>, SourceError> open(const std::string& path,
                                                                       std::string_view kind = "NC program");
  static std::shared_ptr<const Source> from_text(std::string name, std::string_view text);

  static constexpr std::size_t kBehind = 16;
  static constexpr std::size_t kMaxPipeBytes = std::size_t{1} << 30;

  const std::string& name() const { return name_; }
  std::string_view text() const { return {data_.get(), size_}; }

  /// `data` holds `size` bytes and room for kBehind more.
  Source(std::string name, std::unique_ptr<char[]> data, std::size_t size);

 private:
  std::string name_;
  std::unique_ptr<char[]> data_;
  std::size_t size_;
};

}  // namespace kerf
