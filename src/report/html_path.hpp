#pragma once
// A path of moves in the data of the HTML report.

#include <string>
#include <vector>

#include "execute/action.hpp"
#include "report/html_numbers.hpp"

namespace kerf {

/// The number by which the data names a plane: 0 X-Y, 1 Z-X, 2 Y-Z, 3 any other.
int plane_number(const Plane& plane);

/// Collects moves, and of arcs what their end points do not say.
class HtmlPath {
 public:
  explicit HtmlPath(std::vector<Axis> axes);

  void add(const Move& move);

  /// Appends the members end, jumps and arcs of an object.
  void append_to(std::string& out) const;

 private:
  bool jumps(const Move& move) const;
  void add_jump(const Move& move);

  std::vector<Axis> axes_;
  std::vector<Differences> ends_;
  Differences arc_move_, arc_plane_, arc_first_, arc_second_, arc_sweep_;
  std::string jump_text_;
  AxisVector last_;
  std::int64_t number_ = 0;
};

}  // namespace kerf
