// Any bytes as a program: through reader, interpreter, toolpath passes and a bounded piece of the motion,
// under settings that the bytes themselves choose. Besides what the sanitizers see, the promises of the
// stages are checked: alarms lie inside the text, moves chain without gaps and stay finite, arcs end where
// they say.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "dialect/setup.hpp"
#include "execute/interpreter.hpp"
#include "execute/polar_plane.hpp"
#include "motion/run.hpp"
#include "toolpath/toolpath.hpp"

namespace {

using kerf::Action;
using kerf::Axis;
using kerf::Controller;
using kerf::Move;

constexpr int kMaxActions = 20'000;          // a cycle may repeat 9999 times
constexpr int kMaxAlarms = 500;              // an alarm a block
constexpr int kMaxMotionActions = 400;       // for the motion stages
constexpr std::uint64_t kMaxCycles = 5'000;  // of 100 ms
constexpr double kArcTolerance_mm = 0.02;

void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

/// The dialect that is fuzzed: KERF_FUZZ_DIALECT, set by fuzz/run.sh for each folder of seeds.
std::string fuzzed_dialect() {
  const char* name = std::getenv("KERF_FUZZ_DIALECT");
  return name == nullptr ? "dgshape" : name;
}

Controller controller(std::vector<std::string> assignments) {
  kerf::SetupOptions options;
  options.dialect = fuzzed_dialect();
  options.assignments = std::move(assignments);
  options.assignments.insert(options.assignments.end(),
                             {"machine.cycle_ms=100", "tools.1.radius=2", "tools.1.length=5"});
  auto made = kerf::make_controller(options);
  if (!made) {
    for (const auto& error : made.error()) std::fprintf(stderr, "%s\n", error.message.c_str());
    std::abort();
  }
  return std::move(*made);
}

std::vector<Controller> dgshape_controllers() {
  std::vector<Controller> made;
  made.push_back(controller({}));
  made.push_back(
      controller({"dgshape.decimal_point=all", "dgshape.offset_type=b", "dgshape.block_skip=true"}));
  made.push_back(
      controller({"dgshape.decimal_point=ijkrxyza", "dgshape.over_travel=clip", "dgshape.strict=true",
                  "axes.X.limits=[-50,200]", "axes.Z.limits=[-20,30]", "offsets.G54.X=10"}));
  made.push_back(controller({"dgshape.rotary_unit=false", "dgshape.tool_changer=false",
                             "dgshape.air_blower=false", "dgshape.spindle_interlock=true",
                             "dgshape.no_feed=minimum", "dgshape.optional_stop=true"}));
  made.push_back(
      controller({"dgshape.decimal_point=f", "dgshape.cycle_spindle_stop=true",
                  "dgshape.cycle_no_peck=single", "dgshape.rapid_axes=2", "dgshape.rapid_axes_over=split",
                  "dgshape.g10_volatile=true", "dgshape.shift_volatile=true", "dgshape.arc_tolerance=0"}));
  return made;
}

std::vector<Controller> melsec_controllers() {
  std::vector<Controller> made;
  made.push_back(
      controller({"melsec.system.common_system_points=400", "melsec.system.common_system_start_device=D2000",
                  "melsec.system.local_start_device=D7000", "melsec.system.initial_absolute_mode=G90"}));
  made.push_back(controller({"melsec.system.common_all_points=3",
                             "melsec.system.common_all_start_device=D6000", "melsec.system.base_axis_k=none",
                             "melsec.keep_arguments=true", "axes.X.limits=[-50,200]", "offsets.G54.X=10"}));
  made.push_back(
      controller({"melsec.system.initial_absolute_mode=G90", "melsec.work.interference_check=avoid",
                  "melsec.system.polar_linear_axis=X", "melsec.system.polar_rotary_axis=C", "axes.X.start=20",
                  "tools.2.radius=-0.5", "tools.3.radius=10"}));
  made.push_back(
      controller({"melsec.system.initial_absolute_mode=G90", "melsec.work.tool_radius_compensation_type=B",
                  "melsec.work.interference_check=invalid", "melsec.work.radius_or_diameter=diameter",
                  "melsec.system.polar_linear_axis=Y", "melsec.system.polar_rotary_axis=C", "axes.Y.start=-8",
                  "melsec.system.corner_override=50", "melsec.system.corner_override_max_angle=120",
                  "melsec.system.corner_override_length=2", "tools.2.radius=0.01", "tools.3.radius=100"}));
  made.push_back(
      controller({"melsec.system.initial_absolute_mode=G90", "melsec.work.interference_check=avoid",
                  "melsec.system.normal_line_axis=C", "melsec.system.normal_line_insert_radius=1",
                  "tools.2.radius=0.5", "tools.3.radius=10"}));
  made.push_back(controller({"melsec.system.normal_line_axis=C", "melsec.system.normal_line_type=II",
                             "melsec.system.normal_line_radius=1", "melsec.system.normal_line_min_angle=3",
                             "melsec.axis.C.rotation_axis_type=3", "tools.2.radius=0.5"}));
  return made;
}

std::vector<Controller> omron_controllers() {
  std::vector<Controller> made;
  made.push_back(
      controller({"omron.tool=1", "omron.axis.X.skip_input=position", "omron.axis.X.skip_position=5",
                  "omron.axis.Z.skip_input=X", "omron.axis.Y.skip_input=time", "omron.axis.Y.skip_time=0.3",
                  "omron.extended_1.maximum_feedrate=50", "omron.extended_1.axis.X.rapid=100"}));
  made.push_back(
      controller({"omron.cnc_version=1.01", "omron.command_unit=inch", "omron.all_block_skips=true",
                  "omron.optional_stop=true", "axes.X.limits=[-50,200]", "offsets.G54.X=10"}));
  made.push_back(controller({"omron.tool=2", "omron.overcut_operation_mode=prevention", "tools.2.radius=0.5",
                             "tools.3.radius=10", "omron.compensated_feed=edge"}));
  made.push_back(controller(
      {"omron.block_skip=1 3-5", "omron.immediate_m_codes=0-191", "omron.tool=1", "axes.Z.start=20"}));
  return made;
}

std::vector<Controller> controllers() {
  if (fuzzed_dialect() == "melsec") return melsec_controllers();
  return fuzzed_dialect() == "omron" ? omron_controllers() : dgshape_controllers();
}

const Controller& controller_for(std::string_view text) {
  static const std::vector<Controller> kControllers = controllers();
  std::uint32_t hash = 2166136261U;  // FNV-1a
  for (char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return kControllers[hash % kControllers.size()];
}

/// The program may call itself under three numbers of each dialect.
kerf::InterpreterOptions options_of(const Controller& controller,
                                    const std::shared_ptr<const kerf::Source>& source) {
  kerf::InterpreterOptions options = controller.interpreter_options;
  options.most_rounds = 5'000;
  options.programs = [source](std::int32_t number) {
    const bool known = number <= 3 || (number >= 1000 && number <= 1002);
    return known ? kerf::ProgramText{source} : kerf::ProgramText{};
  };
  return options;
}

bool is_finite(const kerf::AxisVector& position) {
  for (double value : position.values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

void check_arc(const Move& move) {
  const auto distance = [&](const kerf::AxisVector& point) {
    return std::hypot(point[move.plane.first] - move.arc.center[0],
                      point[move.plane.second] - move.arc.center[1]);
  };
  require(move.arc.radius > 0.0 && std::isfinite(move.arc.sweep), "an arc has a radius and a sweep");
  require((move.arc.sweep > 0.0) == (move.mode == kerf::MoveMode::counterclockwise), "the sign of a sweep");
  const double rounding = move.arc.radius * 1e-9;
  require(std::abs(distance(move.start) - move.arc.radius) <= kArcTolerance_mm + rounding, "an arc's start");
  // Spirals: of a dialect that has them, and between compensation vectors of different lengths.
  static const bool kHasSpirals = fuzzed_dialect() == "omron";
  const bool between_vectors = move.compensation.side != kerf::Side::none && !move.rounds_corner;
  const double out_of_round = std::abs(distance(move.end) - move.arc.radius);
  require(kHasSpirals || between_vectors || out_of_round <= kArcTolerance_mm + rounding, "an arc's end");
}

/// What must hold of every action, in the order they come.
class Promises {
 public:
  explicit Promises(std::string_view text) : text_(text) {}

  /// Behind an alarm the path goes on from where the refused block was to end.
  void recovered() { has_position_ = false; }

  void check(const Action& action) {
    if (const auto* alarm = std::get_if<kerf::Alarm>(&action.what)) check_alarm(*alarm);
    if (const auto* move = std::get_if<Move>(&action.what)) check_move(*move);
  }

 private:
  void check_alarm(const kerf::Alarm& alarm) const {
    require(alarm.kind != nullptr, "an alarm has a kind");
    require(alarm.span.offset <= text_.size(), "an alarm lies inside the text");
    // A fault at the very end may point at the line feed that Source keeps behind the text.
    require(alarm.span.length <= text_.size() + 1 - alarm.span.offset,
            "an alarm's span ends inside the text");
    require(!kerf::message_of(alarm).empty() && !kerf::remedy_of(alarm).empty(),
            "an alarm says why and what to do");
  }
  void check_move(const Move& move) {
    require(is_finite(move.start) && is_finite(move.end) && is_finite(move.commanded),
            "positions are finite");
    require(std::isfinite(move.feed), "feeds are finite");
    require(!has_position_ || move.start == position_, "a move starts where the one before it ended");
    position_ = move.end;
    has_position_ = true;
    if (!kerf::is_arc(move.mode)) return;
    check_arc(move.polar.form == kerf::PolarForm::axes ? kerf::in_polar_plane(move) : move);
  }

  std::string_view text_;
  bool has_position_ = false;
  kerf::AxisVector position_;
};

void walk_path(const Controller& controller, const std::shared_ptr<const kerf::Source>& source) {
  kerf::Interpreter interpreter(controller.rules, source, options_of(controller, source));
  const auto path = std::make_unique<kerf::Toolpath<kerf::Interpreter>>(interpreter, controller.machine,
                                                                        controller.toolpath_policy);
  Promises promises(source->text());
  int alarms = 0;
  for (int i = 0; i < kMaxActions && alarms < kMaxAlarms; ++i) {
    const Action* action = path->next();
    if (action == nullptr) return;
    promises.check(*action);
    if (std::holds_alternative<kerf::Alarm>(action->what)) {
      ++alarms;
      path->recover();
      promises.recovered();
    }
  }
}

void run_motion(const Controller& controller, const std::shared_ptr<const kerf::Source>& source) {
  kerf::Interpreter interpreter(controller.rules, source, options_of(controller, source));
  const auto path = std::make_unique<kerf::Toolpath<kerf::Interpreter>>(interpreter, controller.machine,
                                                                        controller.toolpath_policy);
  int actions = 0;
  const auto next = [&]() -> const Action* { return actions++ < kMaxMotionActions ? path->next() : nullptr; };
  kerf::RunOptions options;
  options.record = true;
  options.progress_cycles = 1'000;
  options.on_progress = [](const kerf::RunProgress& progress) { return progress.cycles < kMaxCycles; };
  options.on_cycle = [](const kerf::Cycle& cycle, const kerf::AxisVector& actual) {
    require(is_finite(cycle.position) && is_finite(cycle.velocity) && is_finite(actual), "cycles are finite");
  };
  const kerf::RunRecord record = kerf::run(next, controller.machine, controller.feed_policy, options);
  require(std::isfinite(record.summary.time_s) && record.summary.time_s >= 0.0, "the time of a run");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Controller& controller = controller_for(text);
  const auto source = kerf::Source::from_text("fuzz.nc", text);
  walk_path(controller, source);
  run_motion(controller, source);
  return 0;
}
