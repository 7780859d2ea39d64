#include "dialect/melsec/control_pairing.hpp"

#include <algorithm>

#include "dialect/melsec/alarms.hpp"

namespace kerf::melsec {
namespace {

/// An IF or a loop that is not closed yet.
struct Open {
  ControlKind kind = ControlKind::if_then;
  std::size_t control = 0;  ///< of the IF or the loop
  std::int16_t range = -1;
  std::int32_t number = 0;
  bool has_else = false;
  bool overlaps = false;  ///< a loop begins or ends in it and not the other way round
};

class Pairing {
 public:
  Pairing(CompiledProgram& program, const std::vector<Control>& controls)
      : program_(program), controls_(controls) {}

  void run() {
    for (now_ = 0; now_ < controls_.size(); ++now_) step();
    while (!open_.empty()) leave_unclosed();
    assign_innermost();
  }

 private:
  void step() {
    switch (controls_[now_].kind) {
      case ControlKind::if_then:
      case ControlKind::if_operation:
        open_if();
        break;
      case ControlKind::else_then:
        else_part();
        break;
      case ControlKind::end_if:
        end_if();
        break;
      case ControlKind::loop:
        open_loop();
        break;
      case ControlKind::end_loop:
        end_loop();
        break;
    }
  }

  void open_if() {
    const Control& control = controls_[now_];
    Statement& statement = program_.statements[control.statement];
    statement.range = static_cast<std::int16_t>(program_.ranges.size());
    program_.ranges.push_back({control.statement, kNoStatement, -1});
    // Without ELSE and ENDIF the IF conditions the operation of its own block.
    statement.jump = control.last + 1;
    open_.push_back({control.kind, now_, statement.range, 0, false});
  }

  void open_loop() {
    const Control& control = controls_[now_];
    for (const Open& open : open_) {
      if (open.kind == ControlKind::loop && open.number == control.number) return refuse(control, "0334H");
    }
    Statement& statement = program_.statements[control.statement];
    statement.loop = static_cast<std::int16_t>(program_.loops.size());
    program_.loops.push_back({control.statement, kNoStatement, -1});
    open_.push_back({control.kind, now_, statement.loop, control.number, false});
  }

  void else_part() {
    const Control& control = controls_[now_];
    while (!open_.empty()) {
      Open& innermost = open_.back();
      if (innermost.kind == ControlKind::loop) {
        if (Open* owner = innermost_if()) return overlap(*owner, control);
        break;
      }
      const bool adjacent =
          innermost.control + 1 == now_ && controls_[innermost.control].last + 1 == control.statement;
      const bool optional = innermost.kind == ControlKind::if_operation;
      const bool takes = !innermost.has_else && (!optional || adjacent || spare_end_if(open_.size()));
      if (takes) return join_else(innermost, control);
      if (!optional) break;
      drop_operation_if();
    }
    refuse(control, "0330H");
  }

  void join_else(Open& owner, const Control& control) {
    owner.has_else = true;
    Statement& otherwise = program_.statements[control.statement];
    otherwise.range = owner.range;
    otherwise.jump = control.last + 1;
    program_.statements[controls_[owner.control].statement].jump = control.statement + 1;
    program_.ranges[static_cast<std::size_t>(owner.range)].last = control.last;
  }

  void end_if() {
    const Control& control = controls_[now_];
    while (!open_.empty()) {
      const Open innermost = open_.back();
      if (innermost.kind == ControlKind::loop) {
        if (Open* owner = innermost_if()) {
          overlap(*owner, control);
          open_.erase(open_.begin() + (owner - open_.data()));
          return;
        }
        break;
      }
      const bool optional = innermost.kind == ControlKind::if_operation;
      if (!optional || spare_end_if(open_.size())) return close_if(innermost, control);
      drop_operation_if();
    }
    refuse(control, "0330H");
  }

  /// The innermost IF that is open; one of a single operation only when there is no other.
  Open* innermost_if() {
    for (std::size_t i = open_.size(); i-- > 0;) {
      if (open_[i].kind == ControlKind::if_then) return &open_[i];
    }
    for (std::size_t i = open_.size(); i-- > 0;) {
      if (open_[i].kind == ControlKind::if_operation) return &open_[i];
    }
    return nullptr;
  }

  /// An ELSE, ENDIF or END that overlaps: it raises the alarm, and so does the IF when it does not hold.
  void overlap(Open& owner, const Control& control) {
    refuse(control, "0334H");
    overlap_at(owner, control.statement);
  }

  void overlap_at(Open& owner, StatementIndex place) {
    owner.overlaps = true;
    program_.ranges[static_cast<std::size_t>(owner.range)].last = place;
    program_.statements[controls_[owner.control].statement].jump = place;
    lead_else(owner.range, place);
  }

  /// The THEN part of an IF goes on at `place` behind its ELSE.
  void lead_else(std::int16_t range, StatementIndex place) {
    for (StatementIndex i = program_.ranges[static_cast<std::size_t>(range)].first; i < place; ++i) {
      Statement& statement = program_.statements[i];
      if (statement.kind == StatementKind::else_part && statement.range == range) statement.jump = place;
    }
  }

  void close_if(const Open& owner, const Control& control) {
    open_.pop_back();
    StatementRange& range = program_.ranges[static_cast<std::size_t>(owner.range)];
    range.last = control.statement;
    Statement& condition = program_.statements[range.first];
    if (!owner.has_else && !owner.overlaps) condition.jump = control.statement;
    lead_else(owner.range, control.statement);
  }

  void end_loop() {
    const Control& control = controls_[now_];
    // IFs of one operation need no ENDIF; any other open IF or loop would overlap.
    while (!open_.empty() && open_.back().kind == ControlKind::if_operation) drop_operation_if();
    const bool own =
        !open_.empty() && open_.back().kind == ControlKind::loop && open_.back().number == control.number;
    if (!own) return end_elsewhere(control);
    const std::int16_t loop = open_.back().range;
    open_.pop_back();
    StatementRange& range = program_.loops[static_cast<std::size_t>(loop)];
    range.last = control.statement;
    program_.statements[range.first].jump = control.statement + 1;
    Statement& end = program_.statements[control.statement];
    end.loop = loop;
    end.jump = range.first;
  }

  /// An END behind the beginning of an IF inside its loop, or one without a loop.
  void end_elsewhere(const Control& control) {
    refuse(control, "0334H");
    const auto loop = std::find_if(open_.begin(), open_.end(), [&](const Open& open) {
      return open.kind == ControlKind::loop && open.number == control.number;
    });
    if (loop == open_.end()) return;
    for (auto inside = loop + 1; inside != open_.end(); ++inside) {
      if (inside->kind != ControlKind::loop) overlap_at(*inside, control.statement);
    }
    StatementRange& range = program_.loops[static_cast<std::size_t>(loop->range)];
    range.last = control.statement;
    program_.statements[range.first].jump = control.statement;
    open_.erase(loop);
  }

  /// Ends the innermost IF of one operation where its block, or that of its ELSE, ends.
  void drop_operation_if() {
    const Open owner = open_.back();
    open_.pop_back();
    StatementRange& range = program_.ranges[static_cast<std::size_t>(owner.range)];
    if (!range.closed()) range.last = controls_[owner.control].last;
  }

  void leave_unclosed() {
    const Open owner = open_.back();
    if (owner.kind == ControlKind::if_operation) return drop_operation_if();
    open_.pop_back();
    // A WHILE or DO without END stays open: it raises its alarm where it would have to jump.
    if (owner.kind == ControlKind::if_then) refuse(controls_[owner.control], "0330H");
  }

  /// Whether the ENDIFs from here on are enough to give one to the innermost of the first `open` entries, an
  /// IF of one operation, and still one to every IF that needs it. An ENDIF right behind the operation of a
  /// later IF counts as its own.
  bool spare_end_if(std::size_t open) const {
    std::size_t needed = 1;
    for (std::size_t i = 0; i + 1 < open; ++i) {
      if (open_[i].kind == ControlKind::if_then) ++needed;
    }
    std::vector<bool> later;  // IFs opened behind this place: whether they need an ENDIF
    for (std::size_t i = now_; i < controls_.size() && needed > 0; ++i) {
      const ControlKind kind = controls_[i].kind;
      if (kind == ControlKind::if_then || kind == ControlKind::if_operation) {
        later.push_back(kind == ControlKind::if_then);
      } else if (kind == ControlKind::end_if) {
        const bool behind_operation = !later.empty() && !later.back() && belongs_to_operation(i);
        while (!behind_operation && !later.empty() && !later.back()) later.pop_back();
        if (!later.empty()) {
          later.pop_back();
        } else {
          --needed;
        }
      }
    }
    return needed == 0;
  }

  /// The control in front of an ENDIF is an IF of one operation, or its ELSE.
  bool belongs_to_operation(std::size_t end_if) const {
    std::size_t before = end_if;
    while (before-- > 0) {
      const ControlKind kind = controls_[before].kind;
      if (kind == ControlKind::if_operation) return true;
      if (kind != ControlKind::else_then) return false;
    }
    return false;
  }

  void refuse(const Control& control, std::string_view detail) {
    Statement& statement = program_.statements[control.statement];
    program_.faults.push_back({&alarm_kind(detail), statement.span});
    statement.kind = StatementKind::fault;
    statement.jump = static_cast<StatementIndex>(program_.faults.size() - 1);
    statement.loop = statement.range = -1;
  }

  /// The innermost loop and range around every statement, and their parents.
  void assign_innermost() {
    sweep(program_.loops, &Statement::loop);
    sweep(program_.ranges, &Statement::range);
  }

  void sweep(std::vector<StatementRange>& ranges, std::int16_t Statement::*innermost) {
    std::vector<std::int16_t> around;
    std::size_t next = 0;  // ranges are in the order of their first statements
    for (StatementIndex i = 0; i < program_.statements.size(); ++i) {
      while (!around.empty() && !ranges[static_cast<std::size_t>(around.back())].contains(i))
        around.pop_back();
      for (; next < ranges.size() && ranges[next].first == i; ++next) {
        ranges[next].parent = around.empty() ? std::int16_t{-1} : around.back();
        around.push_back(static_cast<std::int16_t>(next));
      }
      program_.statements[i].*innermost = around.empty() ? std::int16_t{-1} : around.back();
    }
  }

  CompiledProgram& program_;
  const std::vector<Control>& controls_;
  std::vector<Open> open_;
  std::size_t now_ = 0;
};

}  // namespace

void pair_controls(CompiledProgram& program, const std::vector<Control>& controls) {
  Pairing(program, controls).run();
}

}  // namespace kerf::melsec
