#include "report/html_sections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <string_view>

#include "report/alarm_text.hpp"
#include "report/html_source.hpp"
#include "report/number_text.hpp"
#include "report/source_excerpt.hpp"
#include "report/summary.hpp"
#include "report/text_escape.hpp"

namespace kerf {
namespace {

struct TimeShare {
  std::string_view style;
  std::string_view label;
  double seconds;
};

/// Percent of a whole, 0 to 100; 0 when there is no whole.
double percent_of(double part, double whole) {
  if (!(whole > 0.0) || !std::isfinite(part)) return 0.0;
  return std::clamp(part / whole * 100.0, 0.0, 100.0);
}

void append_card(std::string& out, std::string_view label, std::string_view value, std::string_view unit,
                 std::string_view note) {
  out += fmt::format("<div class=\"card\"><dt>{}</dt><dd><b>{}</b>", label, value);
  if (!unit.empty()) out += fmt::format(" <span class=\"unit\">{}</span>", unit);
  if (!note.empty()) out += fmt::format("<small>{}</small>", note);
  out += "</dd></div>\n";
}

void append_time_card(std::string& out, const RunSummary& summary) {
  const std::array<TimeShare, 5> shares{{{"cutting", "cutting", summary.cutting_s},
                                         {"rapid", "rapid", summary.rapid_s},
                                         {"dwell", "dwell", summary.dwell_s},
                                         {"tool", "tool change", summary.tool_change_s},
                                         {"spindle", "spindle", summary.spindle_wait_s}}};
  out +=
      fmt::format("<div class=\"card time\"><dt>Time</dt><dd><b>{}</b> <span class=\"unit\">h:mm:ss</span>\n",
                  clock_text(summary.time_s));
  out += "<div class=\"shares\" aria-hidden=\"true\">";
  for (const TimeShare& share : shares) {
    const double percent = percent_of(share.seconds, summary.time_s);
    if (percent <= 0.0) continue;
    out +=
        fmt::format("<i class=\"share-{}\" style=\"width:{}%\"></i>", share.style, rounded_text(percent, 2));
  }
  out += "</div>\n<ul class=\"share-list\">";
  for (const TimeShare& share : shares) {
    if (!(share.seconds > 0.0)) continue;
    out += fmt::format("<li><i class=\"share-{}\"></i>{} {} <span>{} %</span></li>", share.style, share.label,
                       clock_text(share.seconds), fixed_text(percent_of(share.seconds, summary.time_s), 0));
  }
  out += "</ul></dd></div>\n";
}

/// A peak with a bar that shows how much of the machine's limit it takes.
void append_peak_cell(std::string& out, double peak, double limit) {
  const double percent = percent_of(peak, limit);
  out += fmt::format(
      "<td><span class=\"meter\"><i style=\"width:{}%\"></i></span>{} <small>{} % of {}</small></td>",
      rounded_text(percent, 1), fixed_text(peak, 1), fixed_text(percent, 0), rounded_text(limit, 1));
}

/// The text an alarm's span points into: that of the program whose action carries the alarm.
std::string_view source_of_alarm(const ReportInput& input, const Alarm& alarm) {
  if (!input.source_of_program) return input.source_text;
  for (const TimedAction& timed : input.record.actions) {
    const auto* raised = std::get_if<Alarm>(&timed.action.what);
    if (raised != nullptr && raised->kind == alarm.kind && raised->span == alarm.span) {
      return source_of(input, timed.action.origin);
    }
  }
  return input.source_text;
}

void append_source_line(std::string& out, std::string_view source, const Alarm& alarm) {
  if (line_of(source, alarm.span).empty()) return;
  constexpr int kWholeLine = 2000;  // the page scrolls; only an absurd line is cut
  const Excerpt excerpt = excerpt_of(source, alarm.span, kWholeLine);
  out += fmt::format(
      "<pre tabindex=\"0\"><span class=\"number\">{:>5} │ </span>{}\n<span class=\"number\">      │ </span>",
      alarm.span.line, xml_text(excerpt.text));
  out.append(static_cast<std::size_t>(excerpt.indent), ' ');
  out += "<span class=\"caret\">^" + std::string(static_cast<std::size_t>(excerpt.width - 1), '~') +
         "</span></pre>\n";
}

void append_alarm(std::string& out, const ReportInput& input, const Alarm& alarm) {
  const std::string_view word = severity_word(alarm.kind->severity);
  out += fmt::format(
      "<li class=\"{}\"><h3><span class=\"badge\">{}</span> {} <span class=\"code\">{}</span></h3>\n", word,
      word, xml_text(alarm.kind->name), xml_text(short_name(*alarm.kind)));
  if (!alarm.message.empty()) out += fmt::format("<p>{}</p>\n", xml_text(alarm.message.view()));
  if (alarm.span.line > 0) {
    out += fmt::format("<p class=\"place\">line {}, column {}</p>\n", alarm.span.line, alarm.span.column);
  }
  append_source_line(out, source_of_alarm(input, alarm), alarm);
  out += "<dl>";
  if (!alarm.kind->cause.empty())
    out += fmt::format("<dt>Cause</dt><dd>{}</dd>", xml_text(alarm.kind->cause));
  if (!remedy_of(alarm).empty()) out += fmt::format("<dt>Write</dt><dd>{}</dd>", xml_text(remedy_of(alarm)));
  out += "</dl></li>\n";
}

}  // namespace

void append_cards(std::string& out, const RunSummary& summary) {
  const auto alarms = std::count_if(summary.alarms.begin(), summary.alarms.end(),
                                    [](const Alarm& alarm) { return stops_program(alarm); });
  const auto warnings = static_cast<std::ptrdiff_t>(summary.alarms.size()) - alarms;
  out += "<dl class=\"cards\">\n";
  append_time_card(out, summary);
  append_card(out, "Cutting path", fixed_text(summary.cutting_mm, 1), "mm", "");
  append_card(out, "Rapid path", fixed_text(summary.rapid_mm, 1), "mm", "");
  append_card(out, "Blocks", grouped_text(summary.blocks), "",
              grouped_text(summary.moves) + (summary.moves == 1 ? " move" : " moves"));
  append_card(out, "Alarms", fmt::format("{}", alarms), "",
              fmt::format("{} warning{}", warnings, warnings == 1 ? "" : "s"));
  out += "</dl>\n";
}

void append_axis_table(std::string& out, const RunSummary& summary, const Machine& machine) {
  if (summary.axes.empty()) return;
  out +=
      "<div class=\"scroll-x\" tabindex=\"0\" role=\"region\" aria-label=\"Axes\"><table class=\"axes\">\n"
      "<thead><tr><th scope=\"col\">Axis</th><th scope=\"col\">Low</th><th scope=\"col\">High</th>"
      "<th scope=\"col\">Travel</th><th scope=\"col\">Peak speed, per min</th>"
      "<th scope=\"col\">Peak acceleration, per s²</th>"
      "<th scope=\"col\" title=\"Change of velocity where two moves meet\">Corner step, per s</th>"
      "</tr></thead>\n"
      "<tbody>\n";
  for (const Axis axis : summary.axes) {
    const AxisBounds& bounds = summary.bounds[index(axis)];
    const AxisPeak& peak = summary.peak[index(axis)];
    const AxisSettings& settings = machine[axis];
    const std::string_view unit = settings.type == AxisType::rotary ? "°" : "mm";
    out += fmt::format("<tr><th scope=\"row\">{} <small>{}</small></th><td>{}</td><td>{}</td><td>{}</td>",
                       letter(axis), unit, fixed_text(bounds.low, 3), fixed_text(bounds.high, 3),
                       fixed_text(bounds.high - bounds.low, 3));
    append_peak_cell(out, peak.velocity, speed_limit(settings));
    append_peak_cell(out, peak.acceleration, settings.acceleration);
    out += fmt::format("<td>{}</td></tr>\n", fixed_text(peak.corner_step, 2));
  }
  out += "</tbody></table></div>\n";
}

void append_alarms(std::string& out, const ReportInput& input) {
  constexpr std::size_t kMost = 200;
  const auto& alarms = input.record.summary.alarms;
  if (alarms.empty()) return;
  out +=
      "<section aria-labelledby=\"alarms-title\">\n<h2 id=\"alarms-title\">Alarms and warnings</h2>\n"
      "<ol class=\"alarms\">\n";
  for (std::size_t i = 0; i < std::min(alarms.size(), kMost); ++i) append_alarm(out, input, alarms[i]);
  out += "</ol>\n";
  if (alarms.size() > kMost) {
    out += fmt::format("<p>The first {} of {} are shown.</p>\n", kMost, alarms.size());
  }
  out += "</section>\n";
}

}  // namespace kerf
