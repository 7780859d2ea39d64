#pragma once
// A dialect's codes as data: one row feeds the interpreter, `kerf codes` and the documentation.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "base/fixed_text.hpp"
#include "execute/modal.hpp"

namespace kerf {

/// One G, M or other word as `kerf codes` lists it.
struct CodeRow {
  char letter = 0;        ///< 'G', 'M', or the address; 0 for signs such as %
  CodeNumber number = 0;  ///< of G and M codes
  Group group = Group::one_shot;
  std::string_view word;  ///< as it is written: G01, M30, F, %
  std::string_view group_name;
  std::string_view modality;  ///< modal, one-shot, ...
  std::string_view name;
  std::string_view format;  ///< with [optional] words and {choices}
};

/// The row of a code, or null. Linear in the rows of the letter; the interpreter builds its own index.
const CodeRow* find_code(std::span<const CodeRow> rows, char letter, CodeNumber number);

/// The number of a code as it is written, like G90 or G40.1; kNoCode when it is none.
CodeNumber code_named(std::string_view word);

/// A remedy for an unknown code: the one code of the table from which it differs by a missing, doubled or
/// swapped digit ("did you mean G54?"). Empty when there is none or more than one; a code with one digit
/// different is simply another code.
FixedText<200> nearest_code(std::span<const CodeRow> rows, char letter, std::int64_t number);

}  // namespace kerf
