// kerf codes: every word the dialect knows.

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/exit_status.hpp"
#include "cli/job.hpp"

namespace kerf {
namespace {

void append_codes_json(std::string& out, const Dialect& dialect) {
  for (const CodeRow& row : dialect.codes) {
    nlohmann::ordered_json line{{"word", row.word}};
    if (!row.group_name.empty()) line["group"] = row.group_name;
    line["modality"] = row.modality;
    line["name"] = row.name;
    line["format"] = row.format;
    out += line.dump();
    out += '\n';
  }
}

void append_codes_text(std::string& out, const Dialect& dialect) {
  out += fmt::format("{}: every word\n", dialect.title);
  std::size_t words = 0;
  std::size_t names = 0;
  for (const CodeRow& row : dialect.codes) {
    words = std::max(words, row.word.size());
    names = std::max(names, row.name.size());
  }
  std::string_view group = "?";
  for (const CodeRow& row : dialect.codes) {
    const std::string_view heading = row.group_name.empty() ? row.modality : row.group_name;
    if (heading != group) out += fmt::format("\n{}\n", heading);
    group = heading;
    out += fmt::format("  {:<{}}  {:<{}}  {}\n", row.word, words, row.name, names, row.format);
  }
}

}  // namespace

int codes_command(const CodesOptions& options) {
  const auto controller = prepare_controller(options.common);
  if (!controller) return kExitUsage;
  ResultStream out;
  (options.json ? append_codes_json : append_codes_text)(out.text(), *controller->dialect);
  out.flush();
  return out.good() ? kExitGood : kExitUsage;
}

}  // namespace kerf
