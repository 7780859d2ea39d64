#include "cli/console.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace kerf {
namespace {

constexpr int kDefaultWidth = 100;
constexpr int kNarrowest = 40;
constexpr int kWidest = 160;
constexpr auto kQuietTime = std::chrono::seconds(1);
constexpr auto kRefresh = std::chrono::milliseconds(100);

/// Writes all bytes; false with errno set otherwise.
bool write_fully(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool terminal_shows_color() {
  const char* term = std::getenv("TERM");
  return std::getenv("NO_COLOR") == nullptr && term != nullptr && std::strcmp(term, "dumb") != 0;
}

}  // namespace

DiagnosticStyle style_of_stream(int descriptor, ColorChoice choice) {
  DiagnosticStyle style;
  const bool terminal = ::isatty(descriptor) == 1;
  style.color = choice == ColorChoice::always ||
                (choice == ColorChoice::automatic && terminal && terminal_shows_color());
  style.width = kDefaultWidth;
  winsize size{};
  if (terminal && ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    style.width = std::clamp<int>(size.ws_col, kNarrowest, kWidest);
  }
  return style;
}

void ResultStream::flush() {
  if (good_ && !write_fully(STDOUT_FILENO, text_)) {
    good_ = false;
    print_error(fmt::format("cannot write the result: {}", std::strerror(errno)));
  }
  text_.clear();
}

std::string count_text(std::uint64_t count, std::string_view one, std::string_view more) {
  if (count == 0) return fmt::format("no {}", more);
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

void print_error(std::string_view message, std::string_view remedy) {
  std::string text = fmt::format("kerf: {}\n", message);
  if (!remedy.empty()) text += fmt::format("      {}\n", remedy);
  write_fully(STDERR_FILENO, text);
}

ProgressLine::ProgressLine() : next_(Clock::now() + kQuietTime), terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown_) write_fully(STDERR_FILENO, "\r\x1b[K");
}

void ProgressLine::show(double share, std::string_view what) {
  if (!terminal_) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + kRefresh;
  shown_ = true;
  constexpr int kCells = 30;
  const int full = static_cast<int>(std::clamp(share, 0.0, 1.0) * kCells);
  write_fully(STDERR_FILENO, fmt::format("\r\x1b[K[{:#<{}}{:.<{}}] {:3.0f} %  {}", "", full, "",
                                         kCells - full, share * 100.0, what));
}

}  // namespace kerf
