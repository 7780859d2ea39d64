#include "cli/job.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

#include "machine/settings_file.hpp"
#include "report/diagnostic.hpp"

namespace kerf {
namespace {

/// Bytes in which a file shows what it is.
constexpr std::size_t kHead = 4096;

bool read_machine_file(const CommonOptions& options, SetupOptions& setup) {
  if (!options.machine_file) return true;
  const auto file = Source::open(*options.machine_file, "machine description");
  if (!file) {
    print_error(file.error().message, file.error().remedy);
    return false;
  }
  if ((*file)->text().substr(0, kHead).find('\0') != std::string_view::npos) {
    print_error(fmt::format("{} is binary data, not a machine file", *options.machine_file),
                "name a machine file; `kerf machine init` writes one");
    return false;
  }
  setup.machine_text = std::string((*file)->text().substr(0, kLargestMachineFile + 1));
  setup.machine_file = *options.machine_file;
  return true;
}

std::optional<Controller> make(const CommonOptions& options, std::string_view name, std::string_view text) {
  SetupOptions setup;
  setup.dialect = options.dialect;
  setup.assignments = options.assignments;
  setup.optional_stop = options.optional_stop;
  for (const std::string& skip : options.block_skips) {
    if (skip == "true")
      setup.block_skip = true;
    else
      setup.block_skip_numbers.push_back(skip);
  }
  if (!read_machine_file(options, setup)) return std::nullopt;
  auto controller = make_controller(setup, name, text);
  if (!controller) {
    for (const SettingsError& error : controller.error()) print_error(error_text(error));
    return std::nullopt;
  }
  return std::move(*controller);
}

/// Text that no controller could take for a program: nothing at all, or binary data.
std::optional<std::string> not_a_program(const Source& source) {
  const std::string_view text = source.text();
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return fmt::format("{} is empty, so there is no program to run", source.name());
  }
  if (text.substr(0, kHead).find('\0') != std::string_view::npos) {
    return fmt::format("{} is binary data, not an NC program", source.name());
  }
  return std::nullopt;
}

/// The other programs of the store in the folder, under the names that the dialect gives them.
ProgramTexts programs_in(const std::filesystem::path& folder, const Dialect& dialect) {
  if (dialect.file_names == nullptr) return [](std::int32_t) { return ProgramText{}; };
  return [folder, &dialect](std::int32_t number) -> ProgramText {
    for (const std::string& name : dialect.file_names(number)) {
      const std::filesystem::path file = folder / name;
      std::error_code ignored;
      if (!std::filesystem::exists(file, ignored)) continue;
      auto source = Source::open(file.string());
      const bool good = source && (*source)->text().find('\0') == std::string_view::npos;
      return good ? ProgramText{*source} : ProgramText{Source::from_text(file.string(), ""), true};
    }
    return {};
  };
}

}  // namespace

std::optional<Prepared> prepare(const std::string& file, const CommonOptions& options, std::string* why) {
  std::error_code ignored;
  if (options.program_dir && !std::filesystem::is_directory(*options.program_dir, ignored)) {
    print_error(fmt::format("--program-dir {} is no folder", *options.program_dir),
                "name the folder that holds the subprograms");
    return std::nullopt;
  }
  const auto refuse = [why](const std::string& message, std::string_view remedy) {
    print_error(message, remedy);
    if (why != nullptr) *why = message;
    return std::nullopt;
  };
  auto source = Source::open(file);
  if (!source) return refuse(source.error().message, source.error().remedy);
  if (const auto fault = not_a_program(**source)) return refuse(*fault, "name a text file with NC code");
  auto controller = make(options, file, (*source)->text());
  if (!controller) return std::nullopt;
  controller->interpreter_options.programs =
      programs_in(options.program_dir ? std::filesystem::path(*options.program_dir)
                                      : std::filesystem::path(file).parent_path(),
                  *controller->dialect);
  if (options.verbose) {
    fmt::print(stderr, "kerf: {} as {} on machine '{}'\n", file, controller->dialect->title,
               controller->machine.name);
  }
  return Prepared{std::move(*source), std::move(*controller)};
}

std::optional<Controller> prepare_controller(const CommonOptions& options, std::string_view program,
                                             std::string_view text) {
  return make(options, program, text);
}

std::string beginning_of(const std::string& file) {
  std::string text(kHead, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return text;
}

void print_alarm(const Action& action, const Job& job, const CommonOptions& options) {
  const auto* alarm = std::get_if<Alarm>(&action.what);
  if (alarm == nullptr) return;
  const auto source = job.source_of(action);
  const DiagnosticStyle style = style_of_stream(STDERR_FILENO, options.color);
  fmt::print(stderr, "{}\n", diagnostic_text(source->name(), source->text(), *alarm, style));
}

double share_read(const Source& source, const Action& action) {
  const double size = static_cast<double>(std::max<std::size_t>(source.text().size(), 1));
  return static_cast<double>(action.origin.span.offset) / size;
}

}  // namespace kerf
