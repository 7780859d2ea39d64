#include "dialect/omron/scanner.hpp"

#include <algorithm>

namespace kerf::omron {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

bool is_small(char c) {
  return c >= 'a' && c <= 'z';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

bool Scanner::ends_line(std::size_t position) const {
  if (position >= text_.size() || text_[position] == '\n') return true;
  return text_[position] == '\r' && (position + 1 == text_.size() || text_[position + 1] == '\n');
}

char Scanner::peek() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  return ends_line(at_) || at_comment() ? '\0' : text_[at_];
}

char Scanner::at(std::size_t ahead) const {
  if (ahead == 0) return ends_line(at_) ? '\0' : text_[at_];
  for (std::size_t i = 0; i <= ahead; ++i) {
    if (ends_line(at_ + i)) return '\0';
  }
  return text_[at_ + ahead];
}

bool Scanner::take(char c) {
  if (peek() != c) return false;
  ++at_;
  return true;
}

bool Scanner::take(std::string_view text) {
  if (peek() == '\0' || text_.substr(at_, text.size()) != text) return false;
  at_ += text.size();
  return true;
}

std::string_view Scanner::name() {
  if (!is_small(peek())) return {};
  std::size_t end = at_;
  while (end < text_.size() && (is_small(text_[end]) || is_digit(text_[end]))) ++end;
  return text_.substr(at_, end - at_);
}

bool Scanner::take_name(std::string_view name) {
  if (peek() == '\0' || text_.substr(at_, name.size()) != name) return false;
  const char next = at(name.size());
  if (is_small(next) || is_digit(next) || next == '_' || (next >= 'A' && next <= 'Z')) return false;
  at_ += name.size();
  return true;
}

bool Scanner::take_keyword(std::string_view keyword) {
  if (name() != keyword) return false;
  at_ += keyword.size();
  return true;
}

void Scanner::skip_line() {
  at_ = std::min(text_.find('\n', at_), text_.size());
}

void Scanner::next_line_with_text() {
  while (peek() == '\0' && at_ < text_.size()) {
    skip_line();
    if (at_ >= text_.size()) return;
    ++line_;
    line_start_ = ++at_;
  }
}

SourceSpan Scanner::span_from(std::size_t position) const {
  const std::size_t length = at_ > position ? at_ - position : 1;
  return {position, line_, static_cast<std::uint32_t>(position - line_start_ + 1),
          static_cast<std::uint32_t>(length)};
}

SourceSpan Scanner::span_here(std::size_t length) const {
  return {at_, line_, static_cast<std::uint32_t>(at_ - line_start_ + 1), static_cast<std::uint32_t>(length)};
}

bool Scanner::fail(std::string_view detail, std::string_view message, const SourceSpan& span) {
  if (fault_.detail.empty()) fault_ = {detail, message, span};
  return false;
}

}  // namespace kerf::omron
