#include "report/alarm_text.hpp"

#include "report/number_text.hpp"
#include "report/text_escape.hpp"

namespace kerf {

std::string short_name(const AlarmKind& kind) {
  const bool word = !kind.detail.empty() && kind.detail.front() >= 'a' && kind.detail.front() <= 'z';
  if (word) return std::string(kind.detail);
  std::string name(kind.code);
  if (!kind.detail.empty()) name.append(" ").append(kind.detail);
  return name;
}

std::string_view severity_word(Severity severity) {
  return severity == Severity::warning ? "warning" : "alarm";
}

void append_alarm_json(std::string& out, const Alarm& alarm, std::int32_t program) {
  const auto text = [&out](std::string_view key, std::string_view value) {
    out += ",\"";
    out += key;
    out += "\":";
    append_json_string(out, value);
  };
  out += "{\"event\":\"";
  out += severity_word(alarm.kind->severity);
  out += '"';
  text("code", alarm.kind->code);
  text("detail", alarm.kind->detail);
  text("name", alarm.kind->name);
  if (program >= 0) {
    out += ",\"program\":";
    append_integer(out, program);
  }
  out += ",\"line\":";
  append_integer(out, alarm.span.line);
  out += ",\"column\":";
  append_integer(out, alarm.span.column);
  text("message", message_of(alarm));
  text("remedy", remedy_of(alarm));
  out += '}';
}

}  // namespace kerf
