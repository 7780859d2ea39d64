#include "conformance/runner/run_case.hpp"

#include <fmt/format.h>
#include <optional>

#include "conformance/runner/event_match.hpp"
#include "conformance/runner/facts.hpp"
#include "conformance/runner/rig.hpp"

namespace kerf::conformance {
namespace {

std::string with_line_ends(const std::string& text, LineEnd line_end) {
  if (line_end == LineEnd::lf) return text;
  std::string result;
  for (const char c : text) {
    if (c == '\n')
      result += line_end == LineEnd::cr ? "\r" : "\r\n";
    else
      result += c;
  }
  return result;
}

std::string heading(const Case& test, const ProgramSection& section, std::string_view what) {
  const std::string program =
      test.programs.size() > 1 ? fmt::format(" of the program at line {}", section.line) : std::string();
  return fmt::format("{}{} (- expected, + found):\n", what, program);
}

}  // namespace

std::string run_case(const Case& test, const std::string& dialect) {
  auto rig = Rig::make(test, dialect);
  if (!rig) {
    const ProgramSection& section = test.programs.front();
    const std::string events = event_difference(section.expected, rig.error(), test.tolerance);
    return events.empty() ? std::string() : heading(test, section, "machine settings") + events;
  }
  std::string text;
  std::optional<ProgramRun> before;
  for (const ProgramSection& section : test.programs) {
    ProgramRun run = rig->run(section, with_line_ends(section.text, test.line_end));
    const std::string events =
        event_difference(section.expected, watched_events(run.events, test.watched), test.tolerance);
    if (!events.empty()) text += heading(test, section, "events") + events;
    const std::string facts =
        fact_differences(test, section, rig->controller(), run, before ? &*before : nullptr);
    if (!facts.empty()) text += heading(test, section, "facts") + facts;
    before = std::move(run);
  }
  return text;
}

}  // namespace kerf::conformance
