// kerf check: every alarm of the programs, without motion planning.

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <unistd.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/file_clash.hpp"
#include "cli/job.hpp"
#include "cli/parallel.hpp"
#include "cli/program_files.hpp"
#include "cli/version.hpp"
#include "report/atomic_file.hpp"
#include "report/check_report.hpp"
#include "report/diagnostic.hpp"
#include "report/text_escape.hpp"

namespace kerf {
namespace {

/// A program and what its check gave.
struct Check {
  CheckedProgram result;
  std::string text;  ///< the diagnostics and a line with their number
  std::set<std::tuple<std::string, std::uint64_t, const AlarmKind*>> known;  ///< alarms, by their places
  std::set<std::string> called;  ///< files of the subprograms it called
  const Dialect* dialect = nullptr;
  std::uint64_t bytes = 0;
  std::shared_ptr<const Source> source;  ///< of a subprogram that is left to its callers
  Machine machine;                       ///< and its machine
};

/// A main program begins anew so often at most. It may well end by itself after some rounds.
constexpr std::uint32_t kRounds = 100;

struct Work {
  std::string file;
  std::string folder;  ///< the folder that was named; empty: the file itself was
};

class Checker {
 public:
  Checker(const CheckOptions& options, std::size_t programs)
      : options_(options),
        style_(style_of_stream(STDOUT_FILENO, options.common.color)),
        alone_(programs == 1) {}

  /// The first program with which those of a folder become too many for the controller gets the alarm for it.
  void limit_store(std::vector<Check>& checks, const std::vector<Work>& work) const {
    std::map<std::pair<std::string, const Dialect*>, std::uint64_t> stored;
    for (std::size_t i = 0; i < checks.size(); ++i) {
      const Dialect* dialect = checks[i].dialect;
      if (work[i].folder.empty() || dialect == nullptr || dialect->store_bytes == 0) continue;
      std::uint64_t& bytes = stored[{work[i].folder, dialect}];
      const bool fitted = bytes <= dialect->store_bytes;
      bytes += checks[i].bytes;
      if (fitted && bytes > dialect->store_bytes) refuse_store(checks[i], bytes);
    }
  }

  /// `in_folder`: the file is one of a store, so a subprogram is left to the programs that call it.
  Check check(const std::string& file, bool in_folder) const {
    Check check;
    check.result.file = file;
    std::string why = "its machine is not one";
    auto prepared = prepare(file, options_.common, &why);
    if (!prepared) {
      check.result.outcome = CheckOutcome::unreadable;
      check.result.message = "not checked: " + why;
      return check;
    }
    check.dialect = prepared->controller.dialect;
    if (in_folder && check.dialect->is_stored != nullptr && !check.dialect->is_stored(file)) {
      check.result.remark = fmt::format("not one of {}", check.dialect->store_names);
    }
    check.bytes = prepared->source->text().size();
    const auto is_subprogram = prepared->controller.dialect->is_subprogram;
    if (in_folder && is_subprogram != nullptr && is_subprogram(prepared->source)) {
      check.result.outcome = CheckOutcome::not_called;
      check.source = prepared->source;
      check.machine = prepared->controller.machine;
      return check;
    }
    execute(*prepared, check);
    return check;
  }

  /// The alarms that show in the text of a subprogram without executing it.
  void read_through(Check& check) const {
    const Source& source = *check.source;
    for (const Alarm& alarm : check.dialect->read_through(check.source, check.machine)) {
      if (check.result.alarms >= static_cast<std::uint64_t>(options_.max_alarms)) return;
      note(source, alarm, check);
    }
  }

 private:
  void refuse_store(Check& check, std::uint64_t bytes) const {
    const Dialect& dialect = *check.dialect;
    const auto message =
        FixedText<200>::format("With this file the programs of the folder have {} bytes; {} are allowed.",
                               bytes, dialect.store_bytes);
    const Alarm alarm{dialect.store_over, {0, 1, 1, 1}, message, {}};
    ++check.result.alarms;
    append_diagnostic(check.text, check.result.file, "", alarm, style_);
    check.text += '\n';
    check.result.findings.push_back({check.result.file, alarm, 1, 2});
  }

  void execute(Prepared& prepared, Check& check) const {
    watch_calls(prepared.controller.interpreter_options.programs, check.called);
    // A main program that goes back with M99 may begin anew for ever.
    prepared.controller.interpreter_options.most_restarts = kRounds;
    const Source& source = *prepared.source;
    auto job = std::make_unique<Job>(prepared.controller, prepared.source);
    std::optional<ProgressLine> progress;
    if (alone_) progress.emplace();
    CheckedProgram& result = check.result;
    std::uint32_t seen = 0;
    while (const Action* action = job->next()) {
      if (progress && (++seen & 0xFFFFU) == 0) progress->show(share_read(source, *action), source.name());
      const auto* alarm = std::get_if<Alarm>(&action->what);
      if (alarm == nullptr) continue;
      note(*job->source_of(*action), *alarm, check);
      if (result.alarms >= static_cast<std::uint64_t>(options_.max_alarms)) {
        append_visible(check.text, source.name());
        check.text += fmt::format(": {}, the rest is not checked (--max-alarms)\n",
                                  count_text(result.alarms, "alarm", "alarms"));
        break;
      }
      if (stops_program(*alarm)) job->recover();
    }
    result.blocks = job->interpreter().blocks();
    if (job->interpreter().began_too_often()) {
      result.remark = fmt::format("begins anew for ever, {} rounds checked", kRounds);
    }
    append_visible(check.text, source.name());
    check.text += fmt::format(": {}, {}, {} executed{}{}\n", count_text(result.alarms, "alarm", "alarms"),
                              count_text(result.warnings, "warning", "warnings"),
                              count_text(result.blocks, "block", "blocks"), result.remark.empty() ? "" : "; ",
                              result.remark);
  }

  /// Each alarm once for each place, however often a loop comes by.
  void note(const Source& place, const Alarm& alarm, Check& check) const {
    if (!check.known.emplace(place.name(), alarm.span.offset, alarm.kind).second) return;
    (stops_program(alarm) ? check.result.alarms : check.result.warnings) += 1;
    append_diagnostic(check.text, place.name(), place.text(), alarm, style_);
    check.text += '\n';
    const auto [first, end] = columns_of(place, alarm.span);
    check.result.findings.push_back({place.name(), alarm, first, end});
  }

  /// First column and the one behind the last, in characters instead of bytes.
  static std::pair<std::uint32_t, std::uint32_t> columns_of(const Source& source, const SourceSpan& span) {
    const std::string_view text = source.text();
    if (span.column == 0 || span.offset < span.column - 1 || span.offset > text.size()) return {1, 2};
    const auto characters = [](std::string_view part) {
      std::uint32_t count = 0;
      for (; !part.empty(); ++count) part.remove_prefix(first_character(part).bytes);
      return count;
    };
    const std::uint32_t first = 1 + characters(text.substr(span.offset - (span.column - 1), span.column - 1));
    const std::uint32_t length = characters(text.substr(span.offset, span.length));
    return {first, first + std::max(length, 1U)};
  }

  static void watch_calls(ProgramTexts& programs, std::set<std::string>& called) {
    programs = [inner = std::move(programs), &called](std::int32_t number) {
      ProgramText text = inner(number);
      if (text.source != nullptr) called.insert(text.source->name());
      return text;
    };
  }

  const CheckOptions& options_;
  DiagnosticStyle style_;
  bool alone_;
};

/// The files named and those of the folders named; false: the message is on standard error.
bool collect_work(const CheckOptions& options, std::vector<Work>& work) {
  for (const std::string& name : options.files) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(name, ignored)) {
      work.push_back({name, ""});
      continue;
    }
    const std::vector<std::string> files = program_files_in(name);
    if (files.empty()) {
      print_error(fmt::format("the folder {} holds no NC program", name),
                  "name a folder with files like O001.gcd or part.nc, or name the files themselves");
      return false;
    }
    for (const std::string& file : files) work.push_back({file, name});
  }
  return true;
}

/// Tells what is wrong with the machine once instead of for each program.
bool machine_is_good(const CheckOptions& options, const std::vector<Work>& work) {
  std::set<const Dialect*> seen;
  return std::all_of(work.begin(), work.end(), [&](const Work& item) {
    std::error_code ignored;
    const bool regular = std::filesystem::is_regular_file(item.file, ignored);
    const std::string text = regular ? beginning_of(item.file) : std::string();
    return !seen.insert(&detect_dialect(item.file, text)).second ||
           prepare_controller(options.common, item.file, text).has_value();
  });
}

bool outputs_are_good(const CheckOptions& options, const std::vector<Work>& work) {
  std::vector<NamedFile> inputs;
  std::set<std::string> folders;
  for (const Work& item : work) {
    inputs.push_back({item.file, "a program"});
    folders.insert(std::filesystem::path(item.file).parent_path().string());
  }
  if (options.common.program_dir) folders.insert(*options.common.program_dir);
  // What the programs call stands beside them.
  for (const std::string& folder : folders) {
    for (std::string& file : program_files_in(folder.empty() ? "." : folder)) {
      inputs.push_back({std::move(file), "a program"});
    }
  }
  if (options.common.machine_file) inputs.push_back({*options.common.machine_file, "the machine file"});
  std::vector<NamedFile> outputs;
  if (options.junit) outputs.push_back({*options.junit, "--junit"});
  if (options.sarif) outputs.push_back({*options.sarif, "--sarif"});
  const auto clash = file_clash(inputs, outputs);
  if (clash) print_error(*clash, "give each output a name of its own");
  return !clash;
}

/// One spelling for all the ways to name a file.
std::string same_spelling(const std::string& file) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::weakly_canonical(file, error);
  return error ? file : path.string();
}

/// Subprograms learn who called them.
void name_callers(std::vector<Check>& checks) {
  std::map<std::string, std::string> callers;
  for (const Check& check : checks) {
    for (const std::string& called : check.called) callers.emplace(same_spelling(called), check.result.file);
  }
  for (Check& check : checks) {
    const auto caller = callers.find(same_spelling(check.result.file));
    if (check.result.outcome != CheckOutcome::not_called || caller == callers.end()) continue;
    check.result.outcome = CheckOutcome::called;
    check.result.caller = caller->second;
  }
}

bool write_or_complain(const std::optional<std::string>& path, const std::string& text) {
  if (!path) return true;
  const auto written = write_file(*path, text);
  if (!written) print_error(written.error().message, written.error().remedy);
  return written.has_value();
}

int status_of(const std::vector<CheckedProgram>& programs) {
  int status = kExitGood;
  for (const CheckedProgram& program : programs) {
    if (program.outcome == CheckOutcome::unreadable) return kExitUsage;
    if (program.alarms > 0) status = kExitAlarm;
  }
  return status;
}

}  // namespace

int check_command(const CheckOptions& options) {
  std::vector<Work> work;
  if (!collect_work(options, work) || !outputs_are_good(options, work) || !machine_is_good(options, work))
    return kExitUsage;
  std::vector<Check> checks(work.size());
  const Checker checker(options, work.size());
  for_each_in_parallel(
      work.size(), [&](std::size_t i) { checks[i] = checker.check(work[i].file, !work[i].folder.empty()); });
  checker.limit_store(checks, work);
  name_callers(checks);
  for (Check& check : checks) {
    if (check.result.outcome == CheckOutcome::not_called) checker.read_through(check);
  }

  ResultStream out;
  std::vector<CheckedProgram> programs;
  bool any_folder = false;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    out.text() += checks[i].text;
    out.overflow();
    any_folder = any_folder || !work[i].folder.empty();
    programs.push_back(std::move(checks[i].result));
  }
  if (any_folder) out.text() += '\n' + check_table(programs);
  out.flush();
  const bool junit = write_or_complain(options.junit, options.junit ? junit_text(programs) : "");
  const bool sarif = write_or_complain(options.sarif, options.sarif ? sarif_text(programs, version()) : "");
  return out.good() && junit && sarif ? status_of(programs) : kExitUsage;
}

}  // namespace kerf
