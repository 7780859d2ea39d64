#include "report/html_data.hpp"

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <variant>
#include <vector>

#include "report/action_text.hpp"
#include "report/html_source.hpp"
#include "report/move_geometry.hpp"
#include "report/number_text.hpp"
#include "report/text_escape.hpp"

namespace kerf {
namespace {

constexpr double kPerMm = 1000.0;
constexpr double kPerSecond = 10'000.0;
constexpr double kPerFeed = 10.0;

std::int64_t counts_of(double value, double unit) {
  const double counts = value * unit;
  return std::abs(counts) < 9e15 ? std::llround(counts) : 0;
}

/// A JSON array of integers, each the difference from the one before.
class Differences {
 public:
  void add(std::int64_t value) {
    if (!text_.empty()) text_ += ',';
    append_integer(text_, value - last_);
    last_ = value;
  }
  void append_to(std::string& out, std::string_view key) const {
    out += '"';
    out += key;
    out += "\":[";
    out += text_;
    out += ']';
  }

 private:
  std::string text_;
  std::int64_t last_ = 0;
};

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
std::vector<Axis> drawn_axes(const RunExtents& extents, const Machine& machine) {
  std::vector<Axis> axes{Axis::X, Axis::Y, Axis::Z};
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    const bool rotary = machine.axes.contains(axis) && machine[axis].type == AxisType::rotary;
    if (rotary && extents.all[index(axis)].length() > 1e-6) axes.push_back(axis);
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
  out += "\"axes\":\"";
  for (const Axis axis : axes) out += letter(axis);
  out += "\",\"limits\":{";
  append_extents("all", extents.all);
  out += ',';
  if (extents.cutting[index(Axis::X)].empty()) {
    out += "\"feed\":null";
  } else {
    append_extents("feed", extents.cutting);
  }
  out += "},\n";
}

int plane_number(const Plane& plane) {
  if (plane == kPlaneXY) return 0;
  if (plane == kPlaneZX) return 1;
  return plane == kPlaneYZ ? 2 : 3;
}

/// Collects moves, and of arcs what their end points do not say.
class MoveData {
 public:
  explicit MoveData(std::vector<Axis> axes) : axes_(std::move(axes)), ends_(axes_.size()) {}

  void add(const TimedAction& timed, const Move& move) {
    if (number_ == 0 || jumps(move)) add_jump(move);
    for (std::size_t i = 0; i < axes_.size(); ++i) ends_[i].add(counts_of(move.end[axes_[i]], kPerMm));
    length_.add(counts_of(timed.length_mm, kPerMm));
    peak_.add(counts_of(timed.peak_feed_mm_min, kPerFeed));
    if (is_arc(move.mode)) {
      arc_move_.add(number_);
      arc_plane_.add(plane_number(move.plane));
      arc_first_.add(counts_of(move.arc.center[0], kPerMm));
      arc_second_.add(counts_of(move.arc.center[1], kPerMm));
      arc_sweep_.add(counts_of(move.arc.sweep, kPerMm));
    }
    last_ = move.end;
    ++number_;
  }

  void append_to(std::string& out) const {
    out += "\"moves\":{";
    length_.append_to(out, "length");
    out += ',';
    peak_.append_to(out, "peak");
    out += ",\"end\":{";
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      if (i > 0) out += ',';
      ends_[i].append_to(out, std::string(1, letter(axes_[i])));
    }
    out += "},\"jumps\":[" + jump_text_ + "]},\n\"arcs\":{";
    arc_move_.append_to(out, "move");
    out += ',';
    arc_plane_.append_to(out, "plane");
    out += ',';
    arc_first_.append_to(out, "first");
    out += ',';
    arc_second_.append_to(out, "second");
    out += ',';
    arc_sweep_.append_to(out, "sweep");
    out += "},\n";
  }

 private:
  bool jumps(const Move& move) const {
    for (const Axis axis : axes_) {
      if (counts_of(move.start[axis], kPerMm) != counts_of(last_[axis], kPerMm)) return true;
    }
    return false;
  }
  void add_jump(const Move& move) {
    if (!jump_text_.empty()) jump_text_ += ',';
    jump_text_ += '[';
    append_integer(jump_text_, number_);
    for (const Axis axis : axes_) {
      jump_text_ += ',';
      append_integer(jump_text_, counts_of(move.start[axis], kPerMm));
    }
    jump_text_ += ']';
  }

  std::vector<Axis> axes_;
  std::vector<Differences> ends_;
  Differences length_, peak_;
  Differences arc_move_, arc_plane_, arc_first_, arc_second_, arc_sweep_;
  std::string jump_text_;
  AxisVector last_;
  std::int64_t number_ = 0;
};

void append_moves(std::string& out, const RunRecord& record, const std::vector<Axis>& axes) {
  MoveData data(axes);
  for (const TimedAction& timed : record.actions) {
    const auto* move = std::get_if<Move>(&timed.action.what);
    if (move != nullptr && is_drawable(*move)) data.add(timed, *move);
  }
  data.append_to(out);
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
  const RunExtents extents = extents_of(input.record.actions);
  const std::vector<Axis> axes = drawn_axes(extents, input.machine);
  out += "{\n";
  append_limits(out, extents, axes);
  append_rows(out, input);
  append_actions(out, input.record);
  append_moves(out, input.record, axes);
  append_holes(out, input.record);
  append_speed(out, input.record);
  out += "}\n";
}

}  // namespace kerf
