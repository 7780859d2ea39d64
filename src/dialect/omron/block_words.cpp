#include "dialect/omron/block_words.hpp"

#include <cmath>

#include "dialect/omron/alarms.hpp"
#include "dialect/omron/codes.hpp"
#include "dialect/omron/settings.hpp"

namespace kerf::omron {
namespace {

bool refuse(std::optional<Alarm>& alarm, std::string_view detail, const SourceSpan& span) {
  alarm = Alarm{&alarm_kind(detail), span, {}, {}};
  return false;
}

/// Ten times the number of a G word; kNoCode when no code can have it.
CodeNumber g_number(double value) {
  constexpr double kHighest = 1000.0;
  const double tenths = std::round(value * 10.0);
  if (!(value >= 0.0 && value < kHighest) || std::abs(value * 10.0 - tenths) > 1e-6) return kNoCode;
  return static_cast<CodeNumber>(tenths);
}

}  // namespace

bool BlockWords::collect(const Block& block, std::optional<Alarm>& alarm) {
  codes_.fill(kNoCode);
  for (const Word& word : block.words) {
    if (!std::isfinite(word.computed)) return refuse(alarm, "not-a-number", span_of(block, word));
    if (word.address == 'G') {
      if (!take_g_code(block, word, alarm)) return false;
      continue;
    }
    const Word*& place = values_[place_of(word.address)];
    if (word.address == 'M' && !take_m_code(block, word, alarm)) return false;
    if (place != nullptr) return refuse(alarm, "repeated-word", span_of(block, word));
    place = &word;
    const auto axis = axis_from_letter(word.address);
    if (axis) axes_.insert(*axis);
  }
  return true;
}

bool BlockWords::take_g_code(const Block& block, const Word& word, std::optional<Alarm>& alarm) {
  const CodeRow* row = find_g_code(g_number(word.computed));
  if (row == nullptr) return refuse(alarm, "unknown-code", span_of(block, word));
  // G09 stands beside other codes: it changes how a block ends, not what it does.
  if (row->number == code(9)) {
    exact_stop_ = true;
    exact_stop_leads_ = axes_.empty();
    return true;
  }
  const auto group = static_cast<std::size_t>(row->group);
  if (codes_[group] != kNoCode) return refuse(alarm, "conflicting-codes", span_of(block, word));
  codes_[group] = row->number;
  code_at_[group] = &word;
  return true;
}

bool BlockWords::take_m_code(const Block& block, const Word& word, std::optional<Alarm>& alarm) {
  if (m_code_ >= 0) return refuse(alarm, "two-m-codes", span_of(block, word));
  const double number = word.computed;
  if (!(number >= 0.0 && number < kMCodes) || number != std::trunc(number))
    return refuse(alarm, "m-code", span_of(block, word));
  m_code_ = static_cast<std::int32_t>(number);
  return true;
}

}  // namespace kerf::omron
