#pragma once
// Numbers as text, for outputs with millions of numbers: no locale, no "-0", the same bytes on every machine.

#include <cstdint>
#include <string>

namespace kerf {

/// Appends the shortest decimal that reads back as the same double, e.g. `10`, `0.1`, `-12.5`, `1e+20`.
/// Negative zero is written as `0`, a value that is not finite as `null`: the result is always a JSON value.
void append_number(std::string& out, double value);

void append_integer(std::string& out, std::int64_t value);

/// Appends at most `decimals` (0 to 9) places, without zeros at the end: 1.5 and not 1.500.
void append_rounded(std::string& out, double value, int decimals);

/// Appends exactly `decimals` (0 to 9) places: 1.500.
void append_fixed(std::string& out, double value, int decimals);

/// `append_rounded` as a value of its own.
std::string rounded_text(double value, int decimals);

/// `append_fixed` as a value of its own.
std::string fixed_text(double value, int decimals);

/// Seconds as h:mm:ss.s, e.g. 0:01:23.4; rounded to the tenth before it is split, so never 0:00:60.0.
std::string clock_text(double seconds);

/// A whole number in groups of three: 1234567 as "1 234 567".
std::string grouped_text(std::uint64_t value);

}  // namespace kerf
