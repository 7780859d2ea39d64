#include "dialect/melsec/program_call.hpp"

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/numbers.hpp"

namespace kerf::melsec {
namespace {

constexpr double kHighestProgram = 256.0;
constexpr double kHighestSequenceNumber = 99999.0;
constexpr double kMostRepetitions = 9999.0;
constexpr int kGroups = 10;
constexpr int kFirstOfGroups = 4;

/// Local variable of an address; 0: the address is no argument.
int variable_of(char address) {
  constexpr std::string_view kAddresses = "ABC___DEF_H_M___QRSTUVWXYZ";
  const std::size_t place = kAddresses.find(address);
  return place == std::string_view::npos ? 0 : static_cast<int>(place) + 1;
}

/// Counts the groups of I, J and K: a letter that does not come behind the one before begins a new group.
class GroupCounter {
 public:
  /// The variable, or 0 when there are more groups than the controller takes.
  int next(char address) {
    if (address <= last_) ++group_;
    last_ = address;
    return group_ < kGroups ? kFirstOfGroups + 3 * group_ + (address - 'I') : 0;
  }

 private:
  int group_ = 0;
  char last_ = 0;
};

/// An integer from 0 on; `out_of_range` is the alarm for one above `highest`.
bool read_integer(const Block& block, const Word& word, double highest, std::string_view out_of_range,
                  std::int32_t& value, std::optional<Alarm>& alarm) {
  const NumberResult number = integer_of(word, 0.0, highest);
  if (number.fault == NumberFault::range) return refuse(alarm, out_of_range, span_of(block, word));
  if (number.fault != NumberFault::none) return refuse(alarm, "031AH", span_of(block, word));
  value = static_cast<std::int32_t>(number.value);
  return true;
}

bool read_repetitions(const Block& block, const Word& word, FlowRequest& request,
                      std::optional<Alarm>& alarm) {
  return read_integer(block, word, kMostRepetitions, "0328H", request.repetitions, alarm);
}

/// The same as read_integer, for a word that may be missing.
bool read_optional(const Block& block, const Word* word, double highest, std::int32_t& value,
                   std::optional<Alarm>& alarm) {
  return word == nullptr || read_integer(block, *word, highest, "0308H", value, alarm);
}

SourceSpan place_of(const Block& block, const Word* word) {
  return word == nullptr ? block.span : span_of(block, *word);
}

}  // namespace

bool read_subprogram_call(const Block& block, const BlockWords& words, FlowRequest& request,
                          std::optional<Alarm>& alarm) {
  request = {};
  request.kind = FlowRequest::Kind::call;
  request.place = place_of(block, words.find('P'));
  const Word* times = words.find('L');
  return read_optional(block, words.find('P'), kHighestProgram, request.program, alarm) &&
         read_optional(block, words.find('H'), kHighestSequenceNumber, request.sequence_number, alarm) &&
         (times == nullptr || read_repetitions(block, *times, request, alarm));
}

bool read_return(const Block& block, const BlockWords& words, FlowRequest& request,
                 std::optional<Alarm>& alarm) {
  request = {};
  request.kind = FlowRequest::Kind::go_back;
  request.place = place_of(block, words.find('P'));
  return read_optional(block, words.find('P'), kHighestSequenceNumber, request.sequence_number, alarm);
}

bool read_macro_call(const Block& block, std::size_t first, FlowRequest& request,
                     std::optional<Alarm>& alarm) {
  request = {};
  request.kind = FlowRequest::Kind::macro_call;
  request.program = 0;
  request.place = block.span;
  GroupCounter groups;
  for (std::size_t i = first; i < block.words.size(); ++i) {
    const Word& word = block.words[i];
    const bool grouped = word.address >= 'I' && word.address <= 'K';
    int variable = 0;
    if (word.address == 'G') continue;
    if (word.comma) return refuse(alarm, "0305H", span_of(block, word), "A comma begins no argument.");
    if (word.address == 'P') {
      if (!read_integer(block, word, kHighestProgram, "031FH", request.program, alarm)) return false;
      request.place = span_of(block, word);
    } else if (word.address == 'L') {
      if (!read_repetitions(block, word, request, alarm)) return false;
    } else if (grouped) {
      variable = groups.next(word.address);
      if (variable == 0) return refuse(alarm, "0336H", span_of(block, word));
    } else {
      variable = variable_of(word.address);
      if (variable == 0) return refuse(alarm, "0305H", span_of(block, word));
    }
    if (variable == 0) continue;
    request.arguments[static_cast<std::size_t>(variable) - 1] = argument_of(word);
    request.given |= std::uint64_t{1} << (variable - 1);
  }
  return request.program != 0 || refuse(alarm, "031FH", block.span);
}

}  // namespace kerf::melsec
