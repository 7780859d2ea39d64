#include "conformance/runner/entry.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <span>

#include "base/axis.hpp"
#include "conformance/runner/text.hpp"

namespace kerf::conformance {
namespace {

constexpr std::array<std::string_view, 9> kWatchKinds{"moves", "dwell", "spindle", "tool", "m",
                                                      "stop",  "alarm", "warning", "end"};
constexpr std::array<std::string_view, 4> kMoves{"rapid", "linear", "cw", "ccw"};

/// What may stand in an entry of one name.
struct Form {
  std::string_view name;
  std::string_view words;  ///< allowed words, separated by `|`; `#` an integer, `-#` a negative one, `*`
                           ///< anything; empty: none
  std::size_t fewest_words;
  std::size_t most_words;
  std::string_view numbers;  ///< keys of numbers, separated by blanks; `axes` any axis, `#` any integer,
                             ///< `*` anything
  std::string_view texts;    ///< keys of words
};

constexpr std::string_view kMoveNumbers =
    "axes m-axes c-axes s-axes center-axes F radius sweep turns line n program";

constexpr std::array kEvents{
    Form{"rapid", "", 0, 0, kMoveNumbers, ""},
    Form{"linear", "", 0, 0, kMoveNumbers, ""},
    Form{"cw", "", 0, 0, kMoveNumbers, "plane"},
    Form{"ccw", "", 0, 0, kMoveNumbers, "plane"},
    Form{"dwell", "", 0, 0, "s line n program", ""},
    Form{"spindle", "cw|ccw|off|orient", 1, 1, "rpm angle line n program A B C D E F G H", "timing"},
    Form{"tool", "#", 1, 1, "line n program", ""},
    Form{"m", "#|-#", 1, 1, "line n program A B C D E F G H", "timing"},
    Form{"stop", "optional", 0, 1, "line n program", ""},
    Form{"end", "", 0, 0, "line n program", ""},
    Form{"alarm", "*", 0, 1, "line column n program", ""},
    Form{"warning", "*", 0, 1, "line column n program", ""},
    Form{"refused", "*", 0, 1, "", ""},
};

constexpr std::array kFacts{
    Form{"W", "", 0, 0, "axes", ""},
    Form{"M", "", 0, 0, "axes", ""},
    Form{"modal", "*", 1, 99, "", ""},
    Form{"feed", "", 0, 0, "feed", ""},
    Form{"spindle", "on|off", 1, 1, "rpm", ""},
    Form{"register", "", 0, 0, "rpm", ""},
    Form{"tool", "", 0, 0, "tool", ""},
    Form{"output", "", 0, 0, "", "#"},
    Form{"offset", "EXT|G54|G55|G56|G57|G58|G59", 1, 1, "axes", ""},
    Form{"shift", "", 0, 0, "axes", ""},
    Form{"radius", "", 0, 0, "#", ""},
    Form{"length", "", 0, 0, "#", ""},
    Form{"program", "", 0, 0, "program", ""},
    Form{"n", "", 0, 0, "n", ""},
    Form{"#", "", 0, 0, "#", ""},
    Form{"var", "", 0, 0, "*", ""},
    Form{"ramps", "", 0, 0, "ta td ts", ""},
    Form{"time", "", 0, 0, "time", ""},
    Form{"motion_time", "", 0, 0, "motion_time", ""},
    Form{"at", "", 0, 0, "t axes", ""},
    Form{"same", "", 0, 0, "", ""},
};

/// Half a unit of the last decimal written, or the rounding of doubles for a whole number.
double tolerance_as_written(std::string_view number) {
  constexpr double kRounding = 1e-9;
  const std::size_t point = number.find('.');
  if (point == std::string_view::npos) return kRounding;
  double unit = 1.0;
  for (std::size_t i = point + 1; i < number.size(); ++i) unit /= 10.0;
  return unit / 2.0 + kRounding;
}

bool is_integer(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_axis(std::string_view text) {
  return text.size() == 1 && axis_from_letter(text[0]).has_value();
}

bool allows_key(std::string_view allowed, std::string_view key) {
  for (const std::string& item : words_of(allowed)) {
    if (item == "*" || item == key) return true;
    if ((item == "axes" && is_axis(key)) || (item == "#" && is_integer(key))) return true;
    const std::size_t axes = item.find("-axes");
    if (axes == std::string::npos || axes == 0) continue;
    const std::string_view prefix = std::string_view(item).substr(0, axes);
    if (key.substr(0, prefix.size()) == prefix && is_axis(key.substr(prefix.size()))) return true;
  }
  return false;
}

bool allows_word(std::string_view allowed, std::string_view word) {
  for (const std::string& item : parts_of(allowed, '|')) {
    if (item == "*" || item == word || (item == "#" && is_integer(word))) return true;
    if (item == "-#" && word.starts_with('-') && is_integer(word.substr(1))) return true;
  }
  return false;
}

std::string fault(const Entry& entry, std::span<const Form> forms, std::string_view what) {
  const auto form = std::find_if(forms.begin(), forms.end(),
                                 [&](const Form& candidate) { return candidate.name == entry.name; });
  if (form == forms.end()) return fmt::format("'{}' is no {}", entry.name, what);
  if (entry.words.size() < form->fewest_words || entry.words.size() > form->most_words) {
    return fmt::format("'{}' has {} words where {} to {} are allowed", entry.name, entry.words.size(),
                       form->fewest_words, form->most_words);
  }
  for (const std::string& word : entry.words) {
    if (!allows_word(form->words, word)) return fmt::format("'{}' cannot be '{}'", entry.name, word);
  }
  for (const Field& field : entry.fields) {
    const bool number = std::holds_alternative<double>(field.value);
    if (allows_key(number ? form->numbers : form->texts, field.key)) continue;
    const bool known = allows_key(number ? form->texts : form->numbers, field.key);
    if (known) return fmt::format("the value of '{}' in '{}' has the wrong type", field.key, entry.name);
    return fmt::format("'{}' has no '{}'", entry.name, field.key);
  }
  return {};
}

}  // namespace

const Field* Entry::find(std::string_view key) const {
  for (const Field& field : fields) {
    if (field.key == key) return &field;
  }
  return nullptr;
}

std::string entry_text(const Entry& entry) {
  const bool assignment =
      entry.words.empty() && entry.fields.size() == 1 && entry.fields[0].key == entry.name;
  std::string text = assignment ? "" : entry.name;
  for (const std::string& word : entry.words) text += " " + word;
  for (const Field& field : entry.fields) {
    const double* number = std::get_if<double>(&field.value);
    const std::string value = number != nullptr ? number_text(*number) : std::get<std::string>(field.value);
    text += fmt::format("{}{}={}", text.empty() || entry.name == "#" ? "" : " ", field.key, value);
  }
  return text;
}

tl::expected<Entry, std::string> parse_entry(std::string_view text, std::uint32_t line) {
  Entry entry;
  entry.line = line;
  for (const std::string& word : words_of(text)) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) {
      if (!entry.fields.empty()) return tl::unexpected(fmt::format("'{}' stands behind a KEY=VALUE", word));
      if (entry.name.empty())
        entry.name = word;
      else
        entry.words.push_back(word);
      continue;
    }
    const bool numbered = word[0] == '#';
    const bool variable = numbered || entry.name == "var";
    const std::string key = word.substr(numbered ? 1 : 0, equals - (numbered ? 1 : 0));
    const std::string value = word.substr(equals + 1);
    if (key.empty() || value.empty()) return tl::unexpected(fmt::format("'{}' is no KEY=VALUE", word));
    if (entry.find(key) != nullptr) return tl::unexpected(fmt::format("'{}' is given twice", key));
    if (entry.name.empty()) entry.name = numbered ? "#" : key;
    const std::optional<double> number = number_of(value);
    std::optional<double> tolerance;
    if (variable) tolerance = tolerance_as_written(value);
    if (number)
      entry.fields.push_back({key, *number, tolerance});
    else
      entry.fields.push_back({key, value});
  }
  return entry;
}

std::string event_fault(const Entry& entry) {
  return fault(entry, kEvents, "event");
}

std::string fact_fault(const Entry& entry) {
  const std::string text = fault(entry, kFacts, "fact");
  if (!text.empty() || entry.name == "same" || entry.name == "modal" || entry.name == "spindle") return text;
  if (entry.fields.empty()) return fmt::format("'{}' states nothing", entry.name);
  if (entry.name == "at" && entry.find("t") == nullptr) return "'at' needs t=";
  return {};
}

std::string watch_kind(std::string_view event_name) {
  if (std::find(kMoves.begin(), kMoves.end(), event_name) != kMoves.end()) return "moves";
  return std::string(event_name);
}

bool is_watch_kind(std::string_view word) {
  return std::find(kWatchKinds.begin(), kWatchKinds.end(), word) != kWatchKinds.end();
}

std::set<std::string> default_watch() {
  std::set<std::string> kinds(kWatchKinds.begin(), kWatchKinds.end());
  kinds.erase("warning");
  return kinds;
}

}  // namespace kerf::conformance
