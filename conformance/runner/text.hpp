#pragma once
// Small helpers for reading line-oriented text files.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::conformance {

/// A mistake in a case, claim or statement file.
struct FileError {
  std::string file;
  std::uint32_t line = 0;  ///< from 1; 0: the whole file
  std::string message;
};

/// `1-5-numbers.case:12: unknown header 'id'`
std::string error_text(const FileError& error);

/// A line of a file, without its line end.
struct TextLine {
  std::string text;
  std::uint32_t number = 0;  ///< from 1
};

/// The lines of a text; a carriage return before a line feed belongs to the line end.
std::vector<TextLine> lines_of(std::string_view text);

std::string_view trimmed(std::string_view text);

/// The words of a text that blanks separate.
std::vector<std::string> words_of(std::string_view text);

/// The parts of a text between separators, not trimmed; always at least one.
std::vector<std::string> parts_of(std::string_view text, char separator);

/// A decimal number that takes the whole text; a leading + is allowed.
std::optional<double> number_of(std::string_view text);

/// A number as people write it: up to nine significant digits, no trailing zeroes, no -0.
std::string number_text(double value);

/// The bytes of a file; none when it cannot be read.
std::optional<std::string> read_file(const std::string& path);

}  // namespace kerf::conformance
