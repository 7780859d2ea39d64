#pragma once
// Values of machine-file keys: their types, how they are written, and whether one fits its declaration.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "machine/parameter.hpp"

namespace kerf {

/// The value of one key, in the order of ValueType; words and texts share the string.
using Value = std::variant<bool, std::int64_t, double, std::string, std::array<double, 2>>;

/// What is wrong with a key or a value, before it is known where that stands.
struct Complaint {
  std::string message;
  std::string remedy;
  bool out_of_range = false;  ///< the value is of the right type, but too small or too large
};

/// One word of a ValueType::word parameter, with the manual's number where the declaration gives one.
struct Choice {
  std::string_view word;
  std::optional<std::int64_t> number;
};
std::vector<Choice> choices_of(const Parameter& parameter);

/// The value as the parameter declares it, from a value of any type: an integer becomes a number where a
/// number is declared and a word where the choices are numbered. Refused: another type, NaN and infinity, a
/// value out of range, a word that is not among the choices. `key` is the key for the messages.
tl::expected<Value, Complaint> checked_value(const Parameter& parameter, std::string_view key, Value value);

/// The value from text: as in TOML, and words and texts also without quotes. Text in quotes is taken
/// literally.
tl::expected<Value, Complaint> value_from_text(const Parameter& parameter, std::string_view key,
                                               std::string_view text);

/// The complaint about a value of another type, e.g. found = "a date".
Complaint wrong_type(const Parameter& parameter, std::string_view key, std::string_view found);

/// The value as TOML. Numbers have the fewest digits that read back to the same double.
std::string toml_text(const Value& value);

/// The range or the choices in words: "above 0, at most 1e12", "0 to 100", "controller or optimal"; empty:
/// any value.
std::string range_text(const Parameter& parameter);

/// User text for a message: control characters become `?`, long text is cut.
std::string printable(std::string_view text);

}  // namespace kerf
