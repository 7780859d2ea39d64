#pragma once
// A cursor over the text of a program.

#include <cstdint>
#include <string_view>

#include "base/source_span.hpp"
#include "syntax/plain_line.hpp"

namespace kerf::omron {

/// What a reader found wrong: the detail of the alarm and where.
struct ParseFault {
  std::string_view detail = {};   ///< empty: nothing
  std::string_view message = {};  ///< a literal; empty: the alarm's own cause says it
  SourceSpan span = {};
};

/// Reads on within a line; blanks may stand between any two parts, and `//` hides the rest of the line. A
/// line ends with a line feed, in front of which a carriage return may stand.
class Scanner {
 public:
  explicit Scanner(std::string_view text)
      : text_(text), at_(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0), line_start_(at_) {}

  /// The next character of the line that is no blank; 0 at its end. Leaves the cursor there.
  char peek();
  /// The character `ahead` behind the cursor, blanks included; 0 beyond the line.
  char at(std::size_t ahead = 0) const;
  /// Takes the character, or the text, when it comes next.
  bool take(char c);
  bool take(std::string_view text);
  void skip(std::size_t characters = 1) { at_ += characters; }
  /// Takes a lower-case keyword that ends here.
  bool take_keyword(std::string_view keyword);
  /// Goes over a name of letters, digits and underscores that comes next.
  bool take_name(std::string_view name);
  /// The lower-case letters and digits that come next, a letter first; the cursor stays.
  std::string_view name();
  bool at_line_end() { return peek() == '\0'; }
  bool at_text_end() const { return at_ >= text_.size(); }
  /// Goes to the next character that is no blank, over the ends of lines and over comments.
  void next_line_with_text();
  /// Goes to the end of the line.
  void skip_line();

  std::size_t position() const { return at_; }
  LinePlace place() const { return {at_, line_start_, line_}; }
  void go_to(const LinePlace& place) {
    at_ = place.at;
    line_start_ = place.start;
    line_ = place.line;
  }
  std::string_view text() const { return text_; }
  std::uint32_t line() const { return line_; }
  std::string_view since(std::size_t position) const { return text_.substr(position, at_ - position); }
  /// From a position on this line to the cursor.
  SourceSpan span_from(std::size_t position) const;
  SourceSpan span_here(std::size_t length = 1) const;

  /// Remembers the first fault. False.
  bool fail(std::string_view detail, std::string_view message, const SourceSpan& span);
  bool fail(std::string_view detail, std::string_view message) {
    peek();
    return fail(detail, message, span_here());
  }
  const ParseFault& fault() const { return fault_; }
  void forget_fault() { fault_ = {}; }

 private:
  bool at_comment() const { return text_.substr(at_, 2) == "//"; }
  bool ends_line(std::size_t position) const;

  static constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

  std::string_view text_;
  std::size_t at_;
  std::size_t line_start_;
  std::uint32_t line_ = 1;
  ParseFault fault_;
};

}  // namespace kerf::omron
