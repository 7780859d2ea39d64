#pragma once
// The controller under test: makes it as a case asks, runs the case's programs on it, and keeps what they
// gave.

#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "conformance/runner/case.hpp"
#include "dialect/setup.hpp"
#include "toolpath/toolpath.hpp"

namespace kerf::conformance {

/// What one program did, and the controller's state behind it.
struct ProgramRun {
  std::vector<Action> actions;
  std::vector<Entry> events;  ///< of all kinds, moves of no length left out
  State state;
  AxisVector work_position;  ///< what the controller shows at the end
  AxisVector work_origin;    ///< machine coordinates, of the system in force at the end
  AxisVector position;       ///< machine coordinates where the axes stand at the end
  Spindle spindle;           ///< the last spindle action; off before any
};

/// Programs of a case follow each other on one controller: offsets, shifts, tool and positions carry over.
class Rig {
 public:
  /// The error is the events `refused KEY` or `refused 0016H`, one for each complaint.
  static tl::expected<Rig, std::vector<Entry>> make(const Case& test, const std::string& dialect);

  /// Runs the next program to its end or to its first alarm; with the case's `recover` to its end.
  /// `text` is its text with the line ends the case asks for; `program` holds those it may call.
  ProgramRun run(const ProgramSection& program, const std::string& text);

  const Controller& controller() const { return controller_; }

 private:
  Rig(Controller controller, bool recover);

  Controller controller_;
  bool recover_ = false;
  AxisVector position_;
  Spindle spindle_;
  /// The programs that may be called now; shared with the interpreter, which outlives moves of the rig.
  std::shared_ptr<std::map<std::int32_t, std::string>> others_;
  std::unique_ptr<Interpreter> interpreter_;  ///< from the first program on
};

}  // namespace kerf::conformance
