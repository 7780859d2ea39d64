#include "report/alarm_catalogue.hpp"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>

#include "report/alarm_text.hpp"
#include "report/text_escape.hpp"
#include "report/text_wrap.hpp"

namespace kerf {
namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

bool is_code_and_detail(const AlarmKind& kind, std::string_view key) {
  const std::size_t code = kind.code.size();
  if (key.size() <= code || !same_word(kind.code, key.substr(0, code))) return false;
  key.remove_prefix(code);
  const std::size_t separators = key.find_first_not_of(" -/:");
  if (separators == 0 || separators == std::string_view::npos) return false;
  return same_word(kind.detail, key.substr(separators));
}

/// A sentence under a label, wrapped between words with a hanging indent.
void append_paragraph(std::string& out, std::string_view label, std::string_view sentence, int width) {
  if (sentence.empty()) return;
  constexpr int kIndent = 10;
  out += fmt::format("  {:<{}}", label, kIndent - 2);
  append_wrapped(out, sentence, kIndent, width);
}

void append_field(std::string& out, std::string_view key, std::string_view value) {
  out += '"';
  out += key;
  out += "\":";
  append_json_string(out, value);
}

}  // namespace

void append_alarm_table(std::string& out, std::span<const AlarmKind> kinds) {
  std::size_t code = 4;
  std::size_t detail = 6;
  for (const AlarmKind& kind : kinds) {
    code = std::max(code, kind.code.size());
    detail = std::max(detail, kind.detail.size());
  }
  auto end = std::back_inserter(out);
  fmt::format_to(end, "{:<{}}  {:<{}}  name\n", "code", code, "detail", detail);
  for (const AlarmKind& kind : kinds) {
    fmt::format_to(end, "{:<{}}  {:<{}}  {}{}\n", kind.code, code, kind.detail, detail, kind.name,
                   kind.severity == Severity::warning ? " (warning)" : "");
  }
}

void append_alarm_explained(std::string& out, const AlarmKind& kind, int width) {
  out += fmt::format("{} {}: {}\n", severity_word(kind.severity), short_name(kind), kind.name);
  append_paragraph(out, "code", kind.code, width);
  append_paragraph(out, "detail", kind.detail, width);
  append_paragraph(out, "cause", kind.cause, width);
  append_paragraph(out, "write", kind.remedy, width);
}

void append_alarms_json(std::string& out, std::span<const AlarmKind> kinds) {
  out += '[';
  std::string_view separator = "\n";
  for (const AlarmKind& kind : kinds) {
    out += separator;
    separator = ",\n";
    out += '{';
    append_field(out, "code", kind.code);
    out += ',';
    append_field(out, "detail", kind.detail);
    out += ',';
    append_field(out, "name", kind.name);
    out += ',';
    append_field(out, "severity", severity_word(kind.severity));
    out += ',';
    append_field(out, "cause", kind.cause);
    out += ',';
    append_field(out, "remedy", kind.remedy);
    out += '}';
  }
  out += "\n]\n";
}

std::vector<const AlarmKind*> find_alarms(std::span<const AlarmKind> kinds, std::string_view key) {
  std::vector<const AlarmKind*> found;
  for (const AlarmKind& kind : kinds) {
    const bool match =
        same_word(kind.detail, key) || same_word(kind.code, key) || is_code_and_detail(kind, key);
    if (match) found.push_back(&kind);
  }
  return found;
}

}  // namespace kerf
