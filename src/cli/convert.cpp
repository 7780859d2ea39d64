// kerf convert: a program in another form.

#include <algorithm>
#include <fmt/format.h>
#include <unistd.h>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/file_clash.hpp"
#include "cli/job.hpp"
#include "report/atomic_file.hpp"
#include "report/diagnostic.hpp"

namespace kerf {
namespace {

const Conversion* find_conversion(const Dialect& dialect, std::string_view name) {
  const auto found = std::find_if(dialect.conversions.begin(), dialect.conversions.end(),
                                  [name](const Conversion& one) { return one.name == name; });
  return found == dialect.conversions.end() ? nullptr : &*found;
}

/// What can be written instead: "pmc (omron)".
std::string all_conversions() {
  std::string text;
  for (const Dialect& dialect : dialects()) {
    for (const Conversion& one : dialect.conversions)
      text += fmt::format("{}{} ({} of {})", text.empty() ? "" : ", ", one.name, one.title, dialect.name);
  }
  return text;
}

int write_result(const std::string& text, const std::optional<std::string>& output) {
  if (output) {
    if (const auto written = write_file(*output, text); !written) {
      print_error(written.error().message, written.error().remedy);
      return kExitUsage;
    }
    return kExitGood;
  }
  ResultStream out;
  out.text() = text;
  out.flush();
  return out.good() ? kExitGood : kExitUsage;
}

}  // namespace

int convert_command(const ConvertOptions& options) {
  const auto prepared = prepare(options.file, options.common);
  if (!prepared) return kExitUsage;
  const Dialect& dialect = *prepared->controller.dialect;
  const Conversion* conversion = find_conversion(dialect, options.to);
  if (conversion == nullptr) {
    print_error(fmt::format("a program of {} cannot be converted to '{}'", dialect.name, options.to),
                fmt::format("kerf converts to {}; --dialect says in which language the program is",
                            all_conversions()));
    return kExitUsage;
  }
  if (options.output) {
    const auto clash = file_clash({{options.file, "the program"}}, {{*options.output, "--output"}});
    if (clash) print_error(*clash, "give the output a name of its own");
    if (clash) return kExitUsage;
  }
  std::vector<Alarm> faults;
  const std::string text = conversion->convert(*prepared->source, options.number, faults);
  if (faults.empty()) return write_result(text, options.output);
  const DiagnosticStyle style = style_of_stream(STDERR_FILENO, options.common.color);
  for (const Alarm& fault : faults)
    fmt::print(stderr, "{}\n",
               diagnostic_text(prepared->source->name(), prepared->source->text(), fault, style));
  return kExitAlarm;
}

}  // namespace kerf
