#pragma once

namespace kerf {

inline constexpr int kExitGood = 0;
inline constexpr int kExitAlarm = 1;     ///< the controller refused the program
inline constexpr int kExitUsage = 2;     ///< wrong usage, unreadable file, no program at all
inline constexpr int kExitSignal = 128;  ///< plus the signal that interrupted, as shells count

}  // namespace kerf
