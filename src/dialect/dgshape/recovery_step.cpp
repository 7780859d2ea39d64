// What a check takes over of a refused block, so that one mistake gives one alarm.

#include "dialect/dgshape/block_run.hpp"

namespace kerf::dgshape {

void BlockRun::take_over() {
  if (!words_.collect(block_, rules_.codes(), alarm)) return;
  if (words_.has('N')) numbers();
  take_over_codes();
  reader_ = NumberReader(settings_, registers.modal[Group::unit] == code(20));
  double value = 0.0;
  if (words_.has('F') && accept('F', reader_.feed(words_.word('F')), value) && value >= 0.0) {
    registers.feed = value;
  }
  // That the feed is missing is said once, and that the spindle stands still is no fault of the blocks
  // behind.
  registers.feed_given = true;
  for (const std::uint8_t i : words_.m_words()) {
    const auto number = words_.at(i).number.digits;
    if (number == 3 || number == 5) registers.spindle_on = number == 3;
    if (number == 2 || number == 30) ends_program = true;
  }
  take_over_end();
}

void BlockRun::take_over_codes() {
  // Offsets and scaling need words that may be the wrong ones; without them the blocks behind still make
  // sense.
  for (Group group : {Group::unit, Group::plane, Group::distance, Group::return_level, Group::work_system}) {
    if (words_.has(group)) registers.modal.set(group, words_[group]);
  }
  if (words_[Group::radius_compensation] == code(40)) {
    registers.modal.set(Group::radius_compensation, code(40));
  }
  motion_and_cycle();
  update_origin();
}

void BlockRun::take_over_end() {
  if (words_.has(Group::one_shot) || words_[Group::scaling] == code(51)) return;
  const bool in_cycle = registers.modal[Group::fixed_cycle] != code(80);
  AxisVector target = registers.position;
  for (char address : in_cycle ? std::string_view("XY") : std::string_view("XYZA")) {
    target_of_words({&address, 1}, target);  // a word that cannot be read leaves its axis where it is
  }
  if (offset_on()) {
    // The compensated contour goes on without a gap.
    push_move(MoveMode::linear, target);
  } else {
    registers.position = target;
  }
}

}  // namespace kerf::dgshape
