// kerf alarms: what the dialect can raise, and one alarm explained.

#include <fmt/format.h>
#include <memory>
#include <unistd.h>
#include <vector>

#include "base/edit_distance.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/job.hpp"
#include "report/alarm_catalogue.hpp"

namespace kerf {
namespace {

std::string proposal(std::string_view code, std::span<const AlarmKind> alarms) {
  const std::string_view near = nearest_word(code, alarms, [](const AlarmKind& kind) { return kind.detail; });
  if (near.empty()) return "`kerf alarms` lists them all";
  return fmt::format("did you mean {}? `kerf alarms` lists them all", near);
}

/// The alarm of that name in the dialect asked for; without one asked for, in any that has it.
std::vector<const AlarmKind*> find_anywhere(const AlarmsOptions& options, const Dialect& dialect) {
  auto found = find_alarms(dialect.alarms, *options.code);
  if (!found.empty() || options.common.dialect || options.common.machine_file) return found;
  for (const Dialect& other : dialects()) {
    for (const AlarmKind* kind : find_alarms(other.alarms, *options.code)) found.push_back(kind);
  }
  return found;
}

}  // namespace

int alarms_command(const AlarmsOptions& options) {
  const auto controller = prepare_controller(options.common);
  if (!controller) return kExitUsage;
  const Dialect& dialect = *controller->dialect;
  ResultStream out;
  if (!options.code) {
    (options.json ? append_alarms_json : append_alarm_table)(out.text(), dialect.alarms);
    out.flush();
    return out.good() ? kExitGood : kExitUsage;
  }
  const auto found = find_anywhere(options, dialect);
  if (found.empty()) {
    print_error(fmt::format("{} has no alarm '{}'", dialect.title, *options.code),
                proposal(*options.code, dialect.alarms));
    return kExitUsage;
  }
  const int width = style_of_stream(STDOUT_FILENO, ColorChoice::never).width;
  for (const AlarmKind* kind : found) {
    if (options.json) {
      append_alarms_json(out.text(), {kind, 1});
    } else {
      append_alarm_explained(out.text(), *kind, width);
    }
  }
  out.flush();
  return out.good() ? kExitGood : kExitUsage;
}

}  // namespace kerf
