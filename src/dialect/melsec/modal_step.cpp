// The codes that stay in force: their combinations, tool length offset (G43, G44, G49) and coordinate
// rotation (G68, G69).

#include <cmath>

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/block_run.hpp"
#include "dialect/melsec/combinations.hpp"
#include "dialect/melsec/placement.hpp"

namespace kerf::melsec {
namespace {

/// The codes in force before the block, but the motion code the block runs with.
CodeSet codes_in_force(const ModalState& modal, CodeNumber motion) {
  CodeSet set = set_of_known(motion);
  for (const Group group : {Group::plane, Group::distance, Group::feed_mode, Group::radius_compensation,
                            Group::length_compensation, Group::work_system, Group::path_mode,
                            Group::normal_line, Group::rotation, Group::polar}) {
    set |= set_of_known(modal[group]);
  }
  return set;
}

}  // namespace

/// The last code of the block that belongs to the set.
const Word& BlockRun::last_code(CodeSet codes) const {
  const Word* last = &block_.words[0];
  for (const Word& word : block_.words) {
    if (word.address == 'G' && (set_of_known(code_number(word).value_or(kNoCode)) & codes) != 0) last = &word;
  }
  return *last;
}

bool BlockRun::combinations() {
  if (words_.codes() == 0) return true;
  const Combination in_block = refused_in_block(words_.codes());
  if (!in_block.detail.empty()) {
    return refuse(in_block.detail, span(last_code(in_block.commanded | in_block.against)));
  }
  if (!polar_stands_alone()) return false;
  const CodeNumber motion =
      words_.has(Group::motion) ? words_[Group::motion] : registers.modal[Group::motion];
  const Combination in_modal = refused_in_modal(words_.codes(), codes_in_force(registers.modal, motion),
                                                rules_.settings().axis_tolerance);
  return in_modal.detail.empty() || refuse(in_modal.detail, span(last_code(in_modal.commanded)));
}

/// Beside G12.1 and G13.1 only a sequence number and feeds may stand (5.6 G12.1).
bool BlockRun::polar_stands_alone() {
  if (!words_.has(Group::polar)) return true;
  for (const Word& word : block_.words) {
    const bool may_stand = word.address == 'G' || word.address == 'N' || word.address == 'F';
    if (!may_stand)
      return refuse("0306H", span_of(block_, word), "Beside G12.1 and G13.1 only F and N may stand.",
                    "Write the other words in a block of their own.");
  }
  return true;
}

/// Codes that need axes of their own.
bool BlockRun::codes_have_axes() {
  constexpr CodeSet kNormalLine = set_of(code(41, 1)) | set_of(code(42, 1));
  constexpr CodeSet kPolar = set_of(code(12, 1));
  const ControllerSettings& settings = rules_.settings();
  if ((words_.codes() & kNormalLine) != 0 && !settings.normal_line.axis)
    return refuse("031BH", span(last_code(kNormalLine)));
  if ((words_.codes() & kPolar) != 0 && !(settings.polar_linear && settings.polar_rotary))
    return refuse("0325H", span(last_code(kPolar)));
  return true;
}

bool BlockRun::modal() {
  const CodeNumber before = registers.modal[Group::path_mode];
  ends_normal_line_ =
      words_[Group::normal_line] == code(40, 1) && registers.modal[Group::normal_line] != code(40, 1);
  for (Group group : {Group::motion, Group::plane, Group::distance, Group::work_system, Group::path_mode,
                      Group::normal_line}) {
    if (words_.has(group)) registers.modal.set(group, words_[group]);
  }
  if (registers.modal[Group::normal_line] == code(40, 1)) registers.normal_line_on = false;
  // Entering and leaving high-accuracy control makes a deceleration check.
  const bool entered = registers.modal[Group::path_mode] == code(61, 1);
  if (entered != (before == code(61, 1))) registers.placement.rest_wanted = true;
  return length_offset() && radius_compensation() && rotation() && polar();
}

/// D and H, which must name a compensation even where they have no effect; beside M98 H is a sequence number.
bool BlockRun::compensation_numbers() {
  std::int32_t ignored = 0;
  return compensation_number('D', ignored) && (calls() || compensation_number('H', ignored));
}

bool BlockRun::length_offset() {
  if (!words_.has(Group::length_compensation)) return length_number();
  const CodeNumber number = words_[Group::length_compensation];
  Placement& placement = registers.placement;
  registers.modal.set(Group::length_compensation, number);
  if (number == code(49)) {
    placement.length = {};
    return true;
  }
  std::int32_t compensation = registers.length_number;
  if (!compensation_number('H', compensation)) return false;
  if (compensation < 0) return refuse("030DH", span(words_.word(Group::length_compensation)));
  registers.length_number = compensation;
  const auto axis = offset_axis();
  if (compensation == 0 && words_.axes().empty()) placement.length = {};
  if (!axis) return true;
  const double amount = tables_.length[static_cast<std::size_t>(compensation)];
  placement.length[*axis] = number == code(43) ? amount : -amount;
  return true;
}

/// An H without a code of its own stays for the codes behind (6.4). While an axis is compensated it has the
/// amount of that number from now on, and none with H0.
bool BlockRun::length_number() {
  if (calls() || words_.find('H') == nullptr) return true;
  if (!compensation_number('H', registers.length_number)) return false;
  Placement& placement = registers.placement;
  const CodeNumber in_force = registers.modal[Group::length_compensation];
  if (in_force == code(49) || placement.polar.on) return true;
  const double amount = tables_.length[static_cast<std::size_t>(registers.length_number)];
  for (double& length : placement.length.values) {
    if (length != 0.0) length = in_force == code(43) ? amount : -amount;
  }
  return true;
}

/// The axis that G43 and G44 act on: of those commanded the last base axis, without any the base axis K.
std::optional<Axis> BlockRun::offset_axis() const {
  const auto& base = rules_.settings().base;
  // Beside G68 the axis words are its centre.
  if (words_.axes().empty() || words_[Group::rotation] == code(68)) return base[2];
  for (std::size_t i = base.size(); i-- > 0;) {
    if (base[i] && words_.axes().contains(*base[i])) return base[i];
  }
  return std::nullopt;
}

bool BlockRun::compensation_number(char address, std::int32_t& number) {
  const Word* word = words_.find(address);
  if (word == nullptr) return true;
  const NumberResult result = integer_of(*word, 0.0, kCompensations);
  if (result.fault == NumberFault::range) return refuse("030DH", span(*word));
  if (result.fault != NumberFault::none) return refuse("031AH", span(*word));
  number = static_cast<std::int32_t>(result.value);
  return true;
}

bool BlockRun::rotation() {
  if (!words_.has(Group::rotation)) return true;
  registers.modal.set(Group::rotation, words_[Group::rotation]);
  if (words_[Group::rotation] == code(68)) return start_rotation();
  Placement& placement = registers.placement;
  if (!placement.rotation.active) return true;
  placement.rotation.active = false;
  placement.absolute_wanted = true;
  place_plane_at_machine(placement, false, registers.position);
  return true;
}

bool BlockRun::start_rotation() {
  Plane plane;
  if (!plane_axes(plane)) return false;
  for (const Axis axis : words_.axes()) {
    if (axis != plane.first && axis != plane.second)
      return refuse("0306H", span(axis), "G68 takes the two axes of the selected plane and R.");
  }
  Placement& placement = registers.placement;
  PlaneRotation next = placement.rotation;
  next.active = true;
  next.plane = plane;
  if (!rotation_center(plane.first, next.center.x) || !rotation_center(plane.second, next.center.y) ||
      !rotation_angle(next.angle_deg)) {
    return false;
  }
  next.turn = turn_by(next.angle_deg);
  placement.rotation = next;
  placement.absolute_wanted = true;
  // Type 0: the tool stays where it is, so it stands at other coordinates of the turned system. Type 1: it is
  // taken to have turned along, so its coordinates stay and the next move leads from where it really is.
  if (!rules_.settings().rotation_takes_start) place_plane_at_machine(placement, true, registers.position);
  return true;
}

/// Always absolute in the local coordinate system; without a word the place where the axis stands.
bool BlockRun::rotation_center(Axis axis, double& center) {
  const Placement& placement = registers.placement;
  center = placement.machine[axis] - placement.length_taken[axis];
  if (!words_.axes().contains(axis)) return true;
  const Word& word = *words_.axis(axis).word;
  if (!accept(word, position_of(word), center)) return false;
  center += workpiece_origin(registers, tables_)[axis];
  return true;
}

bool BlockRun::rotation_angle(double& angle) {
  const Word* word = words_.find('R');
  if (word == nullptr) return true;
  double value = 0.0;
  if (!accept(*word, radius_of(*word), value)) return false;
  if (registers.modal[Group::distance] == code(91)) value += angle;
  angle = std::fmod(value, 360.0);
  return true;
}

}  // namespace kerf::melsec
