#pragma once
#include <string_view>

namespace kerf {

/// "0.1.0"
std::string_view version();

}  // namespace kerf
