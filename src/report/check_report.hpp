#pragma once
// The result of checking several programs: a table for people, JUnit and SARIF files for build servers.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/alarm.hpp"

namespace kerf {

/// An alarm or warning in the file it points into, which may be that of a subprogram.
struct CheckFinding {
  std::string file;
  Alarm alarm;
  std::uint32_t first_column = 1;  ///< in characters, from 1
  std::uint32_t end_column = 1;    ///< behind the last one
};

enum class CheckOutcome : std::uint8_t {
  executed,
  called,      ///< a subprogram that a checked program called
  not_called,  ///< a subprogram that none of them called: its text was read and not executed
  unreadable,  ///< no program, or its machine is not one
};

/// One file.
struct CheckedProgram {
  std::string file;
  CheckOutcome outcome = CheckOutcome::executed;
  std::string message;  ///< unreadable: why
  std::string remark;   ///< what else is to be said of it
  std::string caller;   ///< called: the first program that did
  std::vector<CheckFinding> findings;
  std::uint64_t blocks = 0;
  std::uint64_t alarms = 0;
  std::uint64_t warnings = 0;
};

/// One line for each program under a heading, and a last line with the sums.
std::string check_table(std::span<const CheckedProgram> programs);

/// A test case for each program; an alarm makes it fail.
/// Format: the XML of the JUnit task of Apache Ant, as CI servers read it.
std::string junit_text(std::span<const CheckedProgram> programs);

/// Format: SARIF 2.1.0 (OASIS). `version` is kerf's.
std::string sarif_text(std::span<const CheckedProgram> programs, std::string_view version);

}  // namespace kerf
