#pragma once
// What is wrong in a machine file or in a `--set` option, and where.

#include <cstdint>
#include <string>

#include "base/alarm.hpp"

namespace kerf {

struct SettingsError {
  std::string file;          ///< name of the file, or the option: `--set axes.X.rapid=fast`; empty: no place
  std::uint32_t line = 0;    ///< from 1; 0: no line
  std::uint32_t column = 0;  ///< from 1, in characters; where the key stands or, for a bad value, the value
  std::string message;
  std::string remedy;      ///< empty: the message says it all
  std::string alarm = {};  ///< the controller's code for it, as `refused` events name it: 0016H; empty: none
};

/// Makes it an error that the controller knows: the message then begins `30FDH/0016H Macro control setting
/// error: `.
void name_alarm(SettingsError& error, const AlarmKind& kind);

/// One line: `machine.toml:3:1: unknown key 'axes.X.rapit'; did you mean 'axes.X.rapid'?`
std::string error_text(const SettingsError& error);

}  // namespace kerf
