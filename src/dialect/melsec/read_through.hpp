#pragma once
// What is wrong with a program that nobody runs.

#include <memory>
#include <vector>

#include "base/alarm.hpp"
#include "machine/machine.hpp"
#include "syntax/source.hpp"

namespace kerf::melsec {

/// The faults of its file and of the grammar of its blocks, and the words that no value could make right:
/// unknown codes and addresses, axes that the machine lacks. In the order of the text.
std::vector<Alarm> read_through(const std::shared_ptr<const Source>& source, const Machine& machine);

}  // namespace kerf::melsec
