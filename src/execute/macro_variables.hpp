#pragma once
// Numbered variables of a macro language: common ones, and local ones for each depth of macro calls.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf {

/// Which variables exist. Numbers 1 to kLocals are local, those from kFirstCommon on common, without a gap;
/// no others exist.
struct MacroVariableLayout {
  static constexpr int kLocals = 33;
  static constexpr int kFirstCommon = 100;
  bool locals = false;      ///< the machine has local variables
  std::int64_t common = 0;  ///< number of common variables
};

/// A value; allocates only when the layout is set.
class MacroVariables {
 public:
  static constexpr std::size_t kLevels = 5;  ///< the main program and four macro calls
  using Locals = std::array<double, MacroVariableLayout::kLocals>;

  MacroVariables() = default;
  explicit MacroVariables(const MacroVariableLayout& layout)
      : common_(static_cast<std::size_t>(layout.common), 0.0), has_locals_(layout.locals) {}

  /// The variable of a number, null when there is none. A fraction of the number is dropped.
  double* find(double number) {
    return const_cast<double*>(static_cast<const MacroVariables*>(this)->find(number));
  }
  const double* find(double number) const {
    constexpr double kFirst = MacroVariableLayout::kFirstCommon;
    if (number >= kFirst) {
      const double place = number - kFirst;
      return place < static_cast<double>(common_.size()) ? &common_[static_cast<std::size_t>(place)]
                                                         : nullptr;
    }
    const bool local = has_locals_ && number >= 1.0 && number < MacroVariableLayout::kLocals + 1;
    return local ? &locals_[level_][static_cast<std::size_t>(number) - 1] : nullptr;
  }

  /// Depth of macro calls, 0 in the main program.
  std::size_t level() const { return level_; }
  void set_level(std::size_t level) { level_ = level; }
  /// What a start of the main program does: all local variables are 0.
  void restart() {
    level_ = 0;
    locals_ = {};
  }
  Locals& locals_of(std::size_t level) { return locals_[level]; }

 private:
  std::vector<double> common_;
  std::array<Locals, kLevels> locals_{};
  std::size_t level_ = 0;
  bool has_locals_ = false;
};

}  // namespace kerf
