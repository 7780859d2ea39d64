#pragma once
// Actions in, control cycles out: the seam where acceleration laws plug in.

#include <algorithm>
#include <concepts>
#include <variant>

#include "motion/followers.hpp"
#include "motion/look_ahead_trapezoid.hpp"
#include "motion/polar_pieces.hpp"

namespace kerf {

/// What an acceleration law must do. A law owns the whole way from actions to cycles: one that plans speeds
/// along the path (LookAheadTrapezoid), one that filters interpolated positions, one with S-curves per block.
/// What the members mean is documented at LookAheadTrapezoid. Axes that follow another one are no business of
/// a law: it leaves them out of its sums, and the trajectory places them. Moves in a polar plane come to it
/// in pieces. A new law is a class and one more alternative of Trajectory::Law.
template <class T>
concept TrajectoryLaw = requires(T law, const T& seen, const Action& action, Cycle& cycle,
                                 BlockObserver on_block) {
  { seen.wants_action() } -> std::same_as<bool>;
  law.push(action);
  law.finish();
  { law.step(cycle, on_block) } -> std::same_as<StepResult>;
  law.set_feed_override(100.0);
  law.set_rapid_override(100.0);
  { law.skip_steady() } -> std::same_as<std::uint64_t>;
  { seen.time_s() } -> std::same_as<double>;
  { seen.cycles() } -> std::same_as<std::uint64_t>;
  { seen.extremes() } -> std::same_as<const MotionExtremes&>;
};

/// One axis command generator with the law that the machine asks for. The loop of its caller:
///
///     while (trajectory.wants_action() && source has an action) trajectory.push(action);
///     if (the source is exhausted) trajectory.finish();
///     switch (trajectory.step(cycle)) ...
class Trajectory {
 public:
  using Law = std::variant<LookAheadTrapezoid>;

  Trajectory(const Machine& machine, const FeedPolicy& policy)
      : law_(LookAheadTrapezoid(machine, policy)), followers_(machine) {}

  bool wants_action() const { return pieces_.empty() && law_wants_action(); }
  void push(const Action& action) {
    finish_waits_ = false;
    const auto* move = std::get_if<Move>(&action.what);
    if (move == nullptr || move->polar.form != PolarForm::axes) return push_whole(action);
    pieces_.take(action);
    push_pieces();
  }
  void finish() {
    finish_waits_ = true;
    push_pieces();
  }
  StepResult step(Cycle& cycle, BlockObserver on_block) {
    push_pieces();
    const auto book = [&](const BlockTiming& timing) { add_up(timing, on_block); };
    StepResult result = std::visit([&](auto& law) { return law.step(cycle, book); }, law_);
    while (result == StepResult::needs_action && !pieces_.empty()) {
      push_pieces();
      result = std::visit([&](auto& law) { return law.step(cycle, book); }, law_);
    }
    followers_.follow(cycle);
    return result;
  }
  StepResult step(Cycle& cycle) {
    return step(cycle, [](const BlockTiming&) {});
  }
  void set_feed_override(double percent) {
    std::visit([=](auto& law) { law.set_feed_override(percent); }, law_);
  }
  void set_rapid_override(double percent) {
    std::visit([=](auto& law) { law.set_rapid_override(percent); }, law_);
  }
  std::uint64_t skip_steady() {
    return std::visit([](auto& law) { return law.skip_steady(); }, law_);
  }
  double time_s() const {
    return std::visit([](const auto& law) { return law.time_s(); }, law_);
  }
  std::uint64_t cycles() const {
    return std::visit([](const auto& law) { return law.cycles(); }, law_);
  }
  MotionExtremes extremes() const {
    return followers_.completed(std::visit([](const auto& law) { return law.extremes(); }, law_));
  }

 private:
  bool law_wants_action() const {
    return std::visit([](const auto& law) { return law.wants_action(); }, law_);
  }
  void push_whole(const Action& action) {
    std::visit([&](auto& law) { law.push(action); }, law_);
  }
  /// As far as there is room.
  void push_pieces() {
    while (!pieces_.empty() && law_wants_action()) push_whole(pieces_.next());
    if (!finish_waits_ || !pieces_.empty()) return;
    finish_waits_ = false;
    std::visit([](auto& law) { law.finish(); }, law_);
  }
  /// The times of the pieces are told as those of the move.
  void add_up(const BlockTiming& piece, BlockObserver on_block) {
    if (piece.goes_on || in_pieces_) {
      if (!in_pieces_) whole_ = {piece.kind, piece.start_s};
      whole_.duration_s += piece.duration_s;
      whole_.length_mm += piece.length_mm;
      whole_.peak_feed_mm_min = std::max(whole_.peak_feed_mm_min, piece.peak_feed_mm_min);
      in_pieces_ = piece.goes_on;
      if (!in_pieces_) on_block(whole_);
      return;
    }
    on_block(piece);
  }

  Law law_;
  Followers followers_;
  PolarPieces pieces_;
  BlockTiming whole_;          ///< of the pieces finished so far
  bool in_pieces_ = false;     ///< more of them follow
  bool finish_waits_ = false;  ///< for the pieces to be pushed
};

static_assert(TrajectoryLaw<LookAheadTrapezoid>);

}  // namespace kerf
