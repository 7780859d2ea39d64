// Modal G codes: unit, plane, distances, coordinate system, scaling, compensations, motion and cycle.

#include <algorithm>

#include "dialect/dgshape/block_run.hpp"

namespace kerf::dgshape {

bool BlockRun::modal() {
  if (offset_was_on_ && !offset_restrictions()) return false;
  if (!unit_and_plane()) return false;
  motion_and_cycle();
  work_system();
  return scaling() && radius_offset() && length_offset() && (offset_was_on_ || offset_start_restrictions());
}

bool BlockRun::offset_start_restrictions() {
  // The block's coordinate system and scaling act before its offset; what acts after it, acts under it.
  if (!offset_on()) return true;
  if (registers.modal[Group::fixed_cycle] != code(80)) {
    return refuse("offset-active",
                  span(words_.has(Group::fixed_cycle) ? Group::fixed_cycle : Group::radius_compensation),
                  "A fixed cycle is in force when the offset starts.");
  }
  return offset_forbids_one_shot();
}

bool BlockRun::offset_restrictions() {
  // Manual, restrictions on tool-diameter offset: 4 coordinate systems, 8 fixed cycles and scaling, 9 G28.
  // G53 would miss its point (cautions for the use of G53).
  for (Group group : {Group::work_system, Group::fixed_cycle, Group::scaling}) {
    if (words_.has(group)) return refuse("offset-active", span(group));
  }
  return offset_forbids_one_shot();
}

bool BlockRun::offset_forbids_one_shot() {
  switch (words_[Group::one_shot]) {
    case code(10):
    case code(28):
    case code(53):
    case code(92):
      return refuse("offset-active", span(Group::one_shot));
    default:
      return true;
  }
}

bool BlockRun::unit_and_plane() {
  if (words_.has(Group::unit)) {
    if (registers.unit_locked && words_[Group::unit] != registers.modal[Group::unit]) {
      return refuse("unit-change", span(Group::unit));
    }
    registers.modal.set(Group::unit, words_[Group::unit]);
  }
  for (Group group : {Group::plane, Group::distance, Group::return_level}) {
    if (words_.has(group)) registers.modal.set(group, words_[group]);
  }
  if (offset_was_on_ && registers.modal[Group::plane] != code(17)) {
    return refuse("offset-plane", span(Group::plane));
  }
  return true;
}

void BlockRun::motion_and_cycle() {
  const bool motion_code = words_.has(Group::motion);
  const bool cycle_code = words_.has(Group::fixed_cycle);
  if (motion_code) registers.modal.set(Group::motion, words_[Group::motion]);
  const bool cycle_meant = cycle_code && (!motion_code || words_.cycle_behind_motion());
  if (cycle_meant) {
    const bool starts =
        registers.modal[Group::fixed_cycle] == code(80) && words_[Group::fixed_cycle] != code(80);
    if (starts) {
      registers.cycle = {};
      registers.cycle.initial_level = registers.position[Axis::Z];
    }
    registers.modal.set(Group::fixed_cycle, words_[Group::fixed_cycle]);
  } else if (motion_code) {
    registers.modal.set(Group::fixed_cycle, code(80));  // G00 to G03 end a fixed cycle (DGS-467)
  }
}

void BlockRun::work_system() {
  if (!words_.has(Group::work_system)) return;
  registers.modal.set(Group::work_system, words_[Group::work_system]);
  registers.unit_locked = true;
  update_origin();
}

bool BlockRun::scaling() {
  if (!words_.has(Group::scaling)) return true;
  registers.modal.set(Group::scaling, words_[Group::scaling]);
  if (words_[Group::scaling] == code(50)) {
    registers.scaling = {};
    return true;
  }
  if (words_.has(Group::one_shot)) {
    return refuse("conflicting-codes", span(Group::one_shot),
                  "G51 wants the words X, Y, Z and P for itself.");
  }
  if (!words_.has('P'))
    return refuse("missing-word", span(Group::scaling), "G51 needs the scaling factor P.");
  use("P");
  double factor = 0.0;
  if (!accept('P', reader_.scale(words_.word('P')), factor)) return false;
  AxisVector reference = registers.position - origin_;
  for (char address : std::string_view("XYZ")) {
    if (words_.has(address) && !read_distance(address, reference[*axis_from_letter(address)])) return false;
  }
  // A factor outside the limits becomes the limit without an error (manual G51).
  registers.scaling = {std::clamp(factor, 0.001, 999.999), reference};
  return true;
}

bool BlockRun::radius_number(std::int32_t& number) {
  double value = 0.0;
  if (!read_integer('D', value)) return false;
  if (value < 0.0 || value > static_cast<double>(settings_.offset_numbers)) {
    return refuse(
        "offset-number", span('D'),
        FixedText<200>::format("The machine has tool-diameter offsets 1 to {}.", settings_.offset_numbers));
  }
  number = static_cast<std::int32_t>(value);
  return true;
}

bool BlockRun::radius_offset() {
  std::int32_t number = registers.radius_number;
  if (words_.has('D') && !radius_number(number)) return false;
  const CodeNumber before = registers.modal[Group::radius_compensation];
  const CodeNumber wanted =
      words_.has(Group::radius_compensation) ? words_[Group::radius_compensation] : before;
  const bool arc = registers.modal[Group::motion] > code(1);
  if (wanted == code(40)) {
    if (offset_was_on_ && arc) return refuse("offset-end-arc", span(Group::radius_compensation));
    registers.offset_return_pending = registers.offset_return_pending || offset_was_on_;
  } else if (offset_was_on_) {
    if (wanted != before) return refuse("offset-change", span(Group::radius_compensation));
    if (number != registers.radius_number) return refuse("offset-change", span('D'));
    if (words_.has(Group::radius_compensation) && words_.has(Group::motion) && arc) {
      return refuse("offset-start-arc", span(Group::radius_compensation));
    }
  } else {
    const SourceSpan where = span(Group::radius_compensation);
    if (registers.modal[Group::plane] != code(17)) return refuse("offset-plane", where);
    if (arc) return refuse("offset-start-arc", where);
    if (number < 0) return refuse("missing-word", where, "G41 and G42 need the offset number D.");
    const double amount = tables_.radius[static_cast<std::size_t>(number)];
    registers.radius_amount = std::clamp(amount, -settings_.max_offset, settings_.max_offset);
    ++registers.radius_start;
    registers.offset_return_pending = false;  // the new offset starts where the old one left the tool
  }
  registers.radius_number = number;
  registers.modal.set(Group::radius_compensation, wanted);
  return true;
}

bool BlockRun::length_offset() {
  if (!words_.has(Group::length_compensation)) return true;
  const CodeNumber wanted = words_[Group::length_compensation];
  const SourceSpan where = span(Group::length_compensation);
  double number = 0.0;
  if (wanted == code(43)) {
    if (!words_.has('H')) return refuse("missing-word", where, "G43 needs the offset number H.");
    if (!read_integer('H', number)) return false;
    if (number < 0.0 || number > static_cast<double>(settings_.length_numbers)) {
      return refuse(
          "length-number", span('H'),
          FixedText<200>::format("The machine has tool-length offsets 1 to {}.", settings_.length_numbers));
    }
    if (!settings_.tool_changer && number > 0.0) return refuse("no-tool-changer", where);
  }
  registers.length_number = static_cast<std::int32_t>(number);
  registers.length_offset = tables_.length[static_cast<std::size_t>(number)];
  registers.modal.set(Group::length_compensation, registers.length_number == 0 ? code(49) : code(43));
  return true;
}

}  // namespace kerf::dgshape
