#include "dialect/omron/variables.hpp"

#include <charconv>

namespace kerf::omron {

std::optional<std::int64_t> variable_number(char bank, std::int64_t address) {
  const auto within = [&](std::int64_t first, std::int64_t count) {
    return address >= 0 && address < count ? std::optional(first + address) : std::nullopt;
  };
  if (bank == 'L') return within(0, kLocalVariables);
  if (bank == 'Q') return within(kLocalVariables, kSystemVariables);
  if (bank == 'P') return within(kLocalVariables + kSystemVariables, kSharedVariables);
  return std::nullopt;
}

std::optional<std::int64_t> variable_named(std::string_view name) {
  if (name.size() < 2) return std::nullopt;
  std::int64_t address = -1;
  const char* last = name.data() + name.size();
  const auto [end, error] = std::from_chars(name.data() + 1, last, address);
  if (error != std::errc() || end != last) return std::nullopt;
  return variable_number(name.front(), address);
}

MacroVariableLayout variable_layout(int motors) {
  MacroVariableLayout layout;
  layout.first_local = 0;
  layout.locals = kLocalVariables;
  layout.levels = kDeepestCall + 1;
  layout.first_common = kLocalVariables;
  layout.common = kSystemVariables + kSharedVariables;
  layout.system = motors;
  return layout;
}

}  // namespace kerf::omron
