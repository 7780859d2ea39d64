#include "conformance/runner/facts.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fmt/format.h>

#include "conformance/runner/event_match.hpp"
#include "conformance/runner/planned_run.hpp"
#include "conformance/runner/text.hpp"

namespace kerf::conformance {
namespace {

/// The bits of Registers::outputs by the M code that switches the function on.
constexpr std::array<int, 3> kOutputCodes{12, 14, 16};

void add_axes(Entry& found, AxisSet axes, const AxisVector& position) {
  for (const Axis axis : axes) found.fields.push_back({std::string(1, letter(axis)), position[axis]});
}

void add_table(Entry& found, const std::vector<double>& table) {
  for (std::size_t i = 0; i < table.size(); ++i) found.fields.push_back({std::to_string(i), table[i]});
}

std::string code_name(CodeNumber number) {
  const int tenth = number % 10;
  return tenth == 0 ? fmt::format("G{:02}", number / 10) : fmt::format("G{}.{}", number / 10, tenth);
}

std::size_t offset_index(std::string_view name) {
  return name == "EXT" ? 0 : static_cast<std::size_t>(std::atoi(name.substr(1).data()) - 53);
}

/// Looks up what the controller really has for a fact.
class Inspector {
 public:
  Inspector(const Case& test, const Controller& controller, const ProgramRun& run)
      : test_(test), controller_(controller), run_(run) {}

  /// The times of all `at` facts, for one planned run.
  void prepare(const std::vector<Entry>& facts) {
    std::vector<double> times_s;
    bool timed = false;
    for (const Entry& fact : facts) {
      if (fact.name == "at") times_s.push_back(std::get<double>(fact.find("t")->value));
      timed = timed || fact.name == "at" || fact.name == "time" || fact.name == "motion_time";
    }
    if (timed) planned_ = plan(run_.actions, controller_, test_.changes, times_s);
  }

  /// An entry of the fact's form with all values that could be asked for.
  Entry found(const Entry& fact) {
    Entry found;
    found.name = fact.name;
    if (fact.name == "at")
      add_position_at(fact, found);
    else if (fact.name == "spindle")
      add_spindle(found);
    else if (fact.name == "output")
      add_outputs(found);
    else if (fact.name == "offset")
      add_offset(fact, found);
    else if (fact.name == "modal")
      add_modal(found);
    else if (fact.name == "#" || fact.name == "var")
      add_variables(fact, found);
    else if (!add_position(found) && !add_tables(found))
      add_number(found);
    return found;
  }

 private:
  const Registers& registers() const { return run_.state.registers; }
  AxisSet axes() const { return controller_.machine.axes; }

  bool add_position(Entry& found) const {
    if (found.name == "W")
      add_axes(found, axes(), run_.work_position);
    else if (found.name == "M")
      add_axes(found, axes(), controller_.rules->shown(run_.position));
    else if (found.name == "shift")
      add_axes(found, axes(), registers().shift);
    else
      return false;
    return true;
  }

  bool add_tables(Entry& found) const {
    if (found.name == "radius")
      add_table(found, run_.state.tables.radius);
    else if (found.name == "length")
      add_table(found, run_.state.tables.length);
    else
      return false;
    return true;
  }

  void add_number(Entry& found) const {
    const auto add = [&](std::string_view key, double value) {
      found.fields.push_back({std::string(key), value});
    };
    if (found.name == "feed") add("feed", registers().feed);
    if (found.name == "register") add("rpm", registers().spindle_rpm);
    if (found.name == "tool") add("tool", registers().tool);
    if (found.name == "program") add("program", registers().program);
    if (found.name == "n") add("n", registers().sequence_number);
    if (found.name == "ramps") {
      add("ta", registers().ramps.acceleration);
      add("td", registers().ramps.deceleration);
      add("ts", registers().ramps.jerk);
    }
    if (found.name == "time") add("time", planned_.time_s);
    if (found.name == "motion_time") add("motion_time", planned_.motion_s);
  }

  void add_position_at(const Entry& fact, Entry& found) {
    found.fields.push_back(*fact.find("t"));
    const auto& position = planned_.positions[next_time_++];
    if (position) add_axes(found, axes(), *position - run_.work_origin);
  }

  void add_spindle(Entry& found) const {
    found.words.emplace_back(registers().spindle_on ? "on" : "off");
    if (registers().spindle_on) found.fields.push_back({"rpm", run_.spindle.rpm});
  }

  void add_outputs(Entry& found) const {
    for (std::size_t i = 0; i < kOutputCodes.size(); ++i) {
      const bool on = (registers().outputs >> i & 1U) != 0;
      found.fields.push_back({std::to_string(kOutputCodes[i]), std::string(on ? "on" : "off")});
    }
  }

  void add_offset(const Entry& fact, Entry& found) const {
    found.words = fact.words;
    add_axes(found, axes(), run_.state.tables.work_offsets[offset_index(fact.words.front())]);
  }

  void add_variables(const Entry& fact, Entry& found) const {
    for (const Field& field : fact.fields) {
      const auto number = fact.name == "var" ? controller_.dialect->variable_number(field.key)
                                             : std::optional<std::int64_t>(std::atoi(field.key.c_str()));
      if (!number) continue;
      const double* value = run_.state.variables.find(static_cast<double>(*number));
      if (value != nullptr) found.fields.push_back({field.key, *value});
    }
  }

  void add_modal(Entry& found) const {
    for (std::size_t group = 0; group < kGroupCount; ++group) {
      const CodeNumber number = registers().modal[static_cast<Group>(group)];
      if (static_cast<Group>(group) == Group::one_shot || number == kNoCode) continue;
      found.words.push_back(code_name(number));
    }
  }

  const Case& test_;
  const Controller& controller_;
  const ProgramRun& run_;
  PlannedRun planned_;
  std::size_t next_time_ = 0;
};

/// Of the found values those that the fact names.
Entry asked_for(const Entry& fact, Entry found) {
  const auto surplus = [&](const Field& field) { return fact.find(field.key) == nullptr; };
  found.fields.erase(std::remove_if(found.fields.begin(), found.fields.end(), surplus), found.fields.end());
  return found;
}

bool holds(const Entry& fact, const Entry& found, double tolerance) {
  if (fact.name != "modal") return fits(fact, found, tolerance);
  return std::all_of(fact.words.begin(), fact.words.end(), [&](const std::string& code) {
    return std::find(found.words.begin(), found.words.end(), code) != found.words.end();
  });
}

}  // namespace

std::string fact_differences(const Case& test, const ProgramSection& section, const Controller& controller,
                             const ProgramRun& run, const ProgramRun* before) {
  Inspector inspector(test, controller, run);
  inspector.prepare(section.facts);
  std::string text;
  for (const Entry& fact : section.facts) {
    if (fact.name == "same") {
      text += event_difference(without_place(watched_events(before->events, test.watched)),
                               without_place(watched_events(run.events, test.watched)), test.tolerance);
      continue;
    }
    const Entry found = inspector.found(fact);
    if (holds(fact, found, test.tolerance)) continue;
    text += fmt::format("- {}\n+ {}\n", entry_text(fact), entry_text(asked_for(fact, found)));
  }
  return text;
}

}  // namespace kerf::conformance
