#pragma once
// SIGINT, SIGTERM and SIGHUP as a wish to end, so that nothing half written stays behind.

#include <array>
#include <csignal>

namespace kerf {

/// While an object lives, the first of these signals is only noted; a second one ends the process at once.
/// One object at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// The signal that came, or 0.
  static int signal();

 private:
  static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace kerf
