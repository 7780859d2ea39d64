#include "report/programmed_path.hpp"

#include <algorithm>
#include <cmath>

#include "report/move_geometry.hpp"
#include "report/polar_picture.hpp"

namespace kerf {
namespace {

constexpr double kSamePlace_mm = 1e-6;

bool is_in_force(const RadiusCompensation& compensation) {
  return compensation.side != Side::none && compensation.amount != 0.0;
}

bool moves_in_plane(const Move& move) {
  if (is_arc(move.mode)) return true;
  const auto way = [&move](Axis axis) { return std::abs(move.end[axis] - move.start[axis]); };
  return way(move.plane.first) > kSamePlace_mm || way(move.plane.second) > kSamePlace_mm;
}

bool is_seen(const Plane& plane) {
  return plane == kPlaneXY || plane == kPlaneZX || plane == kPlaneYZ;
}

}  // namespace

void ProgrammedPath::add(const Action& action) {
  const auto* programmed = std::get_if<Move>(&action.what);
  if (programmed == nullptr) return;
  const bool in_force = is_in_force(programmed->compensation);
  if (!in_force && !displaced_) return;
  const Move move = as_figure(*programmed);
  const bool moves = moves_in_plane(move);
  displaced_ = in_force || !moves;
  if (!moves || !is_seen(move.plane) || !is_drawable(move)) return;
  if (moves_.size() == kMost) {
    truncated_ = true;
    return;
  }
  Kept kept{action.origin.block, move.mode, move.plane, {}, {}, move.arc};
  std::copy_n(move.start.values.begin(), kept.start.size(), kept.start.begin());
  std::copy_n(move.end.values.begin(), kept.end.size(), kept.end.begin());
  moves_.push_back(kept);
}

void ProgrammedPath::end_at(std::uint32_t block) {
  const auto behind = std::partition_point(moves_.begin(), moves_.end(),
                                           [block](const Kept& kept) { return kept.block <= block; });
  moves_.erase(behind, moves_.end());
}

Move ProgrammedPath::operator[](std::size_t i) const {
  const Kept& kept = moves_[i];
  Move move;
  move.mode = kept.mode;
  move.plane = kept.plane;
  move.arc = kept.arc;
  std::copy_n(kept.start.begin(), kept.start.size(), move.start.values.begin());
  std::copy_n(kept.end.begin(), kept.end.size(), move.end.values.begin());
  return move;
}

}  // namespace kerf
