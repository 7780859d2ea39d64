// kerf check: every alarm of the programs, without motion planning.

#include <fmt/format.h>
#include <memory>
#include <unistd.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/job.hpp"
#include "report/diagnostic.hpp"
#include "report/text_escape.hpp"

namespace kerf {
namespace {

struct Counts {
  std::uint64_t alarms = 0;
  std::uint64_t warnings = 0;
};

Counts check_program(const Prepared& prepared, const CheckOptions& options, ResultStream& out) {
  const Source& source = *prepared.source;
  const DiagnosticStyle style = style_of_stream(STDOUT_FILENO, options.common.color);
  auto job = std::make_unique<Job>(prepared.controller, prepared.source);
  ProgressLine progress;
  Counts counts;
  std::uint32_t seen = 0;
  while (const Action* action = job->next()) {
    if ((++seen & 0xFFFU) == 0) progress.show(share_read(source, *action), source.name());
    const auto* alarm = std::get_if<Alarm>(&action->what);
    if (alarm == nullptr) continue;
    const bool stops = stops_program(*alarm);
    (stops ? counts.alarms : counts.warnings) += 1;
    const auto place = job->source_of(*action);
    append_diagnostic(out.text(), place->name(), place->text(), *alarm, style);
    out.text() += '\n';
    out.overflow();
    if (counts.alarms >= static_cast<std::uint64_t>(options.max_alarms)) {
      append_visible(out.text(), source.name());
      out.text() += fmt::format(": {}, the rest is not checked (--max-alarms)\n",
                                count_text(counts.alarms, "alarm", "alarms"));
      break;
    }
    if (stops) job->recover();
  }
  append_visible(out.text(), source.name());
  out.text() += fmt::format(": {}, {}, {} executed\n", count_text(counts.alarms, "alarm", "alarms"),
                            count_text(counts.warnings, "warning", "warnings"),
                            count_text(job->interpreter().blocks(), "block", "blocks"));
  return counts;
}

}  // namespace

int check_command(const CheckOptions& options) {
  ResultStream out;
  int status = kExitGood;
  for (const std::string& file : options.files) {
    const auto prepared = prepare(file, options.common);
    if (!prepared) {
      status = kExitUsage;
      continue;
    }
    const Counts counts = check_program(*prepared, options, out);
    if (counts.alarms > 0 && status == kExitGood) status = kExitAlarm;
  }
  out.flush();
  return out.good() ? status : kExitUsage;
}

}  // namespace kerf
