#pragma once
// A program file of the MELSEC G-code control into a compiled program (manual 5.1, 5.2, 5.8 to 5.10).

#include <memory>
#include <optional>
#include <string_view>

#include "syntax/compiled_program.hpp"

namespace kerf::melsec {

/// Largest program file, bytes (manual 5.1).
inline constexpr std::size_t kLargestProgram = std::size_t{512} * 1024;

/// All program files of the controller together, bytes (manual 5.1, appendix 1).
inline constexpr std::size_t kLargestStore = std::size_t{2} * 1024 * 1024;

/// The program number of a file O001.gcd to O256.gcd; nothing for any other name.
std::optional<std::int32_t> stored_number(std::string_view file_name);

/// Compiles any text: what is wrong with a block becomes a fault that is raised when the block is reached,
/// and what is wrong with the file (no % lines, too large) a fault of its first statement, since the
/// controller does not load such a file. `number` is the program number.
std::shared_ptr<const CompiledProgram> compile(std::shared_ptr<const Source> source, std::int32_t number);

/// A program that the controller does not load, for the details code given.
std::shared_ptr<const CompiledProgram> refused_program(std::shared_ptr<const Source> source,
                                                       std::int32_t number, std::string_view detail);

/// The text returns with M99 and has neither M02 nor M30, so it is there to be called.
bool is_subprogram(const std::shared_ptr<const Source>& source);

}  // namespace kerf::melsec
