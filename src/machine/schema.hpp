#pragma once
// The keys a machine file of one dialect may hold, and how a written key finds its declaration.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/alarm.hpp"
#include "base/axis.hpp"
#include "machine/parameter.hpp"

namespace kerf {

inline constexpr std::int32_t kHighestToolNumber = 9999;

/// By which alarm the controller knows a value that is out of range or does not go with others.
struct KeyAlarm {
  std::string_view key;  ///< as declared: axes.*.number
  const AlarmKind* kind = nullptr;
};

/// A name of the controller's manual whose value every dialect has under a shared key.
struct SharedName {
  std::string_view key;     ///< as users of the manual would write it: melsec.axis.*.rapid_speed
  std::string_view remedy;  ///< what to write instead: "set 'axes.*.rapid'"
};

/// The declarations in force for one dialect. The tables must outlive everything made from them: static
/// tables do.
struct Schema {
  std::span<const Parameter> common;          ///< common_parameters(), or as a dialect knows them
  std::span<const Parameter> dialect;         ///< the dialect's own keys: melsec.system.arc_deviation
  std::span<const DefaultOverride> defaults;  ///< the dialect's default machine
  /// Top-level sections of the other dialects. A file may hold them; they are passed over unread, so that one
  /// file can describe a machine for several dialects. Any other unknown section is an error.
  std::span<const std::string_view> foreign_sections;
  std::span<const KeyAlarm> alarms = {};
  std::span<const SharedName> shared_names = {};
  std::int32_t highest_tool = kHighestToolNumber;  ///< number of a tool or compensation
};

/// A key cut at its dots: {"axes", "X", "rapid"}.
using KeyPath = std::vector<std::string>;

/// What the `*` of a declared key stands for.
enum class Instance : std::uint8_t { none, axis, tool };

/// A path followed along the declarations, up to its last segment.
struct KeyStep {
  enum class Kind : std::uint8_t { parameter, section, unknown, not_an_axis, not_a_tool };
  Kind kind = Kind::unknown;
  const Parameter* parameter = nullptr;  ///< only for Kind::parameter
  Instance instance = Instance::none;    ///< what the last segment names
};

/// Looks the path up. All its shorter prefixes are expected to have been found to be sections.
KeyStep follow(const Schema& schema, const KeyPath& path);

/// One axis letter in upper case, as axis tables and offsets use them.
std::optional<Axis> axis_of(std::string_view segment);
/// 1 to kHighestToolNumber without leading zeros.
std::optional<std::int32_t> tool_of(std::string_view segment);

Instance instance_of(const Parameter& parameter);
/// The key with its `*` replaced: expanded("axes.*.rapid", "X") is "axes.X.rapid".
std::string expanded(std::string_view key, std::string_view instance);
std::string expanded(std::string_view key, Axis axis);

KeyPath split_key(std::string_view key);
/// The path as a TOML key; segments that are no bare keys are put in quotes.
std::string joined(const KeyPath& path);

/// The declarations of one TOML table, in order of declaration.
struct ParameterTable {
  std::string_view header;  ///< "" top level, "machine", "axes.*", "offsets", "tools.*"
  std::vector<const Parameter*> parameters;
};
/// All declarations, common ones first, by table in the order in which each table is first mentioned.
std::vector<ParameterTable> tables_of(const Schema& schema);

/// The last segment of the key within its table; for an offset the one before the axis: "rapid", "G54".
std::string_view name_in_table(const Parameter& parameter);

/// The default of an expanded key, as TOML text: an override of the dialect for this key or for its pattern,
/// the shared default (A, B and C are rotary), or the parameter's own.
std::string_view default_text(const Schema& schema, const Parameter& parameter, std::string_view key);

/// The alarm for bad values of a declared key, or null.
const AlarmKind* alarm_of(const Schema& schema, const Parameter& parameter);

/// Mistakes in the declarations themselves, for the tests of a dialect: a default that does not fit its own
/// declaration, a key declared twice, an override of an unknown key, a word without choices, a key without
/// help.
std::vector<std::string> schema_faults(const Schema& schema);

}  // namespace kerf
