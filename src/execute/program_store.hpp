#pragma once
// The programs that a program may call, compiled when they are first called.

#include <functional>
#include <memory>

#include "execute/block_rules.hpp"

namespace kerf {

/// A text as a program of a number; null when there is none. Asked once a number.
using ProgramCompiler =
    std::function<std::shared_ptr<const CompiledProgram>(ProgramText text, std::int32_t number)>;

/// Finds programs among texts and keeps what it has compiled, also that there is none.
ProgramFinder compiled_once(ProgramTexts texts, ProgramCompiler compile);

}  // namespace kerf
