// kerf run: the program on the simulated machine in virtual time.

#include "motion/run.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <thread>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/file_clash.hpp"
#include "cli/interrupt.hpp"
#include "cli/job.hpp"
#include "cli/version.hpp"
#include "report/atomic_file.hpp"
#include "report/html_report.hpp"
#include "report/programmed_path.hpp"
#include "report/summary.hpp"
#include "report/svg_plot.hpp"
#include "report/trace_csv.hpp"

namespace kerf {
namespace {

bool file_failed(const FileError& error) {
  print_error(error.message, error.remedy);
  return true;
}

/// The trace file while the program runs: rows are collected and written in large pieces.
class TraceFile {
 public:
  TraceFile(AtomicFile file, const Machine& machine) : file_(std::move(file)), csv_(machine.axes) {
    csv_.header(text_);
  }

  void add(const Cycle& cycle, const AxisVector& actual) {
    if (error_) return;
    TraceRow row{cycle.time_s, cycle.origin.span.line, cycle.path_speed_mm_min, cycle.position, actual, {}};
    for (std::size_t i = 0; i < kAxisCount; ++i)
      row.velocity_per_min.values[i] = cycle.velocity.values[i] * 60.0;
    csv_.row(row, text_);
    constexpr std::size_t kChunk = std::size_t{1} << 20;
    if (text_.size() >= kChunk) write();
  }

  /// False: the message is on standard error.
  bool finish() {
    write();
    if (!error_) {
      if (auto done = file_.commit(); !done) error_ = done.error();
    }
    return !error_ || !file_failed(*error_);
  }

 private:
  void write() {
    if (error_) return;
    if (auto written = file_.write(text_); !written) error_ = written.error();
    text_.clear();
  }

  AtomicFile file_;
  TraceCsv csv_;
  std::string text_;
  std::optional<FileError> error_;
};

/// Holds virtual time back to the clock on the wall.
class Pace {
 public:
  void wait_until(double time_s) {
    std::this_thread::sleep_until(
        start_ + std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(time_s)));
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// All output files are opened before the run, so that a bad name costs no waiting.
struct Outputs {
  std::optional<AtomicFile> plot;
  std::optional<AtomicFile> report;
  std::optional<TraceFile> trace;
};

bool open_file(const std::optional<std::string>& name, std::optional<AtomicFile>& file) {
  if (!name) return true;
  auto opened = AtomicFile::open(*name);
  if (!opened) return !file_failed(opened.error());
  file = std::move(*opened);
  return true;
}

std::vector<NamedFile> output_names(const RunCommandOptions& options) {
  std::vector<NamedFile> names;
  const auto take = [&names](const std::optional<std::string>& path, std::string role) {
    if (path) names.push_back({*path, std::move(role)});
  };
  take(options.plot, "--plot");
  take(options.report, "--report");
  take(options.trace, "--trace");
  return names;
}

/// Nothing is read or written before the names are known to be good.
bool names_are_good(const RunCommandOptions& options) {
  const std::vector<NamedFile> outputs = output_names(options);
  for (const NamedFile& output : outputs) {
    if (output.path != "-") continue;
    print_error(fmt::format("{} writes to a file, not to -", output.role),
                "name a file; /dev/stdout is standard output");
    return false;
  }
  std::vector<NamedFile> inputs{{options.file, "the program"}};
  if (options.common.machine_file) inputs.push_back({*options.common.machine_file, "the machine file"});
  const auto clash = file_clash(inputs, outputs);
  if (clash) print_error(*clash, "give each output a name of its own");
  return !clash;
}

bool open_outputs(const RunCommandOptions& options, const Machine& machine, Outputs& outputs) {
  std::optional<AtomicFile> trace;
  if (!open_file(options.plot, outputs.plot) || !open_file(options.report, outputs.report) ||
      !open_file(options.trace, trace)) {
    return false;
  }
  if (trace) outputs.trace.emplace(std::move(*trace), machine);
  return true;
}

bool write_whole(AtomicFile& file, std::string_view text) {
  if (auto written = file.write(text); !written) return !file_failed(written.error());
  if (auto done = file.commit(); !done) return !file_failed(done.error());
  return true;
}

RunRecord play(const RunCommandOptions& options, const Prepared& prepared, Job& job, Outputs& outputs,
               ProgrammedPath& programmed) {
  ProgressLine progress;
  Pace pace;
  double share = 0.0;
  std::uint32_t seen = 0;
  RunOptions run_options;
  run_options.record = options.plot.has_value() || options.report.has_value();
  if (run_options.record) job.watch_programmed([&](const Action& action) { programmed.add(action); });
  if (outputs.trace || options.realtime) {
    run_options.on_cycle = [&](const Cycle& cycle, const AxisVector& actual) {
      if (outputs.trace) outputs.trace->add(cycle, actual);
      if (options.realtime) pace.wait_until(cycle.time_s);
    };
  }
  // In real time a wish to end is obeyed at once; otherwise a look at it now and then is soon enough.
  run_options.progress_cycles = options.realtime ? 1 : 10'000;
  run_options.on_progress = [&](const RunProgress& at) {
    progress.show(share, fmt::format("{}  {:.1f} s of machine time", prepared.source->name(), at.time_s));
    return Interrupt::signal() == 0;
  };
  const auto next = [&]() -> const Action* {
    const Action* action = job.next();
    if (action == nullptr) return nullptr;
    if ((++seen & 0xFFU) == 0) share = share_read(*prepared.source, *action);
    print_alarm(*action, job, options.common);
    return action;
  };
  RunRecord record = run(next, prepared.controller.machine, prepared.controller.feed_policy, run_options);
  if (record.truncated && !record.actions.empty())
    programmed.end_at(record.actions.back().action.origin.block);
  return record;
}

bool write_pictures(const RunCommandOptions& options, const Prepared& prepared, const Job& job,
                    const RunRecord& record, const ProgrammedPath& programmed, Outputs& outputs) {
  const DrawingExtras extras{&programmed, prepared.controller.toolpath_policy.normal_line.axis};
  const Machine& machine = prepared.controller.machine;
  const std::string maker = fmt::format("kerf {}", version());
  bool good = true;
  if (outputs.plot) {
    good = write_whole(*outputs.plot, svg_plot(record, machine, {options.file, maker}, extras)) && good;
  }
  if (outputs.report) {
    const ReportInput input{
        {},
        options.file,
        std::string(prepared.controller.dialect->title),
        maker,
        prepared.source->text(),
        [&job](std::int32_t program) { return job.interpreter().source_of(program)->text(); },
        record,
        machine,
        extras};
    good = write_whole(*outputs.report, html_report(input)) && good;
  }
  return good;
}

int status_of(const RunSummary& summary) {
  const bool alarm = std::any_of(summary.alarms.begin(), summary.alarms.end(),
                                 [](const Alarm& raised) { return stops_program(raised); });
  return alarm || summary.stalled ? kExitAlarm : kExitGood;
}

}  // namespace

int run_command(const RunCommandOptions& options) {
  if (!names_are_good(options)) return kExitUsage;
  const auto prepared = prepare(options.file, options.common);
  if (!prepared) return kExitUsage;
  Outputs outputs;
  if (!open_outputs(options, prepared->controller.machine, outputs)) return kExitUsage;
  const Interrupt interrupt;
  const auto job = std::make_unique<Job>(prepared->controller, prepared->source);
  ProgrammedPath programmed;
  const RunRecord record = play(options, *prepared, *job, outputs, programmed);
  if (Interrupt::signal() != 0) {
    print_error("interrupted; no file was written");
    return kExitSignal + Interrupt::signal();
  }

  ResultStream out;
  if (record.summary.stalled) {
    print_error("the run ended at a move whose feed is 0: it would never end",
                "raise the feed override or the lowest feed rate");
  }
  if (options.json) {
    append_summary_json(out.text(), record.summary);
  } else {
    append_summary(out.text(), record.summary, prepared->controller.machine);
  }
  out.flush();
  bool good = write_pictures(options, *prepared, *job, record, programmed, outputs);
  if (outputs.trace) good = outputs.trace->finish() && good;
  if (!good || !out.good()) return kExitUsage;
  return status_of(record.summary);
}

}  // namespace kerf
