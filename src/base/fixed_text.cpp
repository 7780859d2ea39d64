#include "base/fixed_text.hpp"

#include <fmt/format.h>

namespace kerf {

std::size_t format_into(char* buffer, std::size_t capacity, fmt::string_view pattern, fmt::format_args args) {
  return fmt::vformat_to_n(buffer, capacity, pattern, args).size;
}

}  // namespace kerf
