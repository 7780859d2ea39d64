#include "report/check_report.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

#include "report/alarm_text.hpp"
#include "report/text_escape.hpp"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

/// A subprogram has its alarms in the row of the program that called it, unless they are about its file.
std::string count_or_dash(const CheckedProgram& program, std::uint64_t count) {
  const bool own = program.outcome == CheckOutcome::executed || count > 0;
  return own ? fmt::format("{}", count) : "-";
}

std::string outcome_text(const CheckedProgram& program) {
  switch (program.outcome) {
    case CheckOutcome::executed:
      return program.alarms > 0 ? "alarms" : program.warnings > 0 ? "warnings" : "good";
    case CheckOutcome::called:
      return "subprogram of " + program.caller;
    case CheckOutcome::not_called:
      return "subprogram, not called: only read";
    case CheckOutcome::unreadable:
      return program.message;
  }
  return {};
}

std::string result_text(const CheckedProgram& program) {
  return outcome_text(program) + (program.remark.empty() ? "" : "; " + program.remark);
}

std::string visible_text(std::string_view text) {
  std::string result;
  append_visible(result, text);
  return result;
}

/// "O001.gcd:12:5: alarm 1FC3H 0313H: The radii differ. Correct I and J."
std::string finding_line(const CheckFinding& finding) {
  const Alarm& alarm = finding.alarm;
  return fmt::format("{}:{}:{}: {} {}: {} {}", finding.file, alarm.span.line, alarm.span.column,
                     severity_word(alarm.kind->severity), short_name(*alarm.kind), message_of(alarm),
                     remedy_of(alarm));
}

/// A path as a relative reference (RFC 3986): all but its safe characters in per cent.
std::string uri_of(std::string_view path) {
  std::string uri;
  for (const char c : path) {
    const bool safe = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      std::string_view("-._~/").find(c) != std::string_view::npos;
    if (safe)
      uri += c;
    else
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

Json location_of(const CheckFinding& finding) {
  const SourceSpan& span = finding.alarm.span;
  Json location;
  location["physicalLocation"]["artifactLocation"]["uri"] = uri_of(finding.file);
  if (span.line > 0) {
    location["physicalLocation"]["region"] = {
        {"startLine", span.line}, {"startColumn", finding.first_column}, {"endColumn", finding.end_column}};
  }
  return location;
}

Json rule_of(const AlarmKind& kind) {
  return {{"id", short_name(kind)},
          {"shortDescription", {{"text", kind.name}}},
          {"fullDescription", {{"text", kind.cause}}},
          {"help", {{"text", kind.remedy}}}};
}

/// A test case is either skipped or has failed.
bool is_skipped(const CheckedProgram& program) {
  const bool sub = program.outcome == CheckOutcome::called || program.outcome == CheckOutcome::not_called;
  return sub && program.alarms == 0;
}

/// What SARIF says of the run itself: the programs that could not be checked.
Json invocation_of(std::span<const CheckedProgram> programs) {
  Json notes = Json::array();
  for (const CheckedProgram& program : programs) {
    if (program.outcome != CheckOutcome::unreadable) continue;
    Json location;
    location["physicalLocation"]["artifactLocation"]["uri"] = uri_of(program.file);
    notes.push_back({{"level", "error"},
                     {"message", {{"text", program.message}}},
                     {"locations", Json::array({std::move(location)})}});
  }
  return {{"executionSuccessful", notes.empty()}, {"toolExecutionNotifications", std::move(notes)}};
}

/// All alarms of a program in one element, since a test case fails once.
void append_failure(const CheckedProgram& program, std::string& out) {
  const CheckFinding* first = nullptr;
  std::string lines;
  for (const CheckFinding& finding : program.findings) {
    if (!stops_program(finding.alarm)) continue;
    if (first == nullptr) first = &finding;
    lines += finding_line(finding) + '\n';
  }
  if (first == nullptr) return;
  out += fmt::format("<failure type=\"{}\" message=\"{}\">{}</failure>\n",
                     xml_text(short_name(*first->alarm.kind)), xml_text(message_of(first->alarm)),
                     xml_text(lines));
}

}  // namespace

std::string check_table(std::span<const CheckedProgram> programs) {
  std::size_t width = std::string_view("program").size();
  for (const CheckedProgram& program : programs) {
    width = std::max(width, static_cast<std::size_t>(visible_width(program.file)));
  }
  std::string out =
      fmt::format("{:<{}}  {:>8} {:>8} {:>10}  result\n", "program", width, "alarms", "warnings", "blocks");
  std::uint64_t faulty = 0;
  std::uint64_t unreadable = 0;
  std::uint64_t only_read = 0;
  for (const CheckedProgram& program : programs) {
    const std::string name = visible_text(program.file);
    const auto padding = width - static_cast<std::size_t>(visible_width(program.file));
    out += fmt::format("{}{:{}}  {:>8} {:>8} {:>10}  {}\n", name, "", padding,
                       count_or_dash(program, program.alarms), count_or_dash(program, program.warnings),
                       count_or_dash(program, program.blocks), visible_text(result_text(program)));
    faulty += program.alarms > 0 ? 1 : 0;
    unreadable += program.outcome == CheckOutcome::unreadable ? 1 : 0;
    only_read += program.outcome == CheckOutcome::not_called ? 1 : 0;
  }
  out += fmt::format("{} {}, {} with alarms", programs.size(), programs.size() == 1 ? "program" : "programs",
                     faulty == 0 ? "none" : fmt::format("{}", faulty));
  if (only_read > 0) out += fmt::format(", {} only read", only_read);
  if (unreadable > 0) out += fmt::format(", {} not checked", unreadable);
  out += '\n';
  return out;
}

std::string junit_text(std::span<const CheckedProgram> programs) {
  const auto count = [&](auto matches) { return std::count_if(programs.begin(), programs.end(), matches); };
  const auto failures = count([](const CheckedProgram& p) { return p.alarms > 0; });
  const auto errors = count([](const CheckedProgram& p) { return p.outcome == CheckOutcome::unreadable; });
  const auto skipped = count(is_skipped);
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out += fmt::format(
      "<testsuites>\n<testsuite name=\"kerf check\" tests=\"{}\" failures=\"{}\" errors=\"{}\" "
      "skipped=\"{}\">\n",
      programs.size(), failures, errors, skipped);
  for (const CheckedProgram& program : programs) {
    out += fmt::format("<testcase classname=\"kerf\" name=\"{}\">\n", xml_text(program.file));
    if (program.outcome == CheckOutcome::unreadable) {
      out += fmt::format("<error message=\"{}\"/>\n", xml_text(program.message));
    } else if (is_skipped(program)) {
      out += fmt::format("<skipped message=\"{}\"/>\n", xml_text(outcome_text(program)));
    }
    append_failure(program, out);
    out += "</testcase>\n";
  }
  return out + "</testsuite>\n</testsuites>\n";
}

std::string sarif_text(std::span<const CheckedProgram> programs, std::string_view version) {
  Json rules = Json::array();
  Json results = Json::array();
  std::set<const AlarmKind*> known;
  for (const CheckedProgram& program : programs) {
    for (const CheckFinding& finding : program.findings) {
      const AlarmKind& kind = *finding.alarm.kind;
      if (known.insert(&kind).second) rules.push_back(rule_of(kind));
      results.push_back(
          {{"ruleId", short_name(kind)},
           {"level", stops_program(finding.alarm) ? "error" : "warning"},
           {"message", {{"text", fmt::format("{} {}", message_of(finding.alarm), remedy_of(finding.alarm))}}},
           {"locations", Json::array({location_of(finding)})}});
    }
  }
  Json run;
  run["tool"]["driver"] = {{"name", "kerf"}, {"version", version}, {"rules", std::move(rules)}};
  run["columnKind"] = "unicodeCodePoints";
  run["invocations"] = Json::array({invocation_of(programs)});
  run["results"] = std::move(results);
  Json log;
  log["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  log["version"] = "2.1.0";
  log["runs"] = Json::array({std::move(run)});
  return log.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace kerf
