#pragma once
// Machine files as text: a commented one to begin with, and the effective values.

#include <string>
#include <string_view>

#include "machine/settings.hpp"

namespace kerf {

/// A complete machine file with the defaults of the schema: every key with its meaning, unit, range or
/// choices and default in a comment above it (for tables of the same kind, above the first). apply_toml()
/// reads it back to the same settings. `dialect_name` becomes the value of `dialect`.
std::string init_text(const Schema& schema, std::string_view dialect_name);

/// The effective values, table by table, as TOML: `rapid = 8000.0  # mm/min, mill.toml:7`. In place of the
/// file stands `default` or `--set`.
std::string show_text(const Settings& settings);

}  // namespace kerf
