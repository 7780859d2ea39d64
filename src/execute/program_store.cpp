#include "execute/program_store.hpp"

#include <map>
#include <utility>

namespace kerf {

ProgramFinder compiled_once(ProgramTexts texts, ProgramCompiler compile) {
  using Programs = std::map<std::int32_t, std::shared_ptr<const CompiledProgram>>;
  // Copies of the finder, in copies of an interpreter, share what is known.
  auto known = std::make_shared<Programs>();
  return [texts = std::move(texts), compile = std::move(compile), known](std::int32_t number) {
    const auto found = known->find(number);
    if (found != known->end()) return found->second;
    auto program = compile(texts(number), number);
    known->emplace(number, program);
    return program;
  };
}

}  // namespace kerf
