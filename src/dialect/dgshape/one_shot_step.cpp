// Codes that act in their own block only: G04, G10, G28, G39, G53, G92.

#include <algorithm>

#include "dialect/dgshape/block_run.hpp"
#include "execute/moves.hpp"

namespace kerf::dgshape {
namespace {

constexpr double kLongestDwell = 3600.0;  // s, effective range of a dwell (manual G04)

}  // namespace

bool BlockRun::one_shot() {
  const CodeNumber number = words_[Group::one_shot];
  if (words_.has(Group::fixed_cycle) && words_[Group::fixed_cycle] != code(80)) {
    return refuse("conflicting-codes", span(Group::one_shot),
                  "A fixed cycle wants the words of the block for itself.");
  }
  // A tool-length offset that changes in the block is carried out by the block's own move, or before.
  const bool moves = number == code(28) || number == code(53);
  if (!moves && !length_move()) return false;
  switch (number) {
    case code(4):
      return dwell();
    case code(10):
      return data_setting();
    case code(28):
      return reference_return();
    case code(39):
      return corner_arc();
    case code(53):
      return machine_move();
    default:
      return set_coordinates();
  }
}

bool BlockRun::dwell() {
  double seconds = 0.0;
  if (words_.has('X') && words_.has('P')) {
    return refuse("conflicting-codes", span('P'), "The block gives the dwell time twice, with X and with P.");
  }
  if (words_.has('X')) {
    use("X");
    if (!accept('X', reader_.dwell_seconds(words_.word('X')), seconds)) return false;
  } else if (words_.has('P')) {
    if (!read_integer('P', seconds)) return false;
    seconds /= 1000.0;
  } else if (settings_.empty_dwell_alarm) {
    return refuse("missing-word", span(Group::one_shot), "G04 needs a time, X or P.");
  }
  queue_.push<Dwell>().seconds = std::clamp(seconds, 0.0, kLongestDwell);
  return true;
}

bool BlockRun::data_setting() {
  if (!words_.has('P')) return refuse("missing-word", span(Group::one_shot), "G10 needs a number P.");
  if (!words_.has('L')) return radius_data();
  double form = 0.0;
  if (!read_integer('L', form)) return false;
  if (form != 2.0) return refuse("data-words", span('L'), "The only data selected by L is L2.");
  return work_offset_data();
}

bool BlockRun::work_offset_data() {
  double number = 0.0;
  if (!read_integer('P', number)) return false;
  if (number < 0.0 || number > 6.0) return refuse("coordinate-number", span('P'));
  if (words_.has('R')) return refuse("data-words", span('R'));
  const auto index = static_cast<std::size_t>(number);
  write = {TableWrite::Kind::work_offset, index, tables_.work_offsets[index], 0.0};
  for (Axis axis : {Axis::X, Axis::Y, Axis::Z, Axis::A}) {
    if (words_.has(letter(axis)) && !axis_value(axis, write.offset[axis])) return false;
  }
  registers.unit_locked = true;
  return true;
}

bool BlockRun::radius_data() {
  double number = 0.0;
  if (!read_integer('P', number)) return false;
  for (char address : std::string_view("XYZA")) {
    if (words_.has(address)) {
      return refuse("data-words", span(address), "Coordinates need L2: G10L2P..X..Y..Z..A..");
    }
  }
  if (!words_.has('R'))
    return refuse("missing-word", span(Group::one_shot), "G10P needs the offset value R.");
  if (number < 1.0 || number > static_cast<double>(settings_.offset_numbers)) {
    return refuse(
        "offset-number", span('P'),
        FixedText<200>::format("The machine has tool-diameter offsets 1 to {}; offset 0 is always 0.",
                               settings_.offset_numbers));
  }
  double radius = 0.0;
  if (!read_distance('R', radius)) return false;
  write = {TableWrite::Kind::radius,
           static_cast<std::size_t>(number),
           {},
           std::clamp(radius, -settings_.max_offset, settings_.max_offset)};
  return true;
}

bool BlockRun::reference_return() {
  if (words_.has('A')) return refuse("reference-axis", span('A'));
  AxisVector destination_point = registers.position;
  // G28 is not scaled (DGS-401): the midpoint is read without the scaling in force.
  const CodeNumber scaling_code = registers.modal[Group::scaling];
  registers.modal.set(Group::scaling, code(50));
  const bool read = target_of_words("XYZ", destination_point);
  registers.modal.set(Group::scaling, scaling_code);
  if (!read) return false;
  for (Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    if (!words_.has(letter(axis))) continue;
    registers.midpoint[axis] = destination_point[axis];
    registers.midpoint_axes.insert(axis);
  }
  if (registers.midpoint_axes.empty()) return length_move();
  AxisVector middle = registers.position;
  for (Axis axis : registers.midpoint_axes) middle[axis] = registers.midpoint[axis];
  const bool plane_words =
      registers.midpoint_axes.contains(Axis::X) || registers.midpoint_axes.contains(Axis::Y);
  if (middle != registers.position || registers.length_offset != registers.length_applied ||
      (registers.offset_return_pending && plane_words)) {
    if (!push_move(MoveMode::rapid, middle)) return false;
    last_move().axis_words = plane_words;
    if (plane_words) registers.offset_return_pending = false;
  }
  AxisVector reference = registers.position;
  for (Axis axis : registers.midpoint_axes) reference[axis] = rules_.machine()[axis].home;
  // The reference point is where the machine itself stands, length offset or not.
  if (registers.midpoint_axes.contains(Axis::Z)) reference[Axis::Z] -= registers.length_offset;
  return reference == registers.position || push_move(MoveMode::rapid, reference);
}

bool BlockRun::corner_arc() {
  if (!offset_on()) return refuse("corner-arc", span(Group::one_shot));
  if (!cutting_allowed()) return false;
  AxisVector toward = registers.position;
  if (!target_of_words("XY", toward)) return false;
  CornerArc& arc = queue_.push<CornerArc>();
  arc.direction = {toward[Axis::X] - registers.position[Axis::X],
                   toward[Axis::Y] - registers.position[Axis::Y]};
  arc.feed = registers.feed;
  return true;
}

bool BlockRun::machine_move() {
  if (incremental()) return refuse("g53-incremental", span(Group::one_shot));
  AxisVector target = registers.position;
  for (Axis axis : {Axis::X, Axis::Y, Axis::Z, Axis::A}) {
    if (words_.has(letter(axis)) && !axis_value(axis, target[axis])) return false;
  }
  // The machine position itself is commanded, whatever the tool-length offset (DGS-415).
  if (words_.has('Z')) target[Axis::Z] -= registers.length_offset;
  if (target == registers.position && !returns_from_offset()) return length_move();
  return push_rapid(target);
}

bool BlockRun::set_coordinates() {
  if (registers.offset_return_pending) {
    return refuse("offset-active", span(Group::one_shot),
                  "The offset is cancelled, but the tool still stands beside the path.",
                  "Move X or Y after G40, before G92.");
  }
  const AxisVector origin = origin_;
  for (Axis axis : {Axis::X, Axis::Y, Axis::Z, Axis::A}) {
    if (!words_.has(letter(axis))) continue;
    double value = 0.0;
    if (!axis_value(axis, value)) return false;
    // The tool tip stands at the position without length offset, which therefore becomes the given
    // coordinate.
    registers.shift[axis] += registers.position[axis] - origin[axis] - value;
  }
  registers.unit_locked = true;
  update_origin();
  return true;
}

}  // namespace kerf::dgshape
