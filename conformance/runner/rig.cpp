#include "conformance/runner/rig.hpp"

#include <unordered_map>

#include "conformance/runner/observation.hpp"
#include "machine/schema.hpp"

namespace kerf::conformance {
namespace {

/// Moves take distance over feed.
constexpr std::string_view kIdealSettings[] = {"axes.*.acceleration=1e9", "axes.*.jerk=1e15"};
constexpr std::uint32_t kMostRounds = 4'000'000;  // an endless loop is found out without waiting for it

Entry refusal(const SettingsError& error) {
  Entry event;
  event.name = "refused";
  if (!error.alarm.empty()) {
    event.words.push_back(error.alarm);
    return event;
  }
  constexpr std::string_view kOption = "--set ";
  if (error.file.compare(0, kOption.size(), kOption) == 0) {
    const std::string assignment = error.file.substr(kOption.size());
    event.words.push_back(assignment.substr(0, assignment.find('=')));
  }
  return event;
}

/// The interpreter in front of the toolpath passes. Remembers the workpiece origin of each block, because a
/// pass may hold a move back while the next blocks are executed already.
class Watched {
 public:
  explicit Watched(Interpreter& interpreter) : interpreter_(interpreter) {}

  const Action* next() {
    const Action* action = interpreter_.next();
    if (action != nullptr) {
      origins_[action->origin.block] = interpreter_.rules().work_origin(interpreter_.state());
    }
    return action;
  }
  void recover() { interpreter_.recover(); }
  const AxisVector& work_origin(std::uint32_t block) { return origins_[block]; }

 private:
  Interpreter& interpreter_;
  std::unordered_map<std::uint32_t, AxisVector> origins_;
};

}  // namespace

tl::expected<Rig, std::vector<Entry>> Rig::make(const Case& test, const std::string& dialect) {
  SetupOptions options;
  options.dialect = dialect;
  options.assignments = test.settings;
  options.optional_stop = test.optional_stop;
  options.block_skip = test.block_skip;
  auto controller = make_controller(options);
  if (!controller) {
    std::vector<Entry> events;
    for (const SettingsError& error : controller.error()) events.push_back(refusal(error));
    return tl::unexpected(std::move(events));
  }
  if (test.ideal) {
    for (const Axis axis : controller->machine.axes) {
      for (const std::string_view setting : kIdealSettings)
        options.assignments.push_back(expanded(setting, axis));
    }
    controller = make_controller(options);
  }
  return Rig(*std::move(controller), test.recover);
}

Rig::Rig(Controller controller, bool recover) : controller_(std::move(controller)), recover_(recover) {
  others_ = std::make_shared<std::map<std::int32_t, std::string>>();
  controller_.interpreter_options.programs = [others = others_](std::int32_t number) {
    const auto other = others->find(number);
    return other == others->end() ? ProgramText{} : ProgramText{Source::from_text("case", other->second)};
  };
  controller_.interpreter_options.most_rounds = kMostRounds;
  for (const Axis axis : controller_.machine.axes) position_[axis] = controller_.machine[axis].start;
}

ProgramRun Rig::run(const ProgramSection& program, const std::string& text) {
  *others_ = program.others;
  auto source = Source::from_text("case", text);
  if (interpreter_) {
    interpreter_->load(std::move(source), position_);
  } else {
    interpreter_ =
        std::make_unique<Interpreter>(controller_.rules, std::move(source), controller_.interpreter_options);
  }
  Watched watched(*interpreter_);
  const auto toolpath =
      std::make_unique<Toolpath<Watched>>(watched, controller_.machine, controller_.toolpath_policy);
  ProgramRun run;
  while (const Action* action = toolpath->next()) {
    run.actions.push_back(*action);
    const AxisVector& origin = watched.work_origin(action->origin.block);
    if (auto event = event_of(*action, {controller_.machine.axes, controller_.feed_policy, origin})) {
      run.events.push_back(*std::move(event));
    }
    if (const auto* move = std::get_if<Move>(&action->what)) position_ = move->end;
    if (const auto* spindle = std::get_if<Spindle>(&action->what)) spindle_ = *spindle;
    if (stops_program(*action) && recover_) toolpath->recover();
  }
  run.state = interpreter_->state();
  run.work_origin = controller_.rules->work_origin(run.state);
  run.work_position = controller_.rules->work_position(run.state);
  run.position = position_;
  run.spindle = spindle_;
  return run;
}

}  // namespace kerf::conformance
