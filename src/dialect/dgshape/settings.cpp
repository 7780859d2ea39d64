#include "dialect/dgshape/settings.hpp"

#include <limits>
#include <string>

#include "execute/code_table.hpp"

namespace kerf::dgshape {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr auto kBoolean = ValueType::boolean;
constexpr auto kInteger = ValueType::integer;
constexpr auto kNumber = ValueType::number;
constexpr auto kWord = ValueType::word;

constexpr Parameter kParameters[] = {
    {"dgshape.decimal_point", kWord, "\"none\"", "", -kNoLimit, kNoLimit, "none|all|f|ijkrxyza",
     "Words that are read as calculator type (whole units) when they have no decimal point."},
    {"dgshape.offset_type", kWord, "\"a\"", "", -kNoLimit, kNoLimit, "a|b",
     "Start and end of tool-diameter offset at outer corners: type A or B."},
    {"dgshape.optional_stop", kBoolean, "false", "", -kNoLimit, kNoLimit, "", "M01 stops the program."},
    {"dgshape.block_skip", kBoolean, "false", "", -kNoLimit, kNoLimit, "",
     "Blocks with a slash in front are left out."},
    {"dgshape.feed_override", kNumber, "100.0", "percent", 0.0, 1000.0, "", "Override of the feed rate."},
    {"dgshape.rapid_override", kNumber, "100.0", "percent", 1.0, 100.0, "", "Override of rapid feed."},
    {"dgshape.spindle_override", kNumber, "100.0", "percent", 0.0, 1000.0, "",
     "Override of the spindle speed."},
    {"dgshape.feed_min", kNumber, "0.1", "mm/min", 1e-6, 1e9, "",
     "Lowest feed rate; lower ones become this."},
    {"dgshape.feed_max", kNumber, "30000.0", "mm/min", 1e-6, 1e9, "",
     "Highest feed rate; higher ones become this."},
    {"dgshape.feed_resolution", kNumber, "0.0", "mm/min", 0.0, 1e6, "", "Step of the feed rate; 0 for none."},
    {"dgshape.spindle_min", kNumber, "1.0", "rpm", 0.0, 1e7, "", "Lowest spindle speed."},
    {"dgshape.spindle_max", kNumber, "90000.0", "rpm", 0.0, 1e7, "", "Highest spindle speed."},
    {"dgshape.spindle_resolution", kNumber, "0.0", "rpm", 0.0, 1e6, "",
     "Step of the spindle speed; 0 for none."},
    {"dgshape.spindle_default", kNumber, "0.0", "rpm", 0.0, 1e7, "", "Spindle speed before any S word."},
    {"dgshape.spindle_delay", kNumber, "0.0", "s", 0.0, 3600.0, "",
     "Time the program waits after a spindle start."},
    {"dgshape.angle_unit", kNumber, "0.001", "degree", 1e-6, 360.0, "",
     "Least movement of the A axis: the unit of A words without a decimal point."},
    {"dgshape.rotary_unit", kBoolean, "true", "", -kNoLimit, kNoLimit, "", "The machine has an A axis."},
    {"dgshape.tool_changer", kBoolean, "true", "", -kNoLimit, kNoLimit, "",
     "The machine has a tool changer (ATC)."},
    {"dgshape.air_blower", kBoolean, "true", "", -kNoLimit, kNoLimit, "", "The machine has an air blower."},
    {"dgshape.chip_cleaner", kBoolean, "true", "", -kNoLimit, kNoLimit, "",
     "The machine has a chip cleaner."},
    {"dgshape.light", kBoolean, "true", "", -kNoLimit, kNoLimit, "", "The machine has a light."},
    {"dgshape.offset_numbers", kInteger, "32", "", 0, 9999, "", "Highest tool-diameter offset number (D)."},
    {"dgshape.length_numbers", kInteger, "32", "", 0, 9999, "", "Highest tool-length offset number (H)."},
    {"dgshape.stockers", kInteger, "10", "", 0, 9999, "", "Highest stocker number (T)."},
    {"dgshape.max_offset", kNumber, "1000.0", "mm", 0.0, 1e6, "",
     "Largest tool-diameter offset; larger become this."},
    {"dgshape.arc_tolerance", kNumber, "0.01", "mm", 0.0, 100.0, "",
     "Allowed difference between the radius at the start and at the end of an arc."},
    {"dgshape.no_feed", kWord, "\"alarm\"", "", -kNoLimit, kNoLimit, "alarm|minimum",
     "What a cutting move does before any F word."},
    {"dgshape.rapid_axes", kInteger, "4", "", 1, 4, "", "Axes that may move together in G00 and G53."},
    {"dgshape.rapid_axes_over", kWord, "\"alarm\"", "", -kNoLimit, kNoLimit, "alarm|split",
     "What a rapid move of more axes does."},
    {"dgshape.over_travel", kWord, "\"alarm\"", "", -kNoLimit, kNoLimit, "alarm|clip",
     "What a move beyond the travel does: alarm before it, or stop at the border."},
    {"dgshape.cycle_spindle_stop", kBoolean, "false", "", -kNoLimit, kNoLimit, "",
     "G86 stops the spindle at the bottom of the hole."},
    {"dgshape.cycle_no_peck", kWord, "\"alarm\"", "", -kNoLimit, kNoLimit, "alarm|single",
     "What G83 without Q does: alarm, or drill in one stroke."},
    {"dgshape.empty_dwell", kWord, "\"zero\"", "", -kNoLimit, kNoLimit, "zero|alarm",
     "What G04 without a time does."},
    {"dgshape.spindle_interlock", kBoolean, "false", "", -kNoLimit, kNoLimit, "",
     "Cutting with the spindle stopped is an alarm instead of a warning."},
    {"dgshape.strict", kBoolean, "false", "", -kNoLimit, kNoLimit, "",
     "N0, O0, negative feeds and negative spindle speeds are alarms."},
    {"dgshape.g10_volatile", kBoolean, "false", "", -kNoLimit, kNoLimit, "",
     "Values set by G10 are forgotten at the end of the program."},
    {"dgshape.shift_volatile", kBoolean, "false", "", -kNoLimit, kNoLimit, "",
     "The G92 shift is forgotten at the end of the program."},
    {"dgshape.tool_change_time", kNumber, "0.0", "s", 0.0, 3600.0, "", "Time of a tool change."},
    {"dgshape.tool_change_retract", kBoolean, "true", "", -kNoLimit, kNoLimit, "",
     "Z rises to its reference point before a tool change."},
    {"dgshape.initial_motion", kWord, "\"G00\"", "", -kNoLimit, kNoLimit, "G00|G01",
     "Code in force at program start."},
    {"dgshape.initial_plane", kWord, "\"G17\"", "", -kNoLimit, kNoLimit, "G17|G18|G19",
     "Code in force at program start."},
    {"dgshape.initial_unit", kWord, "\"G21\"", "", -kNoLimit, kNoLimit, "G20|G21",
     "Code in force at program start."},
    {"dgshape.initial_distance", kWord, "\"G90\"", "", -kNoLimit, kNoLimit, "G90|G91",
     "Code in force at program start."},
    {"dgshape.initial_return", kWord, "\"G98\"", "", -kNoLimit, kNoLimit, "G98|G99",
     "Code in force at program start."},
    {"dgshape.initial_system", kWord, "\"G54\"", "", -kNoLimit, kNoLimit, "G54|G55|G56|G57|G58|G59",
     "Code in force at program start."},
};

constexpr DefaultOverride kDefaultMachine[] = {
    {"dialect", "\"dgshape\""},     {"machine.name", "\"DGSHAPE mill\""},
    {"axes.X.number", "1"},         {"axes.Y.number", "2"},
    {"axes.Z.number", "3"},         {"axes.A.number", "4"},
    {"axes.A.type", "\"rotary\""},  {"axes.A.rapid", "10000.0"},
    {"axes.A.max_feed", "10000.0"}, {"axes.A.acceleration", "1000.0"},
    {"axes.A.jerk", "10000.0"},
};

CalculatorWords calculator_words_of(const std::string& word) {
  if (word == "all") return CalculatorWords::all;
  if (word == "f") return CalculatorWords::feed;
  if (word == "ijkrxyza") return CalculatorWords::dimension;
  return CalculatorWords::none;
}

}  // namespace

std::span<const Parameter> parameters() {
  return kParameters;
}

std::span<const DefaultOverride> default_machine() {
  return kDefaultMachine;
}

ControllerSettings controller_settings(const Settings& s) {
  ControllerSettings c;
  c.calculator_words = calculator_words_of(s.text("dgshape.decimal_point"));
  c.offset_type_b = s.text("dgshape.offset_type") == "b";
  c.optional_stop = s.boolean("dgshape.optional_stop");
  c.block_skip = s.boolean("dgshape.block_skip");
  c.feed_override = s.number("dgshape.feed_override");
  c.rapid_override = s.number("dgshape.rapid_override");
  c.spindle_override = s.number("dgshape.spindle_override");
  c.feed_min = s.number("dgshape.feed_min");
  c.feed_max = s.number("dgshape.feed_max");
  c.feed_resolution = s.number("dgshape.feed_resolution");
  c.spindle_min = s.number("dgshape.spindle_min");
  c.spindle_max = s.number("dgshape.spindle_max");
  c.spindle_resolution = s.number("dgshape.spindle_resolution");
  c.spindle_default = s.number("dgshape.spindle_default");
  c.spindle_delay_s = s.number("dgshape.spindle_delay");
  c.angle_unit = s.number("dgshape.angle_unit");
  c.rotary_unit = s.boolean("dgshape.rotary_unit");
  c.tool_changer = s.boolean("dgshape.tool_changer");
  c.air_blower = s.boolean("dgshape.air_blower");
  c.chip_cleaner = s.boolean("dgshape.chip_cleaner");
  c.light = s.boolean("dgshape.light");
  c.offset_numbers = s.integer("dgshape.offset_numbers");
  c.length_numbers = s.integer("dgshape.length_numbers");
  c.stockers = s.integer("dgshape.stockers");
  c.max_offset = s.number("dgshape.max_offset");
  c.arc_tolerance = s.number("dgshape.arc_tolerance");
  c.minimum_feed_without_f = s.text("dgshape.no_feed") == "minimum";
  c.rapid_axes = s.integer("dgshape.rapid_axes");
  c.split_rapid = s.text("dgshape.rapid_axes_over") == "split";
  c.clip_over_travel = s.text("dgshape.over_travel") == "clip";
  c.cycle_spindle_stop = s.boolean("dgshape.cycle_spindle_stop");
  c.single_stroke_without_q = s.text("dgshape.cycle_no_peck") == "single";
  c.empty_dwell_alarm = s.text("dgshape.empty_dwell") == "alarm";
  c.spindle_interlock = s.boolean("dgshape.spindle_interlock");
  c.strict = s.boolean("dgshape.strict");
  c.g10_volatile = s.boolean("dgshape.g10_volatile");
  c.shift_volatile = s.boolean("dgshape.shift_volatile");
  c.tool_change_s = s.number("dgshape.tool_change_time");
  c.tool_change_retract = s.boolean("dgshape.tool_change_retract");
  c.initial_motion = code_named(s.text("dgshape.initial_motion"));
  c.initial_plane = code_named(s.text("dgshape.initial_plane"));
  c.initial_unit = code_named(s.text("dgshape.initial_unit"));
  c.initial_distance = code_named(s.text("dgshape.initial_distance"));
  c.initial_return = code_named(s.text("dgshape.initial_return"));
  c.initial_system = code_named(s.text("dgshape.initial_system"));
  return c;
}

}  // namespace kerf::dgshape
