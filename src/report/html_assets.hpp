#pragma once
// The style sheet and script of the HTML report, from the files in assets/.

#include <string_view>

namespace kerf {

extern const std::string_view kReportStyle;
extern const std::string_view kReportScript;

}  // namespace kerf
