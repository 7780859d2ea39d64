// kerf alarms: what the dialect can raise, and one alarm explained.

#include <fmt/format.h>
#include <memory>
#include <unistd.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/job.hpp"
#include "report/alarm_catalogue.hpp"

namespace kerf {
namespace {

struct AlarmsOptions {
  CommonOptions common;
  std::optional<std::string> code;
  bool json = false;
};

int alarms(const AlarmsOptions& options) {
  const auto controller = prepare_controller(options.common);
  if (!controller) return kExitUsage;
  const Dialect& dialect = *controller->dialect;
  ResultStream out;
  if (!options.code) {
    (options.json ? append_alarms_json : append_alarm_table)(out.text(), dialect.alarms);
    out.flush();
    return out.good() ? kExitGood : kExitUsage;
  }
  const auto found = find_alarms(dialect.alarms, *options.code);
  if (found.empty()) {
    print_error(fmt::format("{} has no alarm '{}'", dialect.title, *options.code),
                "`kerf alarms` lists them all");
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

}  // namespace

void add_alarms(CLI::App& app, CommandAction& action) {
  auto options = std::make_shared<AlarmsOptions>();
  CLI::App* command = app.add_subcommand("alarms", "List every alarm, or explain one");
  command->add_option("CODE", options->code, "Alarm code or word, for example arc-radius")->type_name("");
  command->add_flag("--json", options->json, "JSON");
  add_machine_options(*command, options->common);
  command->footer("Examples:\n  kerf alarms\n  kerf alarms arc-radius");
  command->callback([&action, options] { action = [options] { return alarms(*options); }; });
}

}  // namespace kerf
