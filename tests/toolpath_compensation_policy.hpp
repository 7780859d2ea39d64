#pragma once
// A policy for tests of the tool radius compensation, with alarms of its own.

#include <string>
#include <vector>

#include "toolpath/radius_compensation.hpp"
#include "toolpath_program.hpp"

namespace kerf::toolpath_test {

inline constexpr AlarmKind kStartWithArc{"T", "start-arc", "", "", "", Severity::alarm};
inline constexpr AlarmKind kEndWithArc{"T", "end-arc", "", "", "", Severity::alarm};
inline constexpr AlarmKind kInnerArcRadius{"T", "inner-radius", "", "", "", Severity::alarm};
inline constexpr AlarmKind kNoCrossover{"T", "no-crossover", "", "", "", Severity::alarm};
inline constexpr AlarmKind kSideChange{"T", "side-change", "", "", "", Severity::alarm};
inline constexpr AlarmKind kCornerArcOutside{"T", "corner-arc-outside", "", "", "", Severity::alarm};

inline RadiusCompensationPolicy compensation_policy(StartType type = StartType::A) {
  RadiusCompensationPolicy policy;
  policy.start_type = type;
  policy.start_with_arc = &kStartWithArc;
  policy.end_with_arc = &kEndWithArc;
  policy.inner_arc_radius = &kInnerArcRadius;
  policy.no_crossover = &kNoCrossover;
  policy.side_change = &kSideChange;
  policy.corner_arc_outside = &kCornerArcOutside;
  return policy;
}

inline std::vector<Action> compensated(const std::vector<Action>& actions, StartType type = StartType::A) {
  RadiusCompensationPass pass(compensation_policy(type));
  return run_through(pass, actions);
}

inline std::string compensated_path(const Program& program, StartType type = StartType::A) {
  return text_of(compensated(program.actions(), type));
}

}  // namespace kerf::toolpath_test
