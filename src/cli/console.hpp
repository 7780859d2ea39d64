#pragma once
// Standard output and standard error as the commands use them.

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include "report/diagnostic.hpp"

namespace kerf {

enum class ColorChoice : std::uint8_t { automatic, always, never };

/// How diagnostics look on a stream: colours and width of the terminal behind it, if there is one.
DiagnosticStyle style_of_stream(int descriptor, ColorChoice choice);

/// Buffers results and writes them to standard output. A failed write (a full disk) is remembered.
class ResultStream {
 public:
  ResultStream() = default;
  ResultStream(const ResultStream&) = delete;
  ResultStream& operator=(const ResultStream&) = delete;
  ~ResultStream() { flush(); }

  /// Append here, then call overflow() now and then.
  std::string& text() { return text_; }
  void overflow() {
    if (text_.size() >= kChunk) flush();
  }
  void flush();
  /// False when something could not be written; the message is on standard error then.
  bool good() const { return good_; }

 private:
  static constexpr std::size_t kChunk = std::size_t{1} << 16;
  std::string text_;
  bool good_ = true;
};

/// "no alarms", "1 alarm", "2 alarms"
std::string count_text(std::uint64_t count, std::string_view one, std::string_view more);

void print_error(std::string_view message, std::string_view remedy = {});

/// A line on standard error that shows how far a long piece of work is, only on a terminal and only after a
/// second.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `share` from 0 to 1 of the program read. Cheap when it is not time to show anything.
  void show(double share, std::string_view what);

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_;
  bool terminal_;
  bool shown_ = false;
};

}  // namespace kerf
