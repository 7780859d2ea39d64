#include "report/html_tool.hpp"

#include <algorithm>

#include "report/html_path.hpp"

namespace kerf {
namespace {

/// Runs of successive moves with the same plane and value.
class Runs {
 public:
  explicit Runs(std::string_view value_key) : value_key_(value_key) {}

  void add(std::int64_t move, std::int64_t value, int plane) {
    if (count_ > 0 && move == first_ + count_ && value == value_ && plane == plane_) {
      ++count_;
      return;
    }
    close();
    first_ = move;
    count_ = 1;
    value_ = value;
    plane_ = plane;
  }
  void append_to(std::string& out) {
    close();
    count_ = 0;
    moves_.append_to(out, "move");
    out += ',';
    counts_.append_to(out, "count");
    out += ',';
    values_.append_to(out, value_key_);
    out += ',';
    planes_.append_to(out, "plane");
  }

 private:
  void close() {
    if (count_ == 0) return;
    moves_.add(first_);
    counts_.add(count_);
    values_.add(value_);
    planes_.add(plane_);
  }

  std::string_view value_key_;
  Differences moves_, counts_, values_, planes_;
  std::int64_t first_ = 0;
  std::int64_t count_ = 0;
  std::int64_t value_ = 0;
  int plane_ = 0;
};

void append_programmed(std::string& out, const ProgrammedPath* programmed) {
  if (programmed == nullptr || programmed->size() == 0) {
    out += "\"programmed\":null,\n";
    return;
  }
  HtmlPath path({Axis::X, Axis::Y, Axis::Z});
  Differences planes;
  for (std::size_t i = 0; i < programmed->size(); ++i) {
    const Move move = (*programmed)[i];
    path.add(move);
    planes.add(plane_number(move.plane));
  }
  out += "\"programmed\":{";
  path.append_to(out);
  out += ',';
  planes.append_to(out, "plane");
  out += "},\n";
}

}  // namespace

std::optional<Axis> shown_normal_axis(const ReportInput& input) {
  const auto& actions = input.record.actions;
  const bool is_used = std::any_of(actions.begin(), actions.end(), [](const TimedAction& timed) {
    const auto* move = std::get_if<Move>(&timed.action.what);
    return move != nullptr && move->normal_line != Side::none;
  });
  return is_used ? input.extras.normal_axis : std::nullopt;
}

void append_tool_layers(std::string& out, const ReportInput& input) {
  append_programmed(out, input.extras.programmed);
  Runs swept("radius");
  Runs pointing("zero");
  std::int64_t number = 0;
  Move figure;
  for (const TimedAction& timed : input.record.actions) {
    const Move* const move = drawn_move(timed, figure);
    if (move == nullptr) continue;
    const int plane = plane_number(move->plane);
    const std::int64_t radius = counts_of(swept_radius(*move), kPerMm);
    if (radius > 0) swept.add(number, radius, plane);
    if (move->normal_line != Side::none) pointing.add(number, counts_of(move->normal_zero, kPerMm), plane);
    ++number;
  }
  out += "\"swept\":{";
  swept.append_to(out);
  out += "},\n\"pointing\":";
  const auto axis = shown_normal_axis(input);
  if (!axis) {
    out += "null,\n";
    return;
  }
  out += "{\"axis\":\"";
  out += letter(*axis);
  out += "\",";
  pointing.append_to(out);
  out += "},\n";
}

}  // namespace kerf
