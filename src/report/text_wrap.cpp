#include "report/text_wrap.hpp"

#include <cstddef>

#include "report/text_escape.hpp"

namespace kerf {

void append_wrapped(std::string& out, std::string_view sentence, int indent, int width) {
  int column = indent;
  while (!sentence.empty()) {
    const std::size_t space = sentence.find(' ');
    const std::string_view word = sentence.substr(0, space);
    sentence.remove_prefix(space == std::string_view::npos ? sentence.size() : space + 1);
    if (word.empty()) continue;
    const int word_width = visible_width(word);
    if (column > indent && column + 1 + word_width > width) {
      out += '\n';
      out.append(static_cast<std::size_t>(indent), ' ');
      column = indent;
    } else if (column > indent) {
      out += ' ';
      ++column;
    }
    append_visible(out, word);
    column += word_width;
  }
  out += '\n';
}

}  // namespace kerf
