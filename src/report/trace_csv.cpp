#include "report/trace_csv.hpp"

#include <string_view>

#include "report/number_text.hpp"

namespace kerf {
namespace {

constexpr int kTimeDecimals = 9;
constexpr int kPositionDecimals = 9;
constexpr int kSpeedDecimals = 6;

}  // namespace

void TraceCsv::header(std::string& out) const {
  out += "t_s,line,feed_mm_min";
  for (const Axis axis : axes_) {
    for (const std::string_view column : {"_cmd", "_act", "_vel"}) {
      out += ',';
      out += letter(axis);
      out += column;
    }
  }
  out += '\n';
}

void TraceCsv::row(const TraceRow& row, std::string& out) const {
  append_rounded(out, row.time_s, kTimeDecimals);
  out += ',';
  append_integer(out, row.line);
  out += ',';
  append_rounded(out, row.feed_mm_min, kSpeedDecimals);
  for (const Axis axis : axes_) {
    out += ',';
    append_rounded(out, row.command[axis], kPositionDecimals);
    out += ',';
    append_rounded(out, row.actual[axis], kPositionDecimals);
    out += ',';
    append_rounded(out, row.velocity_per_min[axis], kSpeedDecimals);
  }
  out += '\n';
}

}  // namespace kerf
