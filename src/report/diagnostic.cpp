#include "report/diagnostic.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "report/alarm_text.hpp"
#include "report/source_excerpt.hpp"
#include "report/text_escape.hpp"
#include "report/text_wrap.hpp"

namespace kerf {
namespace {

/// ANSI escape sequences; all empty without colour.
struct Palette {
  std::string_view severity;
  std::string_view strong;
  std::string_view gutter;
  std::string_view off;
};

Palette palette_for(Severity severity, bool color) {
  if (!color) return {};
  constexpr std::string_view kRed = "\x1b[1;31m";
  constexpr std::string_view kYellow = "\x1b[1;33m";
  return {severity == Severity::warning ? kYellow : kRed, "\x1b[1m", "\x1b[1;34m", "\x1b[0m"};
}

/// Writes the parts of one diagnostic that share a left margin.
class DiagnosticWriter {
 public:
  DiagnosticWriter(std::string& out, const Palette& palette, int margin, int width)
      : out_(out), palette_(palette), margin_(margin), width_(width) {}

  void source_line(std::uint32_t line, const Excerpt& excerpt) {
    out_ += palette_.gutter;
    out_ += fmt::format("{:>{}} |", line, margin_);
    out_ += palette_.off;
    out_ += ' ';
    out_ += excerpt.text;
    out_ += '\n';
    gutter('|');
    out_.append(static_cast<std::size_t>(excerpt.indent) + 1, ' ');
    out_ += palette_.severity;
    out_ += '^';
    out_.append(static_cast<std::size_t>(excerpt.width - 1), '~');
    out_ += palette_.off;
    out_ += '\n';
  }

  /// One `= label: sentence` note, wrapped between words with a hanging indent.
  void note(std::string_view label, std::string_view sentence) {
    if (sentence.empty()) return;
    gutter('=');
    out_ += ' ';
    out_ += palette_.strong;
    out_ += label;
    out_ += ':';
    out_ += palette_.off;
    out_ += ' ';
    append_wrapped(out_, sentence, margin_ + 5 + static_cast<int>(label.size()), width_);
  }

 private:
  void gutter(char mark) {
    out_ += palette_.gutter;
    out_.append(static_cast<std::size_t>(margin_) + 1, ' ');
    out_ += mark;
    out_ += palette_.off;
  }

  std::string& out_;
  const Palette& palette_;
  int margin_;
  int width_;
};

void append_heading(std::string& out, std::string_view file_name, const Alarm& alarm,
                    const Palette& palette) {
  out += palette.strong;
  append_visible(out, file_name);
  if (alarm.span.line > 0) out += fmt::format(":{}:{}", alarm.span.line, alarm.span.column);
  out += ": ";
  out += palette.off;
  out += palette.severity;
  out += severity_word(alarm.kind->severity);
  out += ' ';
  out += short_name(*alarm.kind);
  out += ':';
  out += palette.off;
  out += ' ';
  out += palette.strong;
  append_visible(out, alarm.message.empty() ? alarm.kind->name : alarm.message.view());
  out += palette.off;
  out += '\n';
}

}  // namespace

void append_diagnostic(std::string& out, std::string_view file_name, std::string_view source,
                       const Alarm& alarm, const DiagnosticStyle& style) {
  const Palette palette = palette_for(alarm.kind->severity, style.color);
  append_heading(out, file_name, alarm, palette);
  const bool has_line = !line_of(source, alarm.span).empty();
  const int margin = has_line ? std::max(4, static_cast<int>(fmt::formatted_size("{}", alarm.span.line))) : 4;
  const int width = std::max(40, style.width);
  DiagnosticWriter writer(out, palette, margin, width);
  if (has_line) writer.source_line(alarm.span.line, excerpt_of(source, alarm.span, width - margin - 3));
  writer.note("cause", alarm.kind->cause);
  writer.note("write", remedy_of(alarm));
}

std::string diagnostic_text(std::string_view file_name, std::string_view source, const Alarm& alarm,
                            const DiagnosticStyle& style) {
  std::string out;
  append_diagnostic(out, file_name, source, alarm, style);
  return out;
}

}  // namespace kerf
