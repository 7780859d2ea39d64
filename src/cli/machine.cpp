// kerf machine init | check | show: machine files.

#include <fmt/format.h>
#include <memory>
#include <sys/stat.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/job.hpp"
#include "machine/machine_text.hpp"
#include "report/atomic_file.hpp"

namespace kerf {
int machine_init_command(const MachineOptions& options) {
  const auto controller = prepare_controller(options.common);
  if (!controller) return kExitUsage;
  const std::string text = init_text(schema_of(*controller->dialect), controller->dialect->name);
  if (!options.file || *options.file == "-") {
    ResultStream out;
    out.text() = text;
    out.flush();
    return out.good() ? kExitGood : kExitUsage;
  }
  struct stat status {};
  if (!options.force && ::stat(options.file->c_str(), &status) == 0) {
    print_error(fmt::format("{} exists already", *options.file),
                "choose another name, or overwrite it with --force");
    return kExitUsage;
  }
  if (const auto written = write_file(*options.file, text); !written) {
    print_error(written.error().message, written.error().remedy);
    return kExitUsage;
  }
  return kExitGood;
}

int machine_check_command(const MachineOptions& options) {
  CommonOptions common = options.common;
  common.machine_file = options.file;
  const auto controller = prepare_controller(common);
  if (!controller) return kExitUsage;
  const auto axes = static_cast<std::uint64_t>(controller->machine.axes.size());
  ResultStream out;
  out.text() = fmt::format("{}: good, a {} machine '{}' with {}\n", *options.file, controller->dialect->title,
                           controller->machine.name, count_text(axes, "axis", "axes"));
  out.flush();
  return out.good() ? kExitGood : kExitUsage;
}

int machine_show_command(const MachineOptions& options) {
  CommonOptions common = options.common;
  if (options.file) common.machine_file = options.file;
  const auto controller = prepare_controller(common);
  if (!controller) return kExitUsage;
  ResultStream out;
  out.text() = show_text(controller->settings);
  out.flush();
  return out.good() ? kExitGood : kExitUsage;
}

}  // namespace kerf
