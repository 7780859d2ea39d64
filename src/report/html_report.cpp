#include "report/html_report.hpp"

#include <fmt/format.h>

#include "report/html_assets.hpp"
#include "report/html_data.hpp"
#include "report/html_sections.hpp"
#include "report/text_escape.hpp"

namespace kerf {
namespace {

// The policy lets the page run its own script and style, and load nothing.
constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:">
<link rel="icon" href="data:,">
)";

constexpr std::string_view kPictures = R"(<div class="work">
<div class="pictures">
<section aria-labelledby="views-title">
<div class="bar"><h2 id="views-title">Toolpath</h2><ul class="legend" id="legend"></ul><ul class="legend" id="layers"></ul></div>
<div id="views"></div>
<p class="hint">Drag to move; click a picture and turn the wheel (or Ctrl + wheel) to zoom; keys + − 0 and arrows when a picture has the focus. Click a move to choose its block.</p>
</section>
<section aria-labelledby="speed-title">
<div class="bar"><h2 id="speed-title">Speed over time</h2><output class="readout" id="speed-readout"></output><div class="buttons" id="speed-buttons"></div></div>
<div class="picture" id="speed"></div>
</section>
</div>
<section class="blocks" aria-labelledby="blocks-title">
<div class="bar"><h2 id="blocks-title">Blocks</h2><output class="readout" id="blocks-count" aria-live="polite"></output></div>
<div class="filter">
<label>Find <input type="search" id="filter-text" placeholder="text or line number" autocomplete="off" spellcheck="false"></label>
<label>Show <select id="filter-kind">
<option value="">everything</option><option value="lca">cutting</option><option value="ca">arcs</option><option value="r">rapids</option><option value="o">other functions</option><option value="xw">alarms</option>
</select></label>
</div>
<div class="rows" id="rows" tabindex="0" role="region" aria-labelledby="blocks-title">
<table><thead><tr id="columns"></tr></thead><tbody id="body"></tbody></table>
</div>
<p class="about" id="chosen" aria-live="polite"></p>
</section>
</div>
<noscript><p class="hint">The pictures and the table of blocks need JavaScript; nothing is loaded from the network.</p></noscript>
)";

void append_heading(std::string& out, const ReportInput& input, std::string_view title) {
  out += fmt::format("<header>\n<h1>{}</h1>\n<p>", xml_text(title));
  std::string_view separator;
  const auto fact = [&](std::string_view label, std::string_view value) {
    if (value.empty()) return;
    out += fmt::format("{}{} <b>{}</b>", separator, label, xml_text(value));
    separator = " · ";
  };
  fact("file", input.file_name);
  fact("dialect", input.dialect);
  fact("machine", input.machine.name);
  out += "</p>\n</header>\n";
}

}  // namespace

std::string html_report(const ReportInput& input) {
  const std::string_view title = input.title.empty() ? input.file_name : input.title;
  std::string out(kHead);
  out += fmt::format("<title>{} – kerf run report</title>\n<style>\n", xml_text(title));
  out += kReportStyle;
  out += "</style>\n</head>\n<body>\n";
  append_heading(out, input, title);
  out +=
      "<main>\n<section aria-labelledby=\"summary-title\">\n<h2 id=\"summary-title\" "
      "class=\"unseen\">Summary</h2>\n";
  append_cards(out, input.record.summary);
  append_axis_table(out, input.record.summary, input.machine);
  out += "</section>\n";
  append_alarms(out, input);
  if (input.record.truncated) {
    out += fmt::format(
        "<p class=\"notice\">The run is longer than a report holds: pictures and blocks show its first "
        "{} actions, the totals all of it.</p>\n",
        input.record.actions.size());
  } else if (input.extras.programmed != nullptr && input.extras.programmed->truncated()) {
    out += fmt::format(
        "<p class=\"notice\">The programmed path is longer than a report holds: the pictures show its first "
        "{} moves.</p>\n",
        ProgrammedPath::kMost);
  }
  out += kPictures;
  out += "</main>\n<footer><p>Run report";
  if (!input.maker.empty()) out += " made by " + xml_text(input.maker);
  out += ". Lengths in mm, machine coordinates; times are those of the simulated machine.</p></footer>\n";
  out += "<script type=\"application/json\" id=\"data\">\n";
  append_report_data(out, input);
  out += "</script>\n<script>\n";
  out += kReportScript;
  out += "</script>\n</body>\n</html>\n";
  return out;
}

}  // namespace kerf
