#pragma once
// What M98 and G65 ask of the program flow (manual 5.6, 5.7).

#include <optional>

#include "base/alarm.hpp"
#include "dialect/melsec/block_words.hpp"
#include "execute/program_flow.hpp"
#include "syntax/block.hpp"

namespace kerf::melsec {

// Both fill in the request for the program flow; false: `alarm` says what is wrong.

/// M98 with P, H and L: a subprogram, P missing: of the running program itself.
bool read_subprogram_call(const Block& block, const BlockWords& words, FlowRequest& request,
                          std::optional<Alarm>& alarm);

/// G65: the words of the block from `first` on, behind the code. Specification I gives each address a
/// variable of its own; repeated I, J and K are groups of specification II; of two addresses of one variable
/// the last counts.
bool read_macro_call(const Block& block, std::size_t first, FlowRequest& request,
                     std::optional<Alarm>& alarm);

/// M99 with P: where the caller goes on.
bool read_return(const Block& block, const BlockWords& words, FlowRequest& request,
                 std::optional<Alarm>& alarm);

}  // namespace kerf::melsec
