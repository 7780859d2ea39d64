#include "dialect/melsec/block_words.hpp"

#include <cmath>

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/codes.hpp"
#include "dialect/melsec/numbers.hpp"

namespace kerf::melsec {
namespace {

constexpr double kHighestAuxiliary = 99999999.0;

/// Rows and sets of the G codes by ten times their number, made once.
struct CodeIndex {
  std::array<const CodeRow*, 1000> rows{};
  std::array<CodeSet, 1000> sets{};
  CodeIndex() {
    for (const CodeRow& row : code_table()) {
      if (row.letter == 'G') rows[row.number] = &row;
    }
    for (const CodeNumber number : kGCodes) sets[number] = set_of(number);
  }
};

const CodeIndex& code_index() {
  static const CodeIndex kIndex;
  return kIndex;
}

ProgramCode program_code_of(std::int32_t number) {
  switch (number) {
    case 0:
    case 1:
      return ProgramCode::stop;
    case 2:
    case 30:
      return ProgramCode::end;
    case 98:
      return ProgramCode::call;
    case 99:
      return ProgramCode::go_back;
    default:
      return ProgramCode::none;
  }
}

const CodeRow* find_g(CodeNumber number) {
  const CodeIndex& index = code_index();
  return number < index.rows.size() ? index.rows[number] : nullptr;
}

}  // namespace

std::optional<CodeNumber> code_number(const Word& word) {
  double tenfold = 0.0;
  if (word.is_computed) {
    tenfold = std::round(word.computed * 10.0);
  } else {
    if (word.number.overflow || word.number.decimals > 1) return std::nullopt;
    tenfold = static_cast<double>(word.number.digits) * (word.number.decimals == 1 ? 1.0 : 10.0);
  }
  if (!(tenfold >= 0.0 && tenfold < 10000.0)) return std::nullopt;
  return static_cast<CodeNumber>(tenfold);
}

CodeSet set_of_known(CodeNumber number) {
  return number == kNoCode ? 0 : code_index().sets[number];
}

bool BlockWords::collect(const Block& block, CodeNumber distance, const LineAxes& line,
                         std::optional<Alarm>& alarm) {
  codes_.fill(kNoCode);
  values_.fill(nullptr);
  named_ = {};
  rapid_feed_ = nullptr;
  auxiliaries_.clear();
  code_set_ = 0;
  program_code_ = ProgramCode::none;
  incremental_ = distance == code(91);
  first_argument_ = block.words.size();
  for (std::size_t i = 0; i < block.words.size(); ++i) {
    const Word& word = block.words[i];
    bool good = true;
    const bool argument = has(kMacroCall);
    if (word.address == 'G') {
      good = take_code(block, word, alarm);
      if (good && has(kMacroCall) && !argument) first_argument_ = i + 1;
    } else if (argument) {
      continue;
    } else if (word.address == 'M') {
      good = take_auxiliary(block, word, alarm);
    } else {
      good = take_value(block, word, line, alarm);
    }
    if (!good) return false;
  }
  if (!auxiliaries_.empty()) sort_auxiliaries();
  return true;
}

bool BlockWords::take_code(const Block& block, const Word& word, std::optional<Alarm>& alarm) {
  const auto number = code_number(word);
  const CodeRow* row = number ? find_g(*number) : nullptr;
  if (row == nullptr) {
    refuse(alarm, "0307H", span_of(block, word));
    if (number && *number % 10 == 0) alarm->remedy = nearest_code(code_table(), 'G', *number / 10);
    return false;
  }
  code_set_ |= set_of_known(*number);
  if (row->group == Group::one_shot) return true;
  const auto group = static_cast<std::size_t>(row->group);
  if (codes_[group] != kNoCode && codes_[group] != *number) code_set_ &= ~set_of_known(codes_[group]);
  codes_[group] = *number;
  code_at_[group] = &word;
  if (row->group == Group::distance) incremental_ = *number == code(91);
  return true;
}

bool BlockWords::take_auxiliary(const Block& block, const Word& word, std::optional<Alarm>& alarm) {
  const NumberResult number = integer_of(word, -kHighestAuxiliary, kHighestAuxiliary);
  if (number.fault != NumberFault::none) {
    return refuse(alarm, number.fault == NumberFault::range ? "0308H" : "031AH", span_of(block, word));
  }
  if (auxiliaries_.full()) {
    for (std::size_t i = 1; i < kAuxiliaries; ++i) auxiliaries_[i - 1] = auxiliaries_[i];
    auxiliaries_.resize(kAuxiliaries - 1);
  }
  auxiliaries_.push_back(static_cast<std::int32_t>(number.value));
  return true;
}

/// Which of the M codes that count steer the program; the last of these does.
void BlockWords::sort_auxiliaries() {
  const auto codes = auxiliaries_;
  auxiliaries_.clear();
  for (const std::int32_t number : codes) {
    const ProgramCode code = program_code_of(number);
    if (code == ProgramCode::none) {
      auxiliaries_.push_back(number);
    } else {
      program_code_ = code;
    }
  }
}

bool BlockWords::take_value(const Block& block, const Word& word, const LineAxes& line,
                            std::optional<Alarm>& alarm) {
  if (word.comma) {
    rapid_feed_ = &word;
    return true;
  }
  values_[static_cast<std::size_t>(word.address - 'A')] = &word;
  if (const auto axis = axis_from_letter(word.address)) {
    if (!line.all.contains(*axis)) return refuse(alarm, "0303H", span_of(block, word));
    if (line.followers.contains(*axis)) return true;
    named_.insert(*axis);
    axes_[index(*axis)] = {&word, incremental_};
    return true;
  }
  const bool whole = word.address == 'P' || word.address == 'L';
  if (whole && !word.is_computed && word.number.has_point) {
    return refuse(alarm, "031AH", span_of(block, word));
  }
  constexpr std::string_view kAddresses = "DFHIJKLPR";
  if (kAddresses.find(word.address) != std::string_view::npos) return true;
  return refuse(alarm, "0305H", span_of(block, word),
                FixedText<200>::format("The controller has no address {}.", word.address));
}

}  // namespace kerf::melsec
