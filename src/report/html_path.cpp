#include "report/html_path.hpp"

#include <utility>

namespace kerf {

int plane_number(const Plane& plane) {
  if (plane == kPlaneXY) return 0;
  if (plane == kPlaneZX) return 1;
  return plane == kPlaneYZ ? 2 : 3;
}

HtmlPath::HtmlPath(std::vector<Axis> axes) : axes_(std::move(axes)), ends_(axes_.size()) {}

void HtmlPath::add(const Move& move) {
  if (number_ == 0 || jumps(move)) add_jump(move);
  for (std::size_t i = 0; i < axes_.size(); ++i) ends_[i].add(counts_of(move.end[axes_[i]], kPerMm));
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

void HtmlPath::append_to(std::string& out) const {
  out += "\"end\":{";
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (i > 0) out += ',';
    ends_[i].append_to(out, std::string(1, letter(axes_[i])));
  }
  out += "},\"jumps\":[" + jump_text_ + "],\n\"arcs\":{";
  arc_move_.append_to(out, "move");
  out += ',';
  arc_plane_.append_to(out, "plane");
  out += ',';
  arc_first_.append_to(out, "first");
  out += ',';
  arc_second_.append_to(out, "second");
  out += ',';
  arc_sweep_.append_to(out, "sweep");
  out += '}';
}

bool HtmlPath::jumps(const Move& move) const {
  for (const Axis axis : axes_) {
    if (counts_of(move.start[axis], kPerMm) != counts_of(last_[axis], kPerMm)) return true;
  }
  return false;
}

void HtmlPath::add_jump(const Move& move) {
  if (!jump_text_.empty()) jump_text_ += ',';
  jump_text_ += '[';
  append_integer(jump_text_, number_);
  for (const Axis axis : axes_) {
    jump_text_ += ',';
    append_integer(jump_text_, counts_of(move.start[axis], kPerMm));
  }
  jump_text_ += ']';
}

}  // namespace kerf
