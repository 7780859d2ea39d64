#pragma once
// A program of the NC Integrated Controller into statements to run, or into its intermediate code.

#include <memory>
#include <string>

#include "dialect/omron/program_parser.hpp"
#include "syntax/compiled_program.hpp"

namespace kerf::omron {

/// A program ready to run. The controller does not start one in which anything is wrong: such a program holds
/// one fault after the other and nothing else. `number` is the program number.
std::shared_ptr<const CompiledProgram> compile(std::shared_ptr<const Source> source, std::int32_t number);

/// The intermediate code of a program; empty when anything is wrong with it, and `faults` says what.
std::string intermediate_code(std::string_view text, std::int32_t number, std::vector<ParseFault>& faults);

/// The program number with which the name of a file ends, its extension left out: P1000.nc; without one 1.
std::int32_t number_in_name(std::string_view file_name);

}  // namespace kerf::omron
