// G31: the motors go to their targets, and each stops where its skip input turns on (manual chapter 2).

#include <cmath>

#include "dialect/omron/block_run.hpp"

namespace kerf::omron {
namespace {

/// A motor that has run on by less stays there.
constexpr double kLeastWayBack = 1e-4;  // mm or degrees

bool runs_on(const SkipStop& stop) {
  const AxisVector way = stop.braked - stop.captured;
  for (const double axis : way.values) {
    if (std::abs(axis) >= kLeastWayBack) return true;
  }
  return false;
}

}  // namespace

bool BlockRun::skip_move() {
  if (is_compensating()) return refuse("compensation-word", span(words_.word(Group::one_shot)));
  if (words_.axes().empty()) return true;
  AxisVector target = registers.position;
  if (!targets(target)) return false;
  const AxisVector start = registers.placement.machine;
  const AxisVector end = real_position(target, words_.axes());
  // The whole way to the target must be free, wherever the signals come.
  const bool moves = end != start;
  if (moves && !push(MoveMode::rapid, end, target - workpiece_origin(registers, tables_))) return false;
  arrive(target, words_.axes());
  if (taking_over_) return true;
  const SkipStop stop = skip_stop(start, end, rules_.machine(), kSkipRates, settings_.skip_inputs);
  captured = Captured{words_.axes(), stop.captured};
  for (const Axis axis : words_.axes()) {
    if (rules_.machine()[axis].type == AxisType::linear) captured->positions[axis] /= unit_mm_;
  }
  if (moves) go_to(stop);
  return true;
}

/// Makes the move pushed last one that ends by the signals: on to where the motors have braked, and back to
/// where the signals came.
void BlockRun::go_to(const SkipStop& stop) {
  const AxisVector origin = workpiece_origin(registers, tables_);
  const auto lead_to = [&](Move& move, const AxisVector& position) {
    stand_at(position);
    move.end = position;
    move.commanded = registers.position - origin;
  };
  Move there = std::get<Move>(queue_.last().what);
  there.rates = kSkipRates;
  there.from_rest = there.exact_stop = true;
  if (runs_on(stop)) {
    lead_to(there, stop.braked);
    queue_.last().what = there;
    there.start = stop.braked;
    queue_.push<Move>() = there;
  }
  lead_to(there, stop.captured);
  queue_.last().what = there;
}

}  // namespace kerf::omron
