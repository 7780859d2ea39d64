#include "dialect/omron/compile.hpp"

#include "dialect/omron/alarms.hpp"

namespace kerf::omron {
namespace {

/// Nothing of the program remains but what is wrong with it.
void keep_faults(CompiledProgram& program, const std::vector<ParseFault>& faults) {
  program.refuse({});
  program.statements.clear();
  program.faults.clear();
  for (const ParseFault& fault : faults) {
    Statement& statement = program.statements.emplace_back();
    statement.span = fault.span;
    statement.kind = StatementKind::fault;
    statement.sequence_number = static_cast<std::int32_t>(fault.span.line);
    statement.jump = static_cast<StatementIndex>(program.faults.size());
    program.faults.push_back({&alarm_kind(fault.detail), fault.span, fault.message, {}});
  }
}

/// The return that conversion puts behind every subprogram (manual A-1-1).
void add_footer(CompiledProgram& program) {
  Statement footer;
  footer.kind = StatementKind::go_back;
  footer.first_of_block = false;
  program.statements.push_back(footer);
}

}  // namespace

std::shared_ptr<const CompiledProgram> compile(std::shared_ptr<const Source> source, std::int32_t number) {
  auto program = std::make_shared<CompiledProgram>();
  const std::string_view text = source->text();
  program->source = std::move(source);
  program->number = number;
  IntermediateCode code(false);
  std::vector<ParseFault> faults;
  ProgramParser(*program, code, text).run(faults);
  if (!faults.empty()) keep_faults(*program, faults);
  if (faults.empty()) add_footer(*program);
  return program;
}

std::string intermediate_code(std::string_view text, std::int32_t number, std::vector<ParseFault>& faults) {
  CompiledProgram program;
  IntermediateCode code(true);
  ProgramParser(program, code, text).run(faults);
  return faults.empty() ? code.text(number) : std::string();
}

std::int32_t number_in_name(std::string_view file_name) {
  const std::size_t slash = file_name.rfind('/');
  if (slash != std::string_view::npos) file_name.remove_prefix(slash + 1);
  file_name = file_name.substr(0, file_name.find('.'));
  constexpr std::size_t kMostDigits = 4;
  std::size_t digits = 0;
  std::int32_t number = 0;
  std::int32_t place = 1;
  while (digits < kMostDigits && digits < file_name.size()) {
    const char c = file_name[file_name.size() - 1 - digits];
    if (c < '0' || c > '9') break;
    number += place * (c - '0');
    place *= 10;
    ++digits;
  }
  return number > 0 ? number : 1;
}

}  // namespace kerf::omron
