#pragma once
// The executed toolpath as a table for people, for `kerf path`.

#include <cstdint>
#include <functional>
#include <string>

#include "execute/action.hpp"
#include "machine/machine.hpp"

namespace kerf {

/// Writes actions as rows of fixed columns: source line, sequence number, what happens, the end position of
/// every axis (machine coordinates, mm or degrees), feed (mm/min), and for arcs radius, centre and sweep.
/// Rows can be printed as they come; nothing is kept but the program number, which is announced when it
/// changes.
class PathTable {
 public:
  /// The feed that is in force for a move that is no rapid, mm/min.
  using EffectiveFeed = std::function<double(const Move&)>;

  explicit PathTable(const Machine& machine, EffectiveFeed feed = {});

  /// Appends the row of column names.
  void header(std::string& out) const;

  /// Appends one row. A CornerArc belongs between two stages of the toolpath and writes nothing.
  void write(const Action& action, std::string& out);

 private:
  void write_move(const Move& move, std::string& out) const;

  AxisSet axes_;
  EffectiveFeed feed_;
  std::int32_t program_ = -1;
};

}  // namespace kerf
