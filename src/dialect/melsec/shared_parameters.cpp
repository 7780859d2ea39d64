// The keys of the machine file that all dialects share, as the manual's chapter 4 knows them: 4.2 axis
// parameters, 4.3 work parameters.

#include "dialect/melsec/settings.hpp"

namespace kerf::melsec {
namespace {

constexpr std::string_view kLineAxes = "Line axis information";
constexpr std::string_view kLimits = "Stored stroke limit";
constexpr std::string_view kSpeeds = "Speed/time constant";
constexpr std::string_view kOffsets = "Workpiece coordinate offset";
constexpr std::string_view kTools = "Tool compensation data";

constexpr double kLongest = 9999.9999;    // mm or degrees, eight digits of the least increment
constexpr double kFastest = 1'000'000.0;  // mm/min or degrees/min

constexpr Parameter length(std::string_view group, std::string_view key, std::string_view help) {
  return {.key = key,
          .type = ValueType::number,
          .default_value = "0.0",
          .unit = "mm",
          .minimum = -kLongest,
          .maximum = kLongest,
          .help = help,
          .group = group};
}

constexpr Parameter speed(std::string_view key, std::string_view help) {
  return {.key = key,
          .type = ValueType::number,
          .default_value = "2000.0",
          .unit = "mm/min",
          .minimum = 1.0,
          .maximum = kFastest,
          .help = help,
          .group = kSpeeds};
}

constexpr Parameter kShared[] = {
    {.key = "axes.*.number",
     .type = ValueType::integer,
     .default_value = "1",
     .minimum = 1,
     .maximum = 64,
     .help = "Servo axis number; left out, the lowest number that no other axis has.",
     .group = kLineAxes},
    {.key = "axes.*.type",
     .type = ValueType::word,
     .default_value = "\"linear\"",
     .choices = "linear|rotary",
     .help = "Whether the axis moves in mm or turns in degrees.",
     .group = kLineAxes},
    {.key = "axes.*.limits",
     .type = ValueType::number_pair,
     .default_value = "[-9999.9999, 9999.9999]",
     .unit = "mm",
     .minimum = -kLongest,
     .maximum = kLongest,
     .help = "Software limits, machine coordinates; equal ones for a rotary axis that turns without end.",
     .group = kLimits},
    speed("axes.*.rapid", "Fast forward speed: that of G00."),
    speed("axes.*.max_feed", "Cutting feed clamp speed: the highest speed of the axis while cutting."),
    length(kOffsets, "offsets.G54.*", "Work coordinate system 1: its origin in machine coordinates."),
    length(kOffsets, "offsets.G55.*", "Work coordinate system 2."),
    length(kOffsets, "offsets.G56.*", "Work coordinate system 3."),
    length(kOffsets, "offsets.G57.*", "Work coordinate system 4."),
    length(kOffsets, "offsets.G58.*", "Work coordinate system 5."),
    length(kOffsets, "offsets.G59.*", "Work coordinate system 6."),
    length(kTools, "tools.*.radius", "Tool radius compensation amount."),
    length(kTools, "tools.*.length", "Tool length compensation amount."),
};

constexpr std::string_view kNotShared[] = {"offsets.EXT.*"};

}  // namespace

std::span<const Parameter> shared_parameters() {
  return kShared;
}

std::span<const std::string_view> keys_not_shared() {
  return kNotShared;
}

}  // namespace kerf::melsec
