#include "syntax/compiled_program.hpp"

#include <algorithm>

namespace kerf {
namespace {

using Labels = std::vector<SequenceLabel>;

std::pair<Labels::const_iterator, Labels::const_iterator> labels_of(const Labels& labels,
                                                                    std::int32_t number) {
  const auto by_number = [](const auto& a, const auto& b) { return a.number < b.number; };
  return std::equal_range(labels.begin(), labels.end(), SequenceLabel{number, 0}, by_number);
}

}  // namespace

StatementIndex CompiledProgram::find_label(std::int32_t wanted, StatementIndex from) const {
  const auto [first, last] = labels_of(labels, wanted);
  for (auto label = first; label != last; ++label) {
    if (label->statement > from) return label->statement;
  }
  // The block of the jump itself is left out of both parts of the search.
  while (from > 0 && !statements[from].first_of_block) --from;
  return first != last && first->statement < from ? first->statement : kNoStatement;
}

void CompiledProgram::refuse(const StatementFault& why) {
  refused = true;
  labels.clear();
  faults.assign(1, why);
  statements.clear();
  Statement& statement = statements.emplace_back();
  statement.span = why.span;
  statement.kind = StatementKind::fault;
  statement.jump = 0;
}

StatementIndex CompiledProgram::find_first(std::int32_t wanted) const {
  const auto [first, last] = labels_of(labels, wanted);
  return first == last ? kNoStatement : first->statement;
}

}  // namespace kerf
