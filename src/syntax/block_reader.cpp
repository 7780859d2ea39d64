#include "syntax/block_reader.hpp"

#include <array>
#include <cstring>
#include <utility>

#include "syntax/decimal_reader.hpp"

namespace kerf {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}

/// The address letter in upper case, or 0. Lower case is read as upper case (DGS-027).
char address_of(char c) {
  const auto lower_bits = static_cast<unsigned char>(static_cast<unsigned char>(c) | 0x20U);
  if (static_cast<unsigned char>(lower_bits - 'a') >= 26) return 0;
  return static_cast<char>(lower_bits & 0xDFU);
}

const char* skip_blanks(const char* p) {
  while (is_blank(*p)) ++p;
  return p;
}

/// A carriage return counts as part of the line end when a line feed, or the end of the text, follows.
bool at_line_end(const char* p) {
  return *p == '\n' || (*p == '\r' && p[1] == '\n');
}

}  // namespace

BlockReader::BlockReader(std::shared_ptr<const Source> source) : source_(std::move(source)) {
  const std::string_view text = source_->text();
  begin_ = text.data();
  end_ = begin_ + text.size();
  line_start_ = begin_;
}

bool BlockReader::fail(SyntaxFault fault, const char* at, std::size_t length) {
  fault_ = fault;
  fault_span_ = {static_cast<std::uint64_t>(at - begin_), line_ + 1,
                 static_cast<std::uint32_t>(at - line_start_ + 1), static_cast<std::uint32_t>(length)};
  return false;
}

void BlockReader::to_next_line(const char* p) {
  ++line_;
  if (*p == '\n') {
    line_start_ = p + 1;
    return;
  }
  // The sentinel behind the text guarantees a line feed.
  const auto* feed = static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(end_ - p) + 1));
  line_start_ = feed + 1;
}

bool BlockReader::find_data_start() {
  if (std::string_view(begin_, static_cast<std::size_t>(end_ - begin_)).substr(0, 3) == kByteOrderMark) {
    line_start_ += kByteOrderMark.size();
  }
  while (line_start_ < end_) {
    const char* p = skip_blanks(line_start_);
    if (*p == '%' && p < end_) {
      p = skip_blanks(p + 1);
      if (!at_line_end(p)) {
        fail(*p == '\r' ? SyntaxFault::line_end : SyntaxFault::data_mark, p, 1);
        return false;
      }
      to_next_line(p);
      return true;
    }
    leader_ = leader_ || !at_line_end(p);
    to_next_line(p);
  }
  return fail_without_start();
}

bool BlockReader::fail_without_start() {
  line_ = 0;
  line_start_ = begin_;
  return fail(SyntaxFault::no_data_start, begin_, 1);
}

BlockReader::Result BlockReader::next(Block& block, bool skip_marked) {
  if (finished_) return Result::end;
  if (!started_) {
    started_ = true;
    if (!find_data_start()) {
      finished_ = true;
      return Result::fault;
    }
  }
  while (line_start_ < end_) {
    const Result result = read_block(block, skip_marked);
    any_block_ = any_block_ || result == Result::fault || block.skip_mark || !block.words.empty();
    if (result == Result::fault || finished_ || !block.words.empty()) return result;
  }
  finished_ = true;
  // Blocks in front of the only % and none behind: the % is the data end, and the data start is missing.
  if (leader_ && !any_block_) {
    fail_without_start();
    return Result::fault;
  }
  return Result::end;
}

BlockReader::Result BlockReader::read_block(Block& block, bool skip_marked) {
  block.words.clear();
  block.skip_mark = false;
  const char* p = skip_blanks(line_start_);
  block.span = {static_cast<std::uint64_t>(line_start_ - begin_), line_ + 1, 1, 0};
  if (*p == '%') {
    const char* behind = skip_blanks(p + 1);
    if (!at_line_end(behind)) {
      fail(*behind == '\r' ? SyntaxFault::line_end : SyntaxFault::data_mark, behind, 1);
      to_next_line(behind);
      return Result::fault;
    }
    closed_ = finished_ = true;
    return Result::end;
  }
  bool skipped = false;
  if (!read_words(block, p, skip_marked, skipped)) {
    to_next_line(p);
    return Result::fault;
  }
  block.span.length = static_cast<std::uint32_t>(p - line_start_);
  if (skipped) block.words.clear();
  to_next_line(p);
  return Result::block;
}

bool BlockReader::read_words(Block& block, const char*& p, bool skip_marked, bool& skipped) {
  for (;;) {
    const char c = *p;
    if (address_of(c) != 0) {
      if (!read_word(block, p)) return false;
    } else if (is_blank(c)) {
      ++p;
    } else if (at_line_end(p)) {
      return true;
    } else if (c == '(') {
      const char* q = p + 1;
      while (*q != ')' && *q != '\n') ++q;
      if (*q == '\n') return fail(SyntaxFault::comment_open, p, 1);
      p = q + 1;
    } else if (c == '/') {
      const bool first = block.words.empty() || (block.words.size() == 1 && block.words[0].address == 'N');
      if (!first || block.skip_mark) return fail(SyntaxFault::block_skip, p, 1);
      block.skip_mark = true;
      if (skip_marked) {
        skipped = true;
        return true;
      }
      ++p;
    } else if (c == '\r') {
      return fail(SyntaxFault::line_end, p, 1);
    } else if (is_digit(c) || c == '.' || c == '+' || c == '-') {
      return fail(SyntaxFault::bad_number, p, 1);
    } else {
      return fail(SyntaxFault::bad_character, p, 1);
    }
  }
}

bool BlockReader::read_word(Block& block, const char*& p) {
  const char* start = p;
  if (block.words.full()) return fail(SyntaxFault::block_too_long, p, 1);
  const char address = address_of(*p++);
  while (is_blank(*p)) ++p;
  bool negative = false;
  if (*p == '-' || *p == '+') negative = *p++ == '-';

  Word& word = block.words.push_back();
  word.address = address;
  word.number = {};
  const bool any = read_decimal(p, word.number);
  word.column = static_cast<std::uint32_t>(start - line_start_ + 1);
  word.length = static_cast<std::uint32_t>(p - start);
  if (!any) {
    const char c = address_of(*p);
    const bool letter = p == start + 1 && (c == 'O' || c == 'I');
    return fail(letter ? SyntaxFault::letter_in_number : SyntaxFault::bad_number, start,
                word.length + (letter ? 1 : 0));
  }
  if (negative) word.number.digits = -word.number.digits;
  return true;
}

}  // namespace kerf
