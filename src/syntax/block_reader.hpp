#pragma once
// Reads blocks one after another out of a source, without allocating.

#include <cstdint>
#include <memory>
#include <string_view>

#include "base/fixed_text.hpp"
#include "syntax/block.hpp"
#include "syntax/source.hpp"

namespace kerf {

/// What can be wrong with a block before its words have a meaning. A dialect maps each to an alarm of its
/// own.
enum class SyntaxFault : std::uint8_t {
  none,
  no_data_start,  ///< the text has no block that begins with %
  data_mark,      ///< something stands beside %
  bad_character,
  letter_in_number,  ///< the letter O or I where a digit is expected
  bad_number,        ///< an address without a number, or a sign or point alone
  line_end,          ///< a carriage return without a line feed
  comment_open,      ///< ( without ) in the same block
  block_skip,        ///< a slash that is not at the start of the block
  block_too_long,    ///< more than Block::kMaxWords words
};

/// A program text as a stream of blocks between two % blocks. A value: copying it keeps the place.
class BlockReader {
 public:
  enum class Result : std::uint8_t { block, end, fault };

  explicit BlockReader(std::shared_ptr<const Source> source);

  /// Reads the next block that has words, leaving out empty blocks and comments; with `skip_marked` also the
  /// blocks with a slash in front. `end`: the closing % or the end of the text was reached. After `fault`
  /// reading goes on behind the faulty block.
  Result next(Block& block, bool skip_marked);

  SyntaxFault fault() const { return fault_; }
  const SourceSpan& fault_span() const { return fault_span_; }
  /// The closing % was read, as opposed to the text just ending.
  bool closed() const { return closed_; }
  /// Line of the place reached.
  std::uint32_t line() const { return line_; }
  const std::shared_ptr<const Source>& source() const { return source_; }

 private:
  bool find_data_start();
  bool fail_without_start();
  Result read_block(Block& block, bool skip_marked);
  bool read_words(Block& block, const char*& p, bool skip_marked, bool& skipped);
  bool read_word(Block& block, const char*& p);
  [[gnu::cold]] bool fail(SyntaxFault fault, const char* at, std::size_t length);
  void to_next_line(const char* p);

  std::shared_ptr<const Source> source_;
  const char* begin_;
  const char* end_;         // one before the sentinel line feed
  const char* line_start_;  // where the next block begins
  std::uint32_t line_ = 0;  // number of the line at line_start_, counted from 0
  bool started_ = false;
  bool leader_ = false;     // text stands in front of the first %
  bool any_block_ = false;  // a block was read
  bool closed_ = false;
  bool finished_ = false;
  SyntaxFault fault_ = SyntaxFault::none;
  SourceSpan fault_span_;
};

}  // namespace kerf
