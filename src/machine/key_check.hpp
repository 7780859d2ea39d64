#pragma once
// Why a written key cannot be used on this machine: shared by machine files and `--set` options.

#include <cstddef>
#include <optional>
#include <string>

#include "machine/settings.hpp"

namespace kerf {

/// The complaint about a path whose segment `fault` (from 0) was not found, with the nearest key.
Complaint unknown_key(const Settings& settings, const KeyPath& path, std::size_t fault, const KeyStep& step);

/// The complaint about a key of an axis that the machine lacks, e.g. offsets.G54.B. `path` ends with the
/// axis; `remedy` says how the axis is added.
Complaint missing_axis(const Settings& settings, const KeyPath& path, std::string_view remedy);

/// The complaint about a section that is given a value, or a key that is given a table.
Complaint section_not_value(const KeyPath& path);

/// The complaint about a `dialect` that is neither the schema's own (its default) nor one with a foreign
/// section; none when it is fine or the schema names no dialect.
std::optional<Complaint> unknown_dialect(const Settings& settings, const std::string& name);

}  // namespace kerf
