#pragma once
// Numbered variables of a macro language: common ones, and local ones for each level of calls.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf {

/// Which variables exist, by their numbers. Local ones stand below the common ones.
struct MacroVariableLayout {
  std::int64_t first_local = 1;
  std::int64_t locals = 0;  ///< local variables of a level
  std::size_t levels = 5;  ///< the main program and the calls within each other that have locals of their own
  std::int64_t first_common = 100;
  std::int64_t common = 0;
  std::int64_t system = 0;  ///< values that the controller sets and programs can only read, from number 0 on
};

/// The arguments of a call: they become the first local variables.
using MacroArguments = std::array<double, 33>;

/// A value; allocates only when the layout is set.
class MacroVariables {
 public:
  MacroVariables() = default;
  explicit MacroVariables(const MacroVariableLayout& layout)
      : layout_(layout),
        common_(static_cast<std::size_t>(layout.common), 0.0),
        locals_(static_cast<std::size_t>(layout.locals) * layout.levels, 0.0),
        system_(static_cast<std::size_t>(layout.system), 0.0) {}

  /// The variable of a number, null when there is none. A fraction of the number is dropped.
  double* find(double number) {
    return const_cast<double*>(static_cast<const MacroVariables*>(this)->find(number));
  }
  const double* find(double number) const {
    double place = number - static_cast<double>(layout_.first_common);
    if (place >= 0.0)
      return place < static_cast<double>(layout_.common) ? &common_[static_cast<std::size_t>(place)]
                                                         : nullptr;
    place = number - static_cast<double>(layout_.first_local);
    const bool local = place >= 0.0 && place < static_cast<double>(layout_.locals);
    return local ? &locals_[first_of(level_) + static_cast<std::size_t>(place)] : nullptr;
  }

  /// A value of the controller by its number, null when there is none. A fraction of the number is dropped.
  double* find_system(double number) {
    return const_cast<double*>(static_cast<const MacroVariables*>(this)->find_system(number));
  }
  const double* find_system(double number) const {
    const bool known = number >= 0.0 && number < static_cast<double>(layout_.system);
    return known ? &system_[static_cast<std::size_t>(number)] : nullptr;
  }

  /// Depth of calls with locals of their own, 0 in the main program; below levels().
  std::size_t level() const { return level_; }
  std::size_t levels() const { return layout_.levels; }
  bool has_locals() const { return layout_.locals > 0; }
  void leave_level() { --level_; }
  /// Goes one level down. The locals there become the arguments where bit i of `given` says so; without
  /// `keep` the others become 0.
  void enter_level(const MacroArguments& arguments, std::uint64_t given, bool keep) {
    ++level_;
    if (!keep) clear_level();
    for (std::size_t i = 0; i < arguments.size() && i < static_cast<std::size_t>(layout_.locals); ++i) {
      if ((given >> i & 1U) != 0) locals_[first_of(level_) + i] = arguments[i];
    }
  }
  /// All local variables of the present level are 0.
  void clear_level() {
    const auto first = locals_.begin() + static_cast<std::ptrdiff_t>(first_of(level_));
    std::fill(first, first + layout_.locals, 0.0);
  }
  /// What a start of the main program does: all local variables are 0.
  void restart() {
    level_ = 0;
    std::fill(locals_.begin(), locals_.end(), 0.0);
  }

 private:
  std::size_t first_of(std::size_t level) const { return level * static_cast<std::size_t>(layout_.locals); }

  MacroVariableLayout layout_;
  std::vector<double> common_;
  std::vector<double> locals_;  ///< level by level
  std::vector<double> system_;
  std::size_t level_ = 0;
};

}  // namespace kerf
