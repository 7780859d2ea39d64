#include "dialect/dgshape/block_words.hpp"

#include "dialect/dgshape/alarms.hpp"
#include "dialect/dgshape/codes.hpp"

namespace kerf::dgshape {
namespace {

/// Addresses that carry a value; G, M are codes, N and O are numbers of their own and are values here too.
constexpr WordMask kValueAddresses = mask_of("ADFHIJKLNOPQRSTXYZ");

bool refuse(std::optional<Alarm>& alarm, std::string_view detail, const SourceSpan& span,
            const FixedText<200>& message = {}) {
  alarm = Alarm{&alarm_kind(detail), span, message, {}};
  return false;
}

}  // namespace

CodeIndex::CodeIndex() {
  for (const CodeRow& row : code_table()) {
    if (row.letter == 'G') g_[row.number / 10] = &row;
    if (row.letter == 'M') m_[row.number / 10] = &row;
  }
}

const CodeRow* CodeIndex::find(char letter, const Decimal& number) const {
  if (number.has_point || number.overflow || number.digits < 0 || number.digits >= 100) return nullptr;
  return (letter == 'G' ? g_ : m_)[static_cast<std::size_t>(number.digits)];
}

bool BlockWords::take_g(const Block& block, std::size_t i, const CodeIndex& index,
                        std::optional<Alarm>& alarm) {
  const Word& word = block.words[i];
  const CodeRow* row = index.find('G', word.number);
  const SourceSpan span = span_of(block, word);
  if (row == nullptr) {
    refuse(alarm, "unknown-code", span);
    if (!word.number.has_point && word.number.digits >= 0) {
      alarm->remedy = remedy_for_unknown('G', word.number.digits);
    }
    return false;
  }
  const auto group = static_cast<std::size_t>(row->group);
  if (row->group == Group::one_shot && codes_[group] != kNoCode && codes_[group] != row->number) {
    return refuse(alarm, "conflicting-codes", span,
                  FixedText<200>::format("G{:02} and {} are both one-shot codes with words of their own.",
                                         codes_[group] / 10, row->word));
  }
  codes_[group] = row->number;
  code_at_[group] = static_cast<std::uint8_t>(i);
  return true;
}

bool BlockWords::collect(const Block& block, const CodeIndex& index, std::optional<Alarm>& alarm) {
  block_ = &block.words;
  present_ = 0;
  codes_.fill(kNoCode);
  m_words_.clear();
  for (std::size_t i = 0; i < block.words.size(); ++i) {
    const Word& word = block.words[i];
    if (word.address == 'G') {
      if (!take_g(block, i, index, alarm)) return false;
      continue;
    }
    if (word.address == 'M') {
      if (index.find('M', word.number) == nullptr) {
        refuse(alarm, "unknown-code", span_of(block, word));
        if (!word.number.has_point && word.number.digits >= 0) {
          alarm->remedy = remedy_for_unknown('M', word.number.digits);
        }
        return false;
      }
      m_words_.push_back(static_cast<std::uint8_t>(i));
      continue;
    }
    const WordMask bit = mask(word.address);
    if ((kValueAddresses & bit) == 0) {
      return refuse(alarm, "unknown-code", span_of(block, word),
                    FixedText<200>::format("The controller has no address {}.", word.address));
    }
    if ((present_ & bit) != 0) {
      return refuse(alarm, "repeated-word", span_of(block, word),
                    FixedText<200>::format("The block has a second {} word.", word.address));
    }
    present_ |= bit;
    at_[static_cast<std::size_t>(word.address - 'A')] = static_cast<std::uint8_t>(i);
  }
  return true;
}

bool BlockWords::cycle_behind_motion() const {
  return code_at_[static_cast<std::size_t>(Group::fixed_cycle)] >
         code_at_[static_cast<std::size_t>(Group::motion)];
}

}  // namespace kerf::dgshape
