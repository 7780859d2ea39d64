#include "report/html_data.hpp"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "report/action_text.hpp"
#include "report/html_path.hpp"
#include "report/html_source.hpp"
#include "report/html_tool.hpp"
#include "report/move_geometry.hpp"
#include "report/number_text.hpp"
#include "report/text_escape.hpp"

namespace kerf {
namespace {

/// Source lines that were executed, each held once.
class BlockTexts {
 public:
  explicit BlockTexts(const ReportInput& input) : input_(input) {}

  std::int64_t index_of(const Origin& origin) {
    const auto key = std::pair(origin.program, origin.span.offset);
    const auto [place, is_new] = known_.try_emplace(key, count_);
    if (is_new) {
      if (count_ > 0) texts_ += ',';
      append_script_string(texts_, block_text(input_, origin));
      ++count_;
    }
    return place->second;
  }
  const std::string& texts() const { return texts_; }

 private:
  const ReportInput& input_;
  std::map<std::pair<std::int32_t, std::uint64_t>, std::int64_t> known_;
  std::int64_t count_ = 0;
  std::string texts_;
};

bool same_block(const Origin& a, const Origin& b) {
  return a.block == b.block && a.span.line == b.span.line && a.program == b.program;
}

void append_rows(std::string& out, const ReportInput& input) {
  BlockTexts texts(input);
  Differences line;
  Differences text;
  Differences count;
  const auto& actions = input.record.actions;
  for (std::size_t begin = 0; begin < actions.size();) {
    const Origin& origin = actions[begin].action.origin;
    std::size_t end = begin + 1;
    while (end < actions.size() && same_block(origin, actions[end].action.origin)) ++end;
    line.add(origin.span.line);
    text.add(texts.index_of(origin));
    count.add(static_cast<std::int64_t>(end - begin));
    begin = end;
  }
  out += "\"rows\":{";
  line.append_to(out, "line");
  out += ',';
  text.append_to(out, "text");
  out += ',';
  count.append_to(out, "count");
  out += "},\n\"texts\":[" + texts.texts() + "],\n";
}

char kind_letter(const ActionVariant& what) {
  if (const auto* move = std::get_if<Move>(&what)) {
    if (!is_drawable(*move)) return 'o';
    switch (move->mode) {
      case MoveMode::rapid:
        return 'r';
      case MoveMode::linear:
        return 'l';
      case MoveMode::clockwise:
        return 'c';
      case MoveMode::counterclockwise:
        return 'a';
    }
  }
  if (const auto* alarm = std::get_if<Alarm>(&what)) return stops_program(*alarm) ? 'x' : 'w';
  return 'o';
}

void append_actions(std::string& out, const RunRecord& record) {
  std::string kinds;
  std::string notes;
  Differences start;
  Differences duration;
  for (std::size_t i = 0; i < record.actions.size(); ++i) {
    const TimedAction& timed = record.actions[i];
    const char kind = kind_letter(timed.action.what);
    kinds += kind;
    start.add(counts_of(timed.start_s, kPerSecond));
    duration.add(counts_of(timed.duration_s, kPerSecond));
    if (std::holds_alternative<Move>(timed.action.what)) continue;
    notes += notes.empty() ? "\"" : ",\"";
    append_integer(notes, static_cast<std::int64_t>(i));
    notes += "\":";
    append_script_string(notes, describe(timed.action.what));
  }
  out += "\"actions\":{\"kinds\":\"" + kinds + "\",";
  start.append_to(out, "start");
  out += ',';
  duration.append_to(out, "duration");
  out += ",\"notes\":{" + notes + "}},\n";
}

/// The axes whose positions the views need.
std::vector<Axis> drawn_axes(const RunExtents& extents, const Machine& machine,
                             const std::optional<Axis>& normal_axis) {
  std::vector<Axis> axes{Axis::X, Axis::Y, Axis::Z};
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    const bool rotary = machine.axes.contains(axis) && machine[axis].type == AxisType::rotary;
    const bool turns = rotary && extents.all[index(axis)].length() > 1e-6;
    if (turns || axis == normal_axis) axes.push_back(axis);
  }
  return axes;
}

void append_limits(std::string& out, const RunExtents& extents, const std::vector<Axis>& axes) {
  const auto append_extents = [&](std::string_view key, const std::array<Extent, kAxisCount>& of) {
    out += '"';
    out += key;
    out += "\":[";
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const Extent& extent = of[index(axes[i])];
      if (i > 0) out += ',';
      out += '[';
      append_integer(out, extent.empty() ? 0 : counts_of(extent.low, kPerMm));
      out += ',';
      append_integer(out, extent.empty() ? 0 : counts_of(extent.high, kPerMm));
      out += ']';
    }
    out += ']';
  };
  out += "\"across\":";
  if (extents.across) {
    out += {'"', letter(extents.across->shown), letter(extents.across->rotary), '"'};
  } else {
    out += "null";
  }
  out += ",\"shapes\":[";
  if (extents.elevation_shapes) out += "\"XZ\"";
  if (extents.elevation_shapes && extents.side_shapes) out += ',';
  if (extents.side_shapes) out += "\"YZ\"";
  out += "],\"axes\":\"";
  for (const Axis axis : axes) out += letter(axis);
  out += "\",\"limits\":{";
  append_extents("all", extents.drawn);
  out += ',';
  if (extents.cutting[index(Axis::X)].empty()) {
    out += "\"feed\":null";
  } else {
    append_extents("feed", extents.drawn_cutting);
  }
  out += "},\n";
}

void append_moves(std::string& out, const RunRecord& record, const std::vector<Axis>& axes) {
  HtmlPath path(axes);
  Differences length;
  Differences peak;
  Move figure;
  for (const TimedAction& timed : record.actions) {
    const Move* const move = drawn_move(timed, figure);
    if (move == nullptr) continue;
    path.add(*move);
    length.add(counts_of(timed.length_mm, kPerMm));
    peak.add(counts_of(timed.peak_feed_mm_min, kPerFeed));
  }
  out += "\"moves\":{";
  length.append_to(out, "length");
  out += ',';
  peak.append_to(out, "peak");
  out += ',';
  path.append_to(out);
  out += "},\n";
}

void append_holes(std::string& out, const RunRecord& record) {
  Differences x;
  Differences y;
  Differences bottom;
  for (const Hole& hole : find_holes(record.actions)) {
    x.add(counts_of(hole.at.x, kPerMm));
    y.add(counts_of(hole.at.y, kPerMm));
    bottom.add(counts_of(hole.bottom, kPerMm));
  }
  out += "\"holes\":{";
  x.append_to(out, "x");
  out += ',';
  y.append_to(out, "y");
  out += ',';
  bottom.append_to(out, "bottom");
  out += "},\n";
}

void append_speed(std::string& out, const RunRecord& record) {
  Differences time;
  Differences feed;
  Differences line;
  for (const SpeedSample& sample : record.speed) {
    time.add(counts_of(sample.time_s, kPerSecond));
    feed.add(counts_of(sample.feed_mm_min, kPerFeed));
    line.add(sample.line);
  }
  out += "\"speed\":{";
  time.append_to(out, "time");
  out += ',';
  feed.append_to(out, "feed");
  out += ',';
  line.append_to(out, "line");
  out += "}\n";
}

}  // namespace

void append_report_data(std::string& out, const ReportInput& input) {
  const RunExtents extents = extents_of(input.record.actions, input.extras);
  const std::vector<Axis> axes = drawn_axes(extents, input.machine, shown_normal_axis(input));
  out += "{\n";
  append_limits(out, extents, axes);
  append_rows(out, input);
  append_actions(out, input.record);
  append_moves(out, input.record, axes);
  append_tool_layers(out, input);
  append_holes(out, input.record);
  append_speed(out, input.record);
  out += "}\n";
}

}  // namespace kerf
