#include "machine/value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace kerf {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

bool is_quoted(std::string_view text) {
  return text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
}

/// A decimal number of type T that fills the whole text; a leading `+` is allowed as in TOML.
template <class T>
std::optional<T> parsed(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  T number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<std::array<double, 2>> parsed_pair(std::string_view text) {
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return std::nullopt;
  text = text.substr(1, text.size() - 2);
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto low = parsed<double>(trimmed(text.substr(0, comma)));
  const auto high = parsed<double>(trimmed(text.substr(comma + 1)));
  if (!low || !high) return std::nullopt;
  return std::array{*low, *high};
}

/// Text of unknown type as TOML would type it; anything that is no number, boolean or pair is a string.
Value value_of_any_type(std::string_view text) {
  if (text == "true") return true;
  if (text == "false") return false;
  if (const auto integer = parsed<std::int64_t>(text)) return *integer;
  if (const auto number = parsed<double>(text)) return *number;
  if (const auto pair = parsed_pair(text)) return *pair;
  return std::string(is_quoted(text) ? text.substr(1, text.size() - 2) : text);
}

std::string_view type_name(const Value& value) {
  constexpr std::array<std::string_view, 5> kNames{"a boolean", "an integer", "a number", "a text",
                                                   "a pair of numbers"};
  return kNames[value.index()];
}

std::string_view expected_type(ValueType type) {
  switch (type) {
    case ValueType::boolean:
      return "true or false";
    case ValueType::integer:
      return "an integer";
    case ValueType::number:
      return "a number";
    case ValueType::word:
      return "a word";
    case ValueType::text:
      return "a text in quotes";
    case ValueType::number_pair:
      return "two numbers [low, high]";
  }
  return {};
}

std::string number_text(double number) {
  std::string text = fmt::format("{}", number);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

/// A limit for people: 100, 9999.9999, 1e12.
std::string limit_text(double limit) {
  std::string text = fmt::format("{}", limit);
  const std::size_t zeros = text.size() - 1 - text.find_last_not_of('0');
  if (zeros < 6 || text.find_first_of(".e") != std::string::npos) return text;
  return fmt::format("{}e{}", text.substr(0, text.size() - zeros), zeros);
}

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\t':
        out += "\\t";
        break;
      case '\r':
        out += "\\r";
        break;
      default: {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F) {
          out += fmt::format("\\u{:04X}", byte);
        } else {
          out += c;
        }
      }
    }
  }
  return out += '"';
}

bool in_range(const Parameter& parameter, double number) {
  return std::isfinite(number) && number <= parameter.maximum &&
         (parameter.above_minimum ? number > parameter.minimum : number >= parameter.minimum);
}

tl::unexpected<Complaint> out_of_range(const Parameter& parameter, std::string_view key, const Value& value) {
  const std::string range = range_text(parameter);
  return tl::unexpected(
      Complaint{fmt::format("'{}' = {} is out of range", key, toml_text(value)),
                fmt::format("the range is {}{}{}", range.empty() ? "every finite number" : range,
                            parameter.unit.empty() ? "" : " ", parameter.unit),
                true});
}

tl::expected<Value, Complaint> checked_word(const Parameter& parameter, std::string_view key,
                                            const Value& value) {
  for (const Choice& choice : choices_of(parameter)) {
    const std::string* word = std::get_if<std::string>(&value);
    const std::int64_t* number = std::get_if<std::int64_t>(&value);
    if (word && *word == choice.word) return value;
    if (number && choice.number == *number) return std::string(choice.word);
  }
  return tl::unexpected(Complaint{fmt::format("'{}' cannot be {}", key, printable(toml_text(value))),
                                  fmt::format("choose {}", range_text(parameter))});
}

tl::expected<Value, Complaint> checked_pair(const Parameter& parameter, std::string_view key,
                                            const std::array<double, 2>& pair) {
  for (const double number : pair) {
    if (!in_range(parameter, number)) return out_of_range(parameter, key, number);
  }
  return pair;
}

}  // namespace

std::vector<Choice> choices_of(const Parameter& parameter) {
  std::vector<Choice> choices;
  std::string_view rest = parameter.choices;
  while (!rest.empty()) {
    const std::string_view item = rest.substr(0, rest.find('|'));
    rest.remove_prefix(std::min(rest.size(), item.size() + 1));
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos) {
      choices.push_back({item, std::nullopt});
    } else {
      choices.push_back({item.substr(equals + 1), parsed<std::int64_t>(item.substr(0, equals))});
    }
  }
  return choices;
}

Complaint wrong_type(const Parameter& parameter, std::string_view key, std::string_view found) {
  std::string remedy = fmt::format("for example {}", parameter.default_value);
  if (parameter.type == ValueType::word) remedy = fmt::format("choose {}", range_text(parameter));
  if (parameter.type == ValueType::text) remedy = "write the text between double quotes";
  return {fmt::format("'{}' takes {}, not {}", key, expected_type(parameter.type), found), remedy};
}

tl::expected<Value, Complaint> checked_value(const Parameter& parameter, std::string_view key, Value value) {
  const auto* integer = std::get_if<std::int64_t>(&value);
  switch (parameter.type) {
    case ValueType::boolean:
      if (std::holds_alternative<bool>(value)) return value;
      break;
    case ValueType::integer:
      if (!integer) break;
      if (!in_range(parameter, static_cast<double>(*integer))) return out_of_range(parameter, key, value);
      return value;
    case ValueType::number:
      if (integer) value = static_cast<double>(*integer);
      if (!std::holds_alternative<double>(value)) break;
      if (!in_range(parameter, std::get<double>(value))) return out_of_range(parameter, key, value);
      return value;
    case ValueType::word:
      if (integer || std::holds_alternative<std::string>(value)) return checked_word(parameter, key, value);
      break;
    case ValueType::text:
      if (std::holds_alternative<std::string>(value)) return value;
      break;
    case ValueType::number_pair:
      if (const auto* pair = std::get_if<std::array<double, 2>>(&value)) {
        return checked_pair(parameter, key, *pair);
      }
      break;
  }
  return tl::unexpected(wrong_type(parameter, key, type_name(value)));
}

tl::expected<Value, Complaint> value_from_text(const Parameter& parameter, std::string_view key,
                                               std::string_view text) {
  text = trimmed(text);
  if (parameter.type == ValueType::text) {
    return Value(std::string(is_quoted(text) ? text.substr(1, text.size() - 2) : text));
  }
  if (text.empty()) return tl::unexpected(wrong_type(parameter, key, "nothing"));
  if (parameter.type == ValueType::word) {
    if (const auto number = parsed<std::int64_t>(text)) return checked_word(parameter, key, *number);
    return checked_word(parameter, key,
                        std::string(is_quoted(text) ? text.substr(1, text.size() - 2) : text));
  }
  return checked_value(parameter, key, value_of_any_type(text));
}

std::string toml_text(const Value& value) {
  struct Writer {
    std::string operator()(bool on) const { return on ? "true" : "false"; }
    std::string operator()(std::int64_t integer) const { return fmt::format("{}", integer); }
    std::string operator()(double number) const { return number_text(number); }
    std::string operator()(const std::string& text) const { return quoted(text); }
    std::string operator()(const std::array<double, 2>& pair) const {
      return fmt::format("[{}, {}]", number_text(pair[0]), number_text(pair[1]));
    }
  };
  return std::visit(Writer{}, value);
}

std::string range_text(const Parameter& parameter) {
  if (parameter.type == ValueType::word) {
    const std::vector<Choice> choices = choices_of(parameter);
    std::string text;
    for (std::size_t i = 0; i < choices.size(); ++i) {
      if (i > 0) text += i + 1 == choices.size() ? " or " : ", ";
      text += choices[i].word;
      if (choices[i].number) text += fmt::format(" ({})", *choices[i].number);
    }
    return text;
  }
  const bool low = std::isfinite(parameter.minimum);
  const bool high = std::isfinite(parameter.maximum);
  if (low && high && !parameter.above_minimum) {
    return fmt::format("{} to {}", limit_text(parameter.minimum), limit_text(parameter.maximum));
  }
  std::string text;
  if (low) {
    text =
        fmt::format("{} {}", parameter.above_minimum ? "above" : "at least", limit_text(parameter.minimum));
  }
  if (high) text += fmt::format("{}at most {}", low ? ", " : "", limit_text(parameter.maximum));
  return text;
}

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  std::string out(text.substr(0, kLongest));
  for (char& c : out) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) c = '?';
  }
  if (text.size() > kLongest) {
    // A cut must not leave the first bytes of a UTF-8 character behind.
    while (!out.empty() && (static_cast<unsigned char>(out.back()) & 0xC0U) == 0x80U) out.pop_back();
    if (!out.empty() && static_cast<unsigned char>(out.back()) >= 0xC0U) out.pop_back();
    out += "...";
  }
  return out;
}

}  // namespace kerf
