// Tool radius compensation as the blocks command it (G40, G41, G42, D; manual 5.6, 6.4). Where the tool goes
// is the business of the toolpath (RadiusCompensationPass).

#include "dialect/melsec/alarms.hpp"
#include "dialect/melsec/block_run.hpp"
#include "dialect/melsec/radius.hpp"
#include "execute/moves.hpp"

namespace kerf::melsec {
namespace {

constexpr CodeSet kVectorCodes = set_of(code(40)) | set_of(code(41)) | set_of(code(42));

}  // namespace

bool is_compensated(const Registers& registers) {
  return registers.modal[Group::radius_compensation] != code(40) && registers.radius_number > 0;
}

RadiusCompensation compensation_in_force(const Registers& registers) {
  RadiusCompensation compensation;
  if (!is_compensated(registers)) return compensation;
  const bool left = registers.modal[Group::radius_compensation] == code(41);
  compensation.side = left ? Side::left : Side::right;
  compensation.amount = registers.radius_amount;
  compensation.start = registers.radius_start;
  return compensation;
}

std::optional<Plane> plane_of(CodeNumber selected, const ControllerSettings& settings) {
  const std::size_t first = selected == code(17) ? 0 : selected == code(18) ? 2 : 1;
  const auto a = settings.base[first];
  const auto b = settings.base[(first + 1) % 3];
  if (!a || !b) return std::nullopt;
  return Plane{*a, *b, settings.base[(first + 2) % 3].value_or(Axis::Z)};
}

bool BlockRun::radius_compensation() {
  was_compensated_ = is_compensated(registers);
  if (words_.find('D') != nullptr) {
    std::int32_t number = 0;
    if (!compensation_number('D', number)) return false;
    registers.radius_number = number;
  }
  if (words_.has(Group::radius_compensation)) {
    const CodeNumber wanted = words_[Group::radius_compensation];
    if (wanted != code(40) && registers.radius_number < 0) {
      return refuse("030DH", span(words_.word(Group::radius_compensation)));
    }
    registers.modal.set(Group::radius_compensation, wanted);
  }
  if (!is_compensated(registers)) return true;
  registers.radius_amount = tables_.radius[static_cast<std::size_t>(registers.radius_number)];
  if (!was_compensated_) ++registers.radius_start;
  return true;
}

/// Fills in what the compensation does to a move.
bool BlockRun::compensate(Move& move) {
  if (!is_compensated(registers) && !was_compensated_) return true;
  Plane plane;
  if (!plane_axes(plane)) return false;
  move.plane = plane;
  move.axis_words = true;
  if (!vector_direction(plane, move.compensation.direction)) return false;
  if (!is_compensated(registers)) return true;
  const std::array<double, 2> direction = move.compensation.direction;
  move.compensation = compensation_in_force(registers);
  move.compensation.direction = direction;
  move.compensation.rule = vector_rule(move);
  move.compensation.suspended = words_.has(kMachineMove);
  return true;
}

/// I, J and K of the plane, which beside G41, G42, G38 and G40 are a direction; {0, 0} without them.
bool BlockRun::vector_direction(const Plane& plane, std::array<double, 2>& direction) {
  direction = {};
  const CodeSet codes = words_.codes();
  if ((codes & (kVectorCodes | kCornerVector)) == 0) return true;
  for (std::size_t i = 0; i < 2; ++i) {
    const Word* word = words_.find(center_address(i == 0 ? plane.first : plane.second));
    if (word != nullptr && !accept(*word, position_of(*word), direction[i])) return false;
  }
  return true;
}

VectorRule BlockRun::vector_rule(const Move& move) const {
  const bool given = move.compensation.direction != std::array<double, 2>{};
  if (words_.has(kCornerVector)) return given ? VectorRule::along : VectorRule::kept;
  return given ? VectorRule::at_right_angles : VectorRule::computed;
}

/// G39 turns about the corner at the end of its block.
void BlockRun::corner_arc() {
  if (!words_.has(kCornerArc) || taking_over_ || !is_compensated(registers)) return;
  queue_.push<CornerArc>().feed = registers.feed;
}

/// A start or an end of the compensation in a block that moves nothing is told by a move of no length.
bool BlockRun::compensation_at_rest() {
  const bool on = is_compensated(registers);
  const bool commanded = words_.has(Group::radius_compensation);
  if (on == was_compensated_ && !(on && commanded)) return true;
  const MoveMode mode = registers.modal[Group::motion] == code(0) ? MoveMode::rapid : MoveMode::linear;
  const AxisVector& here = registers.placement.machine;
  return push(mode, here, registers.position - workpiece_origin(registers, tables_));
}

}  // namespace kerf::melsec
