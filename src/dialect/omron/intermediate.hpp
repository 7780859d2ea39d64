#pragma once
// The intermediate code into which a program is converted before the controller runs it (manual A-1).

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::omron {

/// A block may be at most so long in intermediate code (manual 1-7).
inline constexpr std::size_t kLongestBlock = 1020;

/// Collects the lines of a program in their order, or only looks at how long they are.
class IntermediateCode {
 public:
  explicit IntermediateCode(bool keeps_text) : keeps_text_(keeps_text) {}

  bool keeps_text() const { return keeps_text_; }
  /// A word of a block, as it is written in the source, with the sign and digits of its value or the name of
  /// the variable that gives it.
  struct Word {
    std::string_view address;
    std::string_view value;
    bool is_variable = false;
  };

  /// Begins a block of words; `skip` is the number of its optional skip, 0 without.
  void begin_block(std::uint32_t line, int skip);
  void add_word(const Word& word);
  /// Ends it; false when it is too long.
  bool end_block();

  /// A line of a program code; false when it is too long.
  bool add_line(std::string line);

  /// The lines from `first` on are the body of a control statement that stood in braces.
  std::size_t size() const { return lines_.size(); }
  void enclose(std::size_t first);

  /// The whole text, a line feed behind each line. A program numbered 1000 or more is a subprogram.
  std::string text(std::int32_t program) const;

 private:
  void append(std::string_view word);
  bool continues_cycle() const { return !cycle_.empty() && positions_ && !names_cycle_; }
  /// What a block does to the fixed cycle in force.
  void note_cycle(std::string_view address, std::string_view value);

  const bool keeps_text_;
  std::vector<std::string> lines_;
  std::vector<std::string> words_;  ///< of the block begun
  std::string skip_;                ///< what leaves the block out, or nothing
  std::string head_;
  std::size_t length_ = 0;  ///< of the block begun
  std::string cycle_;       ///< G74 or G84 while one is in force
  bool cycle_starts_ = false;
  bool names_cycle_ = false;  ///< the block names it itself
  bool positions_ = false;
  bool returns_ = false;  ///< the block has M99
};

}  // namespace kerf::omron
