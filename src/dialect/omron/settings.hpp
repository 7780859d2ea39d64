#pragma once
// The [omron] section of the machine file: settings of the CNC coordinate system and its motors.

#include <array>
#include <bitset>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/axis.hpp"
#include "execute/action.hpp"
#include "execute/skip_input.hpp"
#include "execute/state.hpp"
#include "machine/machine.hpp"
#include "machine/parameter.hpp"
#include "machine/settings.hpp"

namespace kerf::omron {

inline constexpr std::size_t kMCodes = 192;
inline constexpr std::size_t kReferencePoints = 3;  ///< the 2nd to the 4th

inline constexpr std::size_t kExtendedSets = 3;  ///< parameter sets 0, 1 and 2 of G500 and G501

/// AxisSettings::other_rates: the skip velocity of the motors (G31), and from kExtendedRates on what the
/// extended sets have.
inline constexpr RateSet kSkipRates = 1;
inline constexpr RateSet kExtendedRates = 2;

/// What a parameter set of G500 and G501 changes besides the rates of the axes.
struct OperationSettings {
  double maximum_feedrate = 0.0;  ///< in the unit in force a minute
  double rotary_velocity = 0.0;   ///< degree/min
  RampTimes ramps;                ///< until the program says otherwise
};

struct ControllerSettings {
  bool version_1_02 = true;  ///< CNC version 1.02 or higher, else 1.01 or lower
  bool inch = false;         ///< command unit of the orthogonal axes at the start
  OperationSettings normal;  ///< parameter set 99
  std::array<OperationSettings, kExtendedSets> extended;
  double spindle_maximum = 0.0;       ///< r/min
  double orientation_velocity = 0.0;  ///< r/min
  double orientation_angle = 0.0;     ///< degrees
  std::int32_t tool_m_code = -1;      ///< whose argument VA is the tool that is selected; -1: none
  std::int32_t tool = 0;              ///< selected at the start; 0: none
  bool has_spindle_axis = true;
  bool optional_stop = false;
  std::bitset<32> skips;  ///< optional skip signals that are on, by number
  std::array<OutputTiming, kMCodes> timing{};
  std::array<AxisVector, kReferencePoints> references;

  /// Of the parameter set in force (Registers::rates).
  const OperationSettings& operation(RateSet rates) const {
    return rates < kExtendedRates ? normal : extended[rates - kExtendedRates];
  }

  SkipInputs skip_inputs;
};

std::span<const Parameter> parameters();
/// The key with the number of an extended set in place of its `#`.
std::string extended_key(std::string_view key, std::size_t set);
std::span<const std::string_view> keys_not_shared();
std::span<const DefaultOverride> default_machine();
ControllerSettings controller_settings(const Settings& settings, const Machine& machine);

/// The numbers of a list such as "1 5 20-25", separated by blanks or commas; nothing when it is none or one
/// of them is not from `least` to `greatest`.
std::optional<std::vector<int>> numbers_in(std::string_view list, int least, int greatest);

}  // namespace kerf::omron
