#pragma once
// Actions in, control cycles out: the seam where acceleration laws plug in.

#include <concepts>
#include <variant>

#include "motion/followers.hpp"
#include "motion/look_ahead_trapezoid.hpp"

namespace kerf {

/// What an acceleration law must do. A law owns the whole way from actions to cycles: one that plans speeds
/// along the path (LookAheadTrapezoid), one that filters interpolated positions, one with S-curves per block.
/// What the members mean is documented at LookAheadTrapezoid. Axes that follow another one are no business of
/// a law: it leaves them out of its sums, and the trajectory places them. A new law is a class and one more
/// alternative of Trajectory::Law.
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

  bool wants_action() const {
    return std::visit([](const auto& law) { return law.wants_action(); }, law_);
  }
  void push(const Action& action) {
    std::visit([&](auto& law) { law.push(action); }, law_);
  }
  void finish() {
    std::visit([](auto& law) { law.finish(); }, law_);
  }
  StepResult step(Cycle& cycle, BlockObserver on_block) {
    const StepResult result = std::visit([&](auto& law) { return law.step(cycle, on_block); }, law_);
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
  Law law_;
  Followers followers_;
};

static_assert(TrajectoryLaw<LookAheadTrapezoid>);

}  // namespace kerf
