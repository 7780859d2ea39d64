#pragma once
// Reads a program into statements and into intermediate code (manual 1-7, chapter 4, A-1).

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "dialect/omron/expression_parser.hpp"
#include "dialect/omron/intermediate.hpp"
#include "dialect/omron/scanner.hpp"
#include "syntax/compiled_program.hpp"

namespace kerf::omron {

class ProgramParser {
 public:
  ProgramParser(CompiledProgram& program, IntermediateCode& code, std::string_view text)
      : program_(program), code_(code), scanner_(text), expressions_(scanner_, program.steps) {}

  /// Reads the text up to an M02 or M30 that stands outside of all braces: what is behind is ignored. What is
  /// wrong goes into `faults`, kMostFaults of them at most; the statements are those of a program to be run
  /// only when there are none.
  void run(std::vector<ParseFault>& faults);

  static constexpr std::size_t kMostFaults = 50;
  static constexpr int kDeepest = 64;  ///< control statements within each other

 private:
  /// Jumps whose target is not known yet.
  using Jumps = std::vector<StatementIndex>;
  /// A case or the default of a switch.
  struct Case {
    std::int64_t value = 0;
    bool is_default = false;
    StatementIndex body = 0;
  };
  /// What one command of the program was.
  enum class Command : std::uint8_t { none, block, program_code };

  bool command(Command& kind);
  bool plain_lines();
  bool program_code(bool& found);
  bool body();
  bool commands_to_brace(std::size_t& count, Command& last);
  bool if_statement();
  bool while_statement();
  bool do_statement();
  bool switch_statement();
  bool switch_body(const SourceSpan& head, std::vector<Case>& cases);
  void dispatch(const ExpressionRef& value, const std::vector<Case>& cases);
  bool case_label(std::vector<Case>& cases);
  bool break_statement();
  void leave_breakable();
  bool assignments();
  bool at_assignment();
  bool at_end_of_command();
  bool words(int skip);
  bool word();
  bool word_value(Word& word, IntermediateCode::Word& text);
  bool indirect_value(Word& word, IntermediateCode::Word& text);
  bool skip_number(int& skip);
  bool block_number();
  bool braces();
  void pass_number_before(std::initializer_list<std::string_view> texts);
  bool condition(std::string_view keyword, ExpressionRef& ref);
  bool address(char& address, std::string_view& text);
  void note_fault();
  void resume();

  StatementIndex add(StatementKind kind);
  StatementIndex here() const { return static_cast<StatementIndex>(program_.statements.size()); }
  StatementIndex jump_unless(const ExpressionRef& condition);
  void set_target(StatementIndex jump) { program_.statements[jump].jump = here(); }
  bool add_code(std::string line);
  bool fail(std::string_view detail, std::string_view message = {});

  CompiledProgram& program_;
  IntermediateCode& code_;
  Scanner scanner_;
  ExpressionParser expressions_;
  std::vector<ParseFault>* faults_ = nullptr;
  std::size_t start_ = 0;       ///< of the block being read
  SourceSpan block_;            ///< the block being read, up to the cursor
  bool first_of_block_ = true;  ///< no statement of the block was added yet
  std::size_t few_until_ = 0;   ///< in front of this position few lines of plain words stand together
  bool ends_program_ = false;   ///< the block read last has M02 or M30 and cannot be skipped
  int depth_ = 0;
  std::vector<Jumps> breaks_;  ///< of the loops and switches around
};

}  // namespace kerf::omron
