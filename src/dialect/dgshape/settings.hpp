#pragma once
// The [dgshape] section of the machine file: what the manual calls settings made on the modeling machine.

#include <array>
#include <cstdint>
#include <span>

#include "execute/modal.hpp"
#include "machine/parameter.hpp"
#include "machine/settings.hpp"

namespace kerf::dgshape {

/// Which words without a decimal point are read as calculator type (manual 1-5).
enum class CalculatorWords : std::uint8_t { none, all, feed, dimension };

struct ControllerSettings {
  CalculatorWords calculator_words = CalculatorWords::none;
  bool offset_type_b = false;
  bool optional_stop = false;
  bool block_skip = false;
  double feed_override = 100.0;     ///< percent
  double rapid_override = 100.0;    ///< percent
  double spindle_override = 100.0;  ///< percent
  double feed_min = 0.1;            ///< mm/min
  double feed_max = 30000.0;        ///< mm/min
  double feed_resolution = 0.0;     ///< mm/min; 0: none
  double spindle_min = 1.0;         ///< rpm
  double spindle_max = 90000.0;     ///< rpm
  double spindle_resolution = 0.0;  ///< rpm; 0: none
  double spindle_default = 0.0;     ///< rpm, register before any S
  double spindle_delay_s = 0.0;
  double angle_unit = 0.001;  ///< degrees
  bool rotary_unit = true;
  bool tool_changer = true;
  bool air_blower = true;
  bool chip_cleaner = true;
  bool light = true;
  std::int64_t offset_numbers = 32;
  std::int64_t length_numbers = 32;
  std::int64_t stockers = 10;
  double max_offset = 1000.0;   ///< mm
  double arc_tolerance = 0.01;  ///< mm
  bool minimum_feed_without_f = false;
  std::int64_t rapid_axes = 4;
  bool split_rapid = false;
  bool clip_over_travel = false;
  bool cycle_spindle_stop = false;
  bool single_stroke_without_q = false;
  bool empty_dwell_alarm = false;
  bool spindle_interlock = false;
  bool strict = false;
  bool g10_volatile = false;
  bool shift_volatile = false;
  double tool_change_s = 0.0;
  bool tool_change_retract = true;
  CodeNumber initial_motion = code(0);
  CodeNumber initial_plane = code(17);
  CodeNumber initial_unit = code(21);
  CodeNumber initial_distance = code(90);
  CodeNumber initial_return = code(98);
  CodeNumber initial_system = code(54);
};

std::span<const Parameter> parameters();
std::span<const DefaultOverride> default_machine();

ControllerSettings controller_settings(const Settings& settings);

}  // namespace kerf::dgshape
