// Modal G codes.

#include <algorithm>
#include <cmath>

#include "dialect/omron/block_run.hpp"
#include "execute/grid.hpp"

namespace kerf::omron {

/// Under radius compensation the coordinates of its moves may not shift (manual G40 to G42, restrictions).
bool BlockRun::compensation_allows_modal() {
  if (!is_compensating()) return true;
  for (const Group group :
       {Group::work_system, Group::scaling, Group::mirror, Group::rotation, Group::unit}) {
    const bool changes = words_.has(group) && words_[group] != registers.modal[group];
    if (changes || (group == Group::work_system && words_.has(group)))
      return refuse("compensation-word", span(words_.word(group)));
  }
  return words_[Group::one_shot] != code(52) ||
         refuse("compensation-word", span(words_.word(Group::one_shot)));
}

bool BlockRun::modal() {
  if (!compensation_allows_modal()) return false;
  if (words_.has(Group::unit)) registers.modal.set(Group::unit, words_[Group::unit]);
  if (!plane()) return false;
  for (const Group group :
       {Group::motion, Group::distance, Group::path_mode, Group::return_level, Group::fixed_cycle}) {
    if (words_.has(group)) registers.modal.set(group, words_[group]);
  }
  // G00 to G03 between a cycle and its G80 end it.
  if (in_cycle_ && words_.has(Group::motion)) registers.modal.set(Group::fixed_cycle, code(80));
  return work_system() && transformations() && radius_compensation() && length_offset() && parameter_set();
}

Plane BlockRun::plane_in_force() const {
  switch (registers.modal[Group::plane]) {
    case code(18):
      return kPlaneZX;
    case code(19):
      return kPlaneYZ;
    default:
      return kPlaneXY;
  }
}

bool BlockRun::plane() {
  if (!words_.has(Group::plane)) return true;
  const CodeNumber wanted = words_[Group::plane];
  if (is_compensating() && wanted != registers.modal[Group::plane])
    return refuse("compensation-word", span(words_.word(Group::plane)));
  const bool rotated = registers.placement.rotation.active && words_[Group::rotation] != code(69);
  if (rotated && wanted != registers.modal[Group::plane])
    return refuse("rotation-plane", span(words_.word(Group::plane)));
  registers.modal.set(Group::plane, wanted);
  // From version 1.02 on the axis of the tool offset would change with the plane.
  const bool offset = registers.placement.length != AxisVector{};
  if (settings_.version_1_02 && offset) {
    registers.placement.length = {};
    registers.modal.set(Group::length_compensation, code(49));
  }
  return true;
}

/// Selecting a work coordinate system moves nothing and ends mirroring, scaling and rotation.
bool BlockRun::work_system() {
  if (!words_.has(Group::work_system)) return true;
  registers.modal.set(Group::work_system, words_[Group::work_system]);
  release_transformations(registers);
  stand_at(registers.placement.machine);
  return true;
}

bool BlockRun::transformations() {
  int wanting = words_.has(Group::one_shot) ? 1 : 0;
  const Word* last = nullptr;
  const auto want = [&](Group group, CodeNumber on) {
    if (words_[group] != on) return;
    ++wanting;
    last = &words_.word(group);
  };
  want(Group::scaling, code(51));
  want(Group::mirror, code(51, 1));
  want(Group::rotation, code(68));
  // A move in the same block would want the words too.
  const bool local = words_[Group::one_shot] == code(52);
  if (words_.has(Group::motion) && !words_.axes().empty() && (last != nullptr || local))
    return refuse("conflicting-codes", span(words_.word(Group::motion)));
  if (wanting > 1 && last != nullptr) return refuse("conflicting-codes", span(*last));
  if (!words_.has(Group::scaling) && !words_.has(Group::mirror) && !words_.has(Group::rotation)) return true;
  if (!scaling() || !mirroring() || !rotation()) return false;
  // Nothing moves: the program's position is that of where the axes stand.
  stand_at(registers.placement.machine);
  return true;
}

/// The words X, Y and Z as absolute positions in the current coordinate system; of those left out it is where
/// the tool stands, so that a move to the same place is none.
bool BlockRun::center_words(Change change, AxisVector& center, AxisSet* named) {
  const AxisVector origin = workpiece_origin(registers, tables_);
  const Placement& placement = registers.placement;
  center = in_front_of(change, placement, placement.machine - placement.length_taken);
  for (double& value : center.values) value = on_grid(value);
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    if (take(letter(axis)) == nullptr) continue;
    double value = 0.0;
    if (!axis_value(axis, value)) return false;
    center[axis] = origin[axis] + value;
    if (named != nullptr) named->insert(axis);
  }
  return true;
}

bool BlockRun::scaling() {
  if (!words_.has(Group::scaling)) return true;
  AxisTransformation& change = registers.placement.transformation;
  registers.modal.set(Group::scaling, words_[Group::scaling]);
  change.scaled = words_[Group::scaling] == code(51);
  return !change.scaled || (center_words(Change::scaling, change.center, nullptr) && magnifications(change));
}

bool BlockRun::magnifications(AxisTransformation& change) {
  constexpr double kLeast = 0.00001;
  constexpr double kGreatest = 10000.0;
  std::fill(change.magnification.values.begin(), change.magnification.values.end(), 1.0);
  const Word* all = take('P');
  double common = 1.0;
  if (all != nullptr && !value(*all, kLeast, kGreatest, common)) return false;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    const char address = static_cast<char>('I' + index(axis));
    const Word* own = take(address);
    double factor = 1.0;
    if (own != nullptr) {
      if (!value(*own, -kGreatest, kGreatest, factor)) return false;
      if (std::abs(factor) < kLeast)
        return refuse("value-range", span(*own),
                      "A magnification of an axis is 0.00001 or more, or negative.");
    }
    change.magnification[axis] = all != nullptr ? common : factor;
  }
  return true;
}

bool BlockRun::mirroring() {
  if (!words_.has(Group::mirror)) return true;
  AxisTransformation& change = registers.placement.transformation;
  AxisVector mirrors;
  AxisSet named;
  const bool on = words_[Group::mirror] == code(51, 1);
  // In front of G00 to G03 the words are those of the move.
  const bool has_words = on || !words_.has(Group::motion);
  if (has_words && !center_words(Change::mirroring, mirrors, &named)) return false;
  if (!on) {
    // G50.1 alone ends the mirroring of all axes, with words that of the axes named.
    for (const Axis axis : named) change.mirrored.erase(axis);
    if (named.empty()) change.mirrored = {};
  } else {
    change.mirrored = named;
    change.mirrors = mirrors;
  }
  registers.modal.set(Group::mirror, on || !change.mirrored.empty() ? code(51, 1) : code(50, 1));
  return true;
}

bool BlockRun::rotation() {
  if (!words_.has(Group::rotation)) return true;
  PlaneRotation& rotation = registers.placement.rotation;
  registers.modal.set(Group::rotation, words_[Group::rotation]);
  rotation.active = words_[Group::rotation] == code(68);
  if (!rotation.active) return true;
  constexpr double kWholeTurn = 360.0;
  AxisVector center;
  if (!center_words(Change::rotation, center, nullptr)) return false;
  const Word* angle = take('R');
  if (angle == nullptr) return refuse("rotation-angle", span(words_.word(Group::rotation)));
  if (!value(*angle, -kWholeTurn, kWholeTurn, rotation.angle_deg)) return false;
  rotation.plane = plane_in_force();
  rotation.center = {center[rotation.plane.first], center[rotation.plane.second]};
  rotation.turn = turn_by(rotation.angle_deg);
  return true;
}

const Tool* BlockRun::selected_tool() const {
  const auto& tools = rules_.machine().tools;
  const auto tool = std::find_if(tools.begin(), tools.end(),
                                 [this](const Tool& one) { return one.number == registers.tool; });
  return tool == tools.end() ? nullptr : &*tool;
}

/// The shift appears with the next move of the axis.
bool BlockRun::length_offset() {
  if (!words_.has(Group::length_compensation)) return true;
  const CodeNumber wanted = words_[Group::length_compensation];
  registers.modal.set(Group::length_compensation, wanted);
  registers.placement.length = {};
  if (wanted == code(49)) return true;
  const Axis axis = settings_.version_1_02 ? plane_in_force().third : Axis::Z;
  const Tool* tool = selected_tool();
  const double length = tool == nullptr ? 0.0 : tool->length;
  registers.placement.length[axis] = wanted == code(43) ? length : -length;
  return true;
}

bool BlockRun::parameter_set() {
  if (!words_.has(Group::multi_block)) return true;
  const CodeNumber before = registers.modal[Group::multi_block];
  registers.modal.set(Group::multi_block, words_[Group::multi_block]);
  const Word* set = words_.m_code() == 98 ? nullptr : take('P');
  if (set != nullptr && !settings_.version_1_02)
    return refuse("unused-word", span(*set), "CNC version 1.01 has no parameter sets to select.");
  if (set != nullptr) select_set(*set);
  if (set != nullptr || words_[Group::multi_block] != before) registers.placement.rest_wanted = true;
  return true;
}

/// A value that names no set counts as left out. Another set brings its ramp times with it.
void BlockRun::select_set(const Word& word) {
  constexpr double kNormal = 99.0;
  RateSet rates = 0;
  if (word.computed != kNormal) {
    std::size_t set = 0;
    while (set < kExtendedSets && word.computed != static_cast<double>(set)) ++set;
    if (set == kExtendedSets) return;
    rates = static_cast<RateSet>(kExtendedRates + set);
  }
  if (rates == registers.rates) return;
  registers.rates = rates;
  registers.ramps = settings_.operation(rates).ramps;
}

}  // namespace kerf::omron
