// kerf path: the executed toolpath as a table or as JSON Lines.

#include <fmt/format.h>
#include <memory>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/job.hpp"
#include "report/json_lines.hpp"
#include "report/path_table.hpp"

namespace kerf {
namespace {

struct PathCounts {
  std::uint64_t moves = 0;
  std::uint64_t rapid = 0;
  std::uint64_t arcs = 0;
  int alarms = 0;
  int warnings = 0;

  void add(const Action& action) {
    if (const auto* move = std::get_if<Move>(&action.what)) {
      ++moves;
      rapid += move->mode == MoveMode::rapid ? 1 : 0;
      arcs += is_arc(move->mode) ? 1 : 0;
    } else if (const auto* alarm = std::get_if<Alarm>(&action.what)) {
      (stops_program(*alarm) ? alarms : warnings) += 1;
    }
  }
};

/// Pulls the whole program through `visit(action)`; the counts of what came.
template <class Visit>
PathCounts pull(Job& job, const Source& source, Visit visit) {
  ProgressLine progress;
  PathCounts counts;
  std::uint32_t seen = 0;
  while (const Action* action = job.next()) {
    if ((++seen & 0xFFFFU) == 0) progress.show(share_read(source, *action), source.name());
    counts.add(*action);
    visit(*action);
  }
  return counts;
}

PathCounts print_path(const PathOptions& options, const Prepared& prepared, Job& job, ResultStream& out) {
  const Source& source = *prepared.source;
  const FeedPolicy& policy = prepared.controller.feed_policy;
  const auto feed = [&policy](const Move& move) { return policy.effective(move.feed); };
  if (options.json) {
    const JsonLines lines(prepared.controller.machine, feed);
    return pull(job, source, [&](const Action& action) {
      lines.write(action, out.text());
      out.overflow();
    });
  }
  PathTable table(prepared.controller.machine, feed);
  table.header(out.text());
  return pull(job, source, [&](const Action& action) {
    table.write(action, out.text());
    out.overflow();
    print_alarm(action, job, options.common);
  });
}

}  // namespace

int path_command(const PathOptions& options) {
  const auto prepared = prepare(options.file, options.common);
  if (!prepared) return kExitUsage;
  ResultStream out;
  const auto job = std::make_unique<Job>(prepared->controller, prepared->source);
  PathCounts counts;
  if (options.quiet) {
    counts = pull(*job, *prepared->source,
                  [&](const Action& action) { print_alarm(action, *job, options.common); });
    out.text() += fmt::format("blocks {}\nmoves {}\nrapid {}\narcs {}\nwarnings {}\nalarms {}\n",
                              job->interpreter().blocks(), counts.moves, counts.rapid, counts.arcs,
                              counts.warnings, counts.alarms);
  } else {
    counts = print_path(options, *prepared, *job, out);
  }
  out.flush();
  if (!out.good()) return kExitUsage;
  return counts.alarms > 0 ? kExitAlarm : kExitGood;
}

}  // namespace kerf
