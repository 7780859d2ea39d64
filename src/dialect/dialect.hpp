#pragma once
// A dialect as the rest of kerf sees it: tables of data and a few functions. A new dialect is a folder that
// fills in one of these and one line in registry.cpp.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/alarm.hpp"
#include "execute/block_rules.hpp"
#include "execute/code_table.hpp"
#include "execute/feed_policy.hpp"
#include "execute/toolpath_policy.hpp"
#include "machine/machine.hpp"
#include "machine/settings.hpp"
#include "machine/settings_error.hpp"

namespace kerf {

/// Another form into which programs of a dialect can be brought.
struct Conversion {
  std::string_view name;   ///< as in `kerf convert --to`
  std::string_view title;  ///< for people
  /// The program in that form; empty when it cannot be made, and `faults` says why. `number` of the program;
  /// -1: the one that its file's name says.
  std::string (*convert)(const Source& source, std::int32_t number, std::vector<Alarm>& faults) = nullptr;
};

struct Dialect {
  std::string_view name;            ///< as in `--dialect` and the machine file
  std::string_view title;           ///< the controller's name
  std::string_view file_extension;  ///< of its programs, with the dot; empty: any
  std::span<const AlarmKind> alarms;
  std::span<const CodeRow> codes;
  std::span<const Parameter> parameters;         ///< its own machine-file keys
  std::span<const Parameter> shared;             ///< shared keys as it knows them: ranges, headings
  std::span<const std::string_view> not_shared;  ///< shared keys that mean nothing to it
  std::int32_t highest_tool = kHighestToolNumber;
  std::span<const DefaultOverride> defaults;  ///< its default machine
  std::string_view optional_stop_key;    ///< machine-file key that `--optional-stop` switches on; empty: none
  std::string_view block_skip_key;       ///< machine-file key that `--block-skip` switches on; empty: none
  std::string_view block_skip_list_key;  ///< that lists the numbers of `--block-skip=N`; empty: none

  std::span<const KeyAlarm> key_alarms;      ///< its alarms for bad values of single keys
  std::span<const SharedName> shared_names;  ///< its manual's names of shared keys

  std::string_view store_names;  ///< how files of its store are called, for people; empty: as one likes
  bool (*is_stored)(std::string_view file_name) = nullptr;  ///< given with store_names
  std::uint64_t store_bytes = 0;                            ///< of all its programs in one store; 0: no limit
  const AlarmKind* store_over = nullptr;                    ///< they are larger; must be given with a limit

  /// Names that the file of a further program may have, by its number, the first one that exists counts;
  /// null: it has no further programs.
  std::vector<std::string> (*file_names)(std::int32_t number) = nullptr;
  /// The number of a variable (MacroVariables) by the name that programs give it; null: it has none.
  std::optional<std::int64_t> (*variable_number)(std::string_view name) = nullptr;
  std::span<const Conversion> conversions;
  /// Whether a text is a program of it, judged by how it begins; null: any may be.
  bool (*recognises)(std::string_view text) = nullptr;

  /// Sets the defaults that follow from other settings, once these are all known; null: there are none.
  void (*complete)(Settings&) = nullptr;
  /// Whether a program is meant to be called by others and not to run by itself; null: none is.
  bool (*is_subprogram)(const std::shared_ptr<const Source>&) = nullptr;
  /// Puts into the machine what keys of its own say of it; null: none do.
  void (*complete_machine)(const Settings&, Machine&) = nullptr;
  /// What is wrong with the text of a program whether a block is reached or not, as far as it shows without
  /// executing it; given with is_subprogram.
  std::vector<Alarm> (*read_through)(const std::shared_ptr<const Source>&, const Machine&) = nullptr;
  /// Settings of its own that do not go together; null: all do.
  std::vector<SettingsError> (*contradictions)(const Settings&) = nullptr;
  std::shared_ptr<const BlockRules> (*rules)(const Settings&, const Machine&) = nullptr;
  FeedPolicy (*feed_policy)(const Settings&) = nullptr;
  ToolpathPolicy (*toolpath_policy)(const Settings&) = nullptr;
};

/// All dialects, in the order of the documentation.
std::span<const Dialect> dialects();

/// The dialect of that name, or null.
const Dialect* find_dialect(std::string_view name);

/// The dialect a program is written in, judged by the extension of its name in any case; without one that
/// tells, by how its text begins.
const Dialect& detect_dialect(std::string_view file_name, std::string_view text);

/// Every machine-file key of a dialect.
Schema schema_of(const Dialect& dialect);

}  // namespace kerf
