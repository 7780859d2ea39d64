#pragma once
// One block of text into statements.

#include <string_view>
#include <vector>

#include "dialect/melsec/control_pairing.hpp"
#include "dialect/melsec/expression_parser.hpp"
#include "syntax/compiled_program.hpp"

namespace kerf::melsec {

/// Compiles the blocks of one program in order.
class BlockCompiler {
 public:
  BlockCompiler(CompiledProgram& program, std::vector<Control>& controls)
      : program_(program), controls_(controls) {}

  /// `line` is the text of a block that is neither empty nor a comment, `span` its place.
  void compile(std::string_view line, const SourceSpan& span);

 private:
  bool block();
  bool sequence_number();
  bool statement();
  bool if_statement();
  bool then_part(StatementIndex condition);
  bool else_statement();
  bool go_to(ExpressionRef condition);
  bool while_statement();
  bool do_statement(ExpressionRef condition);
  bool end_statement();
  bool assignment();
  bool words();
  bool word();
  bool word_value(Word& word);
  bool loop_number(std::int32_t& number);
  bool at_keyword();
  bool nothing_more();
  bool condition_in_brackets(std::string_view detail, ExpressionRef& condition);

  Statement& add(StatementKind kind);
  StatementIndex last() const { return static_cast<StatementIndex>(program_.statements.size() - 1); }
  void control(ControlKind kind, std::int32_t number = 0);
  ExpressionRef since(std::size_t first_step) const;
  void fault();

  CompiledProgram& program_;
  std::vector<Control>& controls_;
  ExpressionParser parser_{program_.steps};
  SourceSpan span_;
  std::int32_t number_ = -1;  ///< N of the block
  std::size_t first_statement_ = 0;
};

}  // namespace kerf::melsec
