#pragma once
// The effective values of all machine-file keys: the dialect's defaults, then a machine file, then `--set`
// options.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/axis.hpp"
#include "machine/schema.hpp"
#include "machine/value.hpp"

namespace kerf {

/// Where a value came from.
struct ValueOrigin {
  enum class Kind : std::uint8_t { preset, file, assignment };
  Kind kind = Kind::preset;  ///< preset: the default of the dialect or the key
  std::string file;          ///< only for Kind::file
  std::uint32_t line = 0;    ///< of the value, from 1
  std::uint32_t column = 0;
};

struct Setting {
  std::string key;  ///< without wildcard: axes.X.rapid
  const Parameter* parameter = nullptr;
  Value value;
  ValueOrigin origin;

  bool is_explicit() const { return origin.kind != ValueOrigin::Kind::preset; }
};

/// A value type; holds every key that exists on this machine: the keys of its axes and of its tools and all
/// others.
class Settings {
 public:
  /// The dialect's default machine. Its axes and tools are those the schema's overrides name. The schema's
  /// tables must outlive the settings. A declared default that does not fit its own declaration is a bug, see
  /// schema_faults().
  static Settings defaults(const Schema& schema);

  /// The value of a key that exists and is declared with the type asked for; anything else is a bug and
  /// aborts.
  bool boolean(std::string_view key) const;
  std::int64_t integer(std::string_view key) const;
  double number(std::string_view key) const;            ///< also of an integer
  const std::string& text(std::string_view key) const;  ///< of a word or a text
  std::array<double, 2> pair(std::string_view key) const;

  /// Whether the key exists on this machine: declared, and of an axis and a tool that exist.
  bool contains(std::string_view key) const { return find(key) != nullptr; }
  /// Null when the key does not exist. Valid until the settings change.
  const Setting* find(std::string_view key) const;

  AxisSet axes() const { return axes_; }
  const std::set<std::int32_t>& tool_numbers() const { return tools_; }
  const Schema& schema() const { return schema_; }

  /// Every setting, table by table in order of declaration; axes and tools in their own order. Valid until a
  /// change.
  std::vector<const Setting*> in_order() const;

  /// Adds an axis or a tool with the defaults of all its keys; nothing happens when it exists.
  void add_axis(Axis axis);
  void add_tool(std::int32_t number);
  /// Makes these the machine's axes, all with default values.
  void replace_axes(AxisSet axes);
  /// Sets an existing key to a value that checked_value() has passed.
  void assign(std::string_view key, Value value, ValueOrigin origin);

 private:
  explicit Settings(const Schema& schema) : schema_(schema) {}
  void add_instance(Instance kind, std::string_view name);
  void add_default(const Parameter& parameter, const std::string& key);
  void remove_axis(Axis axis);
  void number_axes();
  template <class T>
  const T& get(std::string_view key) const;

  Schema schema_;
  AxisSet axes_;
  std::set<std::int32_t> tools_;
  std::map<std::string, Setting, std::less<>> values_;
};

}  // namespace kerf
