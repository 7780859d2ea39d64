#pragma once
// Overcuts over several blocks: what stands in front of the tool radius compensation where a policy wants the
// contour ahead looked at (OMRON, G40 to G42: detection and prevention of overcuts).

#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/fixed_queue.hpp"
#include "execute/action.hpp"
#include "execute/toolpath_policy.hpp"
#include "toolpath/contour_view.hpp"

namespace kerf {

/// Holds actions back until so much of a compensated contour is seen as the policy says, and looks whether
/// the tool can go on beside each block to the next without cutting into any of them.
///
/// - Where it can, the block is given out as it came.
/// - Where it cannot, and the policy avoids interference, the tool goes over to a block ahead where their
///   paths first meet clear of all others, or around a corner between such blocks: led() gives the way. The
///   blocks between lose their motion in the plane; what moves nothing then is left out.
/// - Otherwise an alarm of the policy's interference kind follows the block: the block is not to be made.
///
/// The contour's blocks are those after the straight one that starts the compensation. It ends where the
/// compensation ends or changes, and in front of alarms. Nothing is allocated; the work of a block is bounded
/// by the number of blocks seen.
class OvercutCheck {
 public:
  explicit OvercutCheck(const RadiusCompensationPolicy& policy);

  bool is_on() const { return policy_.sees_contour_ahead; }

  /// The next action, valid until the following call; nullptr at the end. Upstream as for
  /// RadiusCompensationPass.
  template <class Upstream>
  const Action* next(Upstream& upstream) {
    for (;;) {
      while (wants_more()) {
        const Action* action = upstream.next();
        if (action == nullptr) break;
        if (queue_.empty() && state_.off && !commands_side(*action)) return action;
        add(*action);
      }
      if (queue_.empty() && !refused_) return nullptr;
      if (const Action* action = take()) return action;
    }
  }

  /// The corner behind the block that next() gave out last; nothing when it is the usual one.
  const std::optional<Corner>& led() const { return led_; }

  void reset();
  /// The compensation raised an alarm: it is off until the next straight block.
  void restart();

 private:
  enum class Kind : std::uint8_t {
    other,    ///< no motion beside the contour
    start,    ///< the straight block that starts the compensation
    contour,  ///< one beside which the tool goes
    skipped,  ///< one of these that is left out
    end,      ///< nothing behind it belongs to the contour
  };

  struct Entry {
    Action action;
    Kind kind = Kind::other;
    SeenBlock block;  ///< of the contour
  };

  /// Of the compensation behind the last action queued.
  struct State {
    bool off = true;
    bool has_block = false;  ///< the contour has one
    RadiusCompensation compensation;
    Plane plane;
    SeenBlock last;
  };

  /// A way on from a block: by the corner to a block ahead.
  struct Passage {
    std::size_t to = 0;  ///< place in the queue
    Corner corner;
    double advance_mm = 0.0;  ///< along the block it leaves
  };

  /// A block, or a round corner, that the tool is to leave.
  struct Leaving {
    const SeenBlock& block;
    Vec2 entry;
    std::size_t place = 0;  ///< of the block in the queue, or of the one before the corner
    Extensions extensions;
  };

  static bool commands_side(const Action& action);
  bool wants_more() const;
  void add(const Action& action);
  Kind enter(const Action& action, SeenBlock& block);
  Kind enter_move(const Move& move, std::uint32_t number, SeenBlock& block);
  Kind enter_contour(const Move& move, std::uint32_t number, SeenBlock& block);

  const Action* take();
  void start(const Move& move);
  void pass_by(const SeenBlock& block);
  bool strip_skipped(Action& action) const;
  void check(Entry& entry);
  bool keeps_out(const SeenBlock& block, const Corner& corner) const;
  bool keeps_out(const SeenWay& way) const;
  bool reaches(std::size_t next, const Corner& corner) const;
  bool passes_corner(const SeenBlock& block, Vec2 end) const;
  bool ends_well(const SeenBlock& block) const;
  std::optional<Passage> passage_behind(const SeenBlock& block) const;
  std::optional<Passage> passage_from(const Leaving& leaving) const;
  std::optional<Passage> passage_around_corners(const Leaving& leaving) const;
  std::optional<Passage> passage_around(const Leaving& leaving, Vec2 point, std::size_t before) const;
  void try_passage(const Leaving& leaving, std::size_t to, Vec2 point, std::optional<Passage>& best) const;
  std::optional<Passage> bridge_from(const Leaving& leaving) const;
  void try_bridge(const Leaving& leaving, std::size_t to, Vec2 point, std::optional<Passage>& best) const;
  bool is_way_on(const Leaving& leaving, Vec2 point, const std::optional<Passage>& best) const;
  std::optional<Corner> round_corner_behind(std::size_t place) const;
  Extensions extensions_of(std::size_t place) const;
  void lead_to(Entry& entry, const Passage& passage);
  std::size_t next_of_contour(std::size_t place) const;
  std::size_t last_of_contour(std::size_t place) const;
  CornerRules rules(double left_mm) const;

  static constexpr std::size_t kEntries = 80;
  static constexpr std::size_t kBehind = 64;

  RadiusCompensationPolicy policy_;
  State state_;
  FixedQueue<Entry, kEntries> queue_;
  FixedQueue<SeenBlock, kBehind> behind_;  ///< the contour's last blocks, left out or not
  Vec2 start_direction_;
  std::optional<Vec2> entry_;  ///< where the tool enters the first block queued; none: beside its start
  bool starts_ = false;        ///< the first block queued follows the starting block
  bool refused_ = false;       ///< the alarm is to follow
  Action alarm_;
  std::optional<Corner> led_;
  AxisVector passed_;  ///< where the program is behind the block that was led on
};

}  // namespace kerf
