// The MELSEC dialect beside LinuxCNC's stand-alone interpreter: random programs of the language both know,
// written in both ways, must lead to the same places. Where rs274 is installed, CTest runs it.
//
//   kerf_differential [PROGRAMS [SEED]]
//
// Lengths are written a thousandfold for rs274, because it prints four decimals.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

#include "dialect/setup.hpp"
#include "execute/interpreter.hpp"

namespace kerf {
namespace {

constexpr double kScale = 1000.0;
constexpr double kTolerance = 1e-6;  // mm
constexpr int kBatch = 250;          // programs for one run of rs274

/// Ten-thousandths of a millimetre: what both languages can say exactly.
using Steps = std::int64_t;

double millimetres(Steps steps) {
  return static_cast<double>(steps) / 1e4;
}

struct Point {
  std::array<Steps, 3> axis{};
};

/// A move as both interpreters give it.
struct Step {
  char kind = 0;  // 'r' rapid, 'l' line, 'c' clockwise, 'a' counterclockwise
  std::array<double, 3> end{};
  std::array<double, 2> center{};
};

/// One program in both languages.
struct Program {
  std::string melsec;
  std::string rs274;
  std::vector<std::string> settings;
};

class Writer {
 public:
  explicit Writer(std::uint64_t seed) : random_(seed) {}

  Program write() {
    start();
    const int blocks = 10 + below(30);
    for (int i = 0; i < blocks; ++i) block();
    program_.melsec += "M02\n%\n";
    program_.rs274 += "(MSG,end)\n";
    return std::move(program_);
  }

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  bool chance(int percent) { return below(100) < percent; }
  /// A length of up to `largest` mm, now and then a round one.
  Steps length(int largest) {
    const Steps range = static_cast<Steps>(largest) * 10000;
    const Steps value = static_cast<Steps>(random_() % static_cast<std::uint64_t>(2 * range + 1)) - range;
    return chance(30) ? value / 10000 * 10000 : value;
  }

  void start() {
    program_.melsec = "%\n";
    emit("G90 G17 G54 G64", "G90 G17 G54 G64");
    for (std::size_t system = 0; system < 6; ++system) {
      std::string words;
      for (std::size_t a = 0; a < 3; ++a) {
        offsets_[system].axis[a] = length(100);
        program_.settings.push_back(fmt::format("offsets.G{}.{}={:.4f}", 54 + system, kLetters[a],
                                                millimetres(offsets_[system].axis[a])));
        words += fmt::format(" {}{}", kLetters[a], scaled(offsets_[system].axis[a]));
      }
      program_.rs274 += fmt::format("G10 L2 P{}{}\n", system + 1, words);
    }
    program_.rs274 += "G52 X0 Y0 Z0\nG53 G0 X0 Y0 Z0\n(MSG,begin)\n";
    emit("G01 F500.", "G01 F500");
  }

  void emit(const std::string& melsec, const std::string& rs274) {
    program_.melsec += melsec + "\n";
    program_.rs274 += rs274 + "\n";
  }

  static std::string scaled(Steps steps) { return fmt::format("{}", millimetres(steps) * kScale); }

  /// A value in both languages: a number, a sum, a product or a variable.
  struct Value {
    std::string melsec;
    std::string rs274;
  };
  Value value(Steps steps) {
    const auto number = [](Steps s) { return fmt::format("{:.4f}", millimetres(s)); };
    switch (below(8)) {
      case 0: {
        const Steps part = length(200);
        const std::string sum = fmt::format("[{} + [{}]]", number(part), number(steps - part));
        // A sign may not follow an operator in either language, so it stands in brackets of its own.
        return {sum, fmt::format("[{} * 1000]", sum)};
      }
      case 1:
        return {fmt::format("[{} * 3 / 3]", number(steps)),
                fmt::format("[{} * 3 / 3 * 1000]", number(steps))};
      case 2: {
        const int variable = 100 + variables_++ % 60;  // each once in a block
        emit(fmt::format("#{}={}", variable, number(steps)), fmt::format("#{}={}", variable, number(steps)));
        return {fmt::format("#{}", variable), fmt::format("[#{} * 1000]", variable)};
      }
      case 3:
        return {fmt::format("[2.0000 * {} * SIN[30.]]", number(steps)),
                fmt::format("[2.0000 * {} * sin[30] * 1000]", number(steps))};
      default:
        return {number(steps), scaled(steps)};
    }
  }

  void word(std::string& melsec, std::string& rs274, char address, Steps steps) {
    const Value v = value(steps);
    melsec += fmt::format(" {}{}", address, v.melsec);
    rs274 += fmt::format(" {}{}", address, v.rs274);
  }

  Steps origin(std::size_t a) const { return offsets_[system_].axis[a] + local_.axis[a]; }
  Steps written(std::size_t a, Steps target) const {
    return incremental_ ? target - position_.axis[a] : target - origin(a);
  }

  void block() {
    switch (below(12)) {
      case 0:
        incremental_ = !incremental_;
        emit(incremental_ ? "G91" : "G90", incremental_ ? "G91" : "G90");
        break;
      case 1: {
        plane_ = static_cast<std::size_t>(below(3));
        const std::string code = fmt::format("G{}", 17 + plane_);
        emit(code, code);
        break;
      }
      case 2:
        change_system();
        break;
      case 3:
        local_system();
        break;
      case 4:
        machine_move();
        break;
      case 5:
      case 6:
        center_arc();
        break;
      case 7:
      case 8:
        radius_arc();
        break;
      default:
        straight();
        break;
    }
  }

  void change_system() {
    clear_local_system();  // LinuxCNC has one for all, MELSEC one for each
    system_ = static_cast<std::size_t>(below(6));
    const std::string code = fmt::format("G{}", 54 + system_);
    emit(code, code);
  }

  void clear_local_system() {
    const std::string mode = incremental_ ? "G91" : "G90";
    emit("G90 G52 X0. Y0. Z0.", "G52 X0 Y0 Z0");
    emit(mode, mode);
    local_ = {};
  }

  void local_system() {
    std::string melsec = "G90 G52";
    std::string rs274 = "G52";
    std::string words_melsec;
    std::string words_rs274;
    for (std::size_t a = 0; a < 3; ++a) {
      local_.axis[a] = length(50);
      word(words_melsec, words_rs274, kLetters[a], local_.axis[a]);
    }
    emit(melsec + words_melsec, rs274 + words_rs274);
    const std::string mode = incremental_ ? "G91" : "G90";
    emit(mode, mode);
  }

  void machine_move() {
    std::string melsec;
    std::string rs274;
    for (std::size_t a = 0; a < 3; ++a) {
      if (!chance(60)) continue;
      position_.axis[a] = length(300);
      word(melsec, rs274, kLetters[a], position_.axis[a]);
    }
    if (melsec.empty()) return;
    emit("G90 G00 G53" + melsec, "G90 G53 G0" + rs274);
    const std::string mode = incremental_ ? "G91" : "G90";
    emit(mode, mode);
  }

  void straight() {
    std::string melsec;
    std::string rs274;
    for (std::size_t a = 0; a < 3; ++a) {
      if (!chance(60)) continue;
      const Steps target = length(300);
      word(melsec, rs274, kLetters[a], written(a, target));
      position_.axis[a] = target;
    }
    if (melsec.empty()) return;
    const std::string code = chance(30) ? "G00" : "G01";
    emit(code + melsec, code + rs274);
  }

  /// The axes of the plane in force: X Y, Z X, Y Z.
  std::array<std::size_t, 2> plane_axes() const {
    constexpr std::array<std::array<std::size_t, 2>, 3> kAxes{{{0, 1}, {2, 0}, {1, 2}}};
    return kAxes[plane_];
  }

  void arc_end(std::string& melsec, std::string& rs274, Steps first, Steps second) {
    const auto [a, b] = plane_axes();
    word(melsec, rs274, kLetters[a], written(a, first));
    word(melsec, rs274, kLetters[b], written(b, second));
    position_.axis[a] = first;
    position_.axis[b] = second;
  }

  void center_arc() {
    const auto [a, b] = plane_axes();
    const Steps i = length(60);
    const Steps j = length(60);
    if (i == 0 && j == 0) return;
    const Steps first = position_.axis[a] + i;
    const Steps second = position_.axis[b] + j;
    std::string melsec;
    std::string rs274;
    // The start seen from the centre, turned by quarters.
    switch (below(4)) {
      case 0:
        arc_end(melsec, rs274, first + j, second - i);
        break;
      case 1:
        arc_end(melsec, rs274, first + i, second + j);
        break;
      case 2:
        arc_end(melsec, rs274, first - j, second + i);
        break;
      default:
        arc_end(melsec, rs274, first - i, second - j);
        break;
    }
    constexpr std::array<char, 3> kCenters{'I', 'J', 'K'};
    word(melsec, rs274, kCenters[a], i);
    word(melsec, rs274, kCenters[b], j);
    const std::string code = chance(50) ? "G02" : "G03";
    emit(code + melsec, code + rs274);
  }

  void radius_arc() {
    const auto [a, b] = plane_axes();
    const Steps da = length(80);
    const Steps db = length(80);
    const double chord = std::hypot(millimetres(da), millimetres(db));
    if (chord < 1.0) return;
    const double radius = chord / 2.0 * (1.05 + below(300) / 100.0);
    const Steps steps = std::llround(radius * 1e4);
    std::string melsec;
    std::string rs274;
    arc_end(melsec, rs274, position_.axis[a] + da, position_.axis[b] + db);
    word(melsec, rs274, 'R', chance(50) ? steps : -steps);
    const std::string code = chance(50) ? "G02" : "G03";
    emit(code + melsec, code + rs274);
  }

  static constexpr std::array<char, 3> kLetters{'X', 'Y', 'Z'};
  std::mt19937_64 random_;
  Program program_;
  std::array<Point, 6> offsets_;
  Point local_;
  Point position_;  // machine coordinates
  std::size_t system_ = 0;
  std::size_t plane_ = 0;
  bool incremental_ = false;
  int variables_ = 0;
};

std::optional<std::vector<Step>> steps_of_kerf(const Program& program, std::string& complaint) {
  SetupOptions options;
  options.dialect = "melsec";
  options.assignments = program.settings;
  options.assignments.insert(options.assignments.end(), {"melsec.system.initial_absolute_mode=G90",
                                                         "melsec.system.common_system_points=100",
                                                         "melsec.system.common_system_start_device=D2000"});
  const auto controller = make_controller(options);
  if (!controller) {
    complaint = error_text(controller.error().front());
    return std::nullopt;
  }
  Interpreter interpreter(controller->rules, Source::from_text("O001.gcd", program.melsec),
                          controller->interpreter_options);
  std::vector<Step> steps;
  while (const Action* action = interpreter.next()) {
    if (const auto* alarm = std::get_if<Alarm>(&action->what)) {
      complaint = fmt::format("line {}: alarm {}", alarm->span.line, alarm->kind->detail);
      return std::nullopt;
    }
    const auto* move = std::get_if<Move>(&action->what);
    if (move == nullptr) continue;
    constexpr std::array<char, 4> kKinds{'r', 'l', 'c', 'a'};
    steps.push_back({kKinds[static_cast<std::size_t>(move->mode)],
                     {move->end[Axis::X], move->end[Axis::Y], move->end[Axis::Z]},
                     {move->arc.center[0], move->arc.center[1]}});
  }
  return steps;
}

/// Reads what rs274 prints, in machine coordinates; a list for what stands between the messages "begin" and
/// "end".
class Listing {
 public:
  void line(const std::string& text) {
    if (text.find("MESSAGE(\"begin\")") != std::string::npos) {
      programs.emplace_back();
      recording_ = true;
    } else if (text.find("MESSAGE(\"end\")") != std::string::npos) {
      recording_ = false;
    } else if (const auto values = arguments(text, "SET_G5X_OFFSET(")) {
      for (std::size_t a = 0; a < 3; ++a) system_[a] = (*values)[a + 1];
    } else if (const auto local = arguments(text, "SET_G92_OFFSET(")) {
      for (std::size_t a = 0; a < 3; ++a) local_[a] = (*local)[a];
    } else if (text.find("SELECT_PLANE(") != std::string::npos) {
      plane_ = text.find("PLANE_XY") != std::string::npos   ? 0
               : text.find("PLANE_XZ") != std::string::npos ? 1
                                                            : 2;
    } else if (const auto rapid = arguments(text, "STRAIGHT_TRAVERSE(")) {
      straight('r', *rapid);
    } else if (const auto feed = arguments(text, "STRAIGHT_FEED(")) {
      straight('l', *feed);
    } else if (const auto arc = arguments(text, "ARC_FEED(")) {
      add_arc(*arc);
    }
  }
  std::vector<std::vector<Step>> programs;

 private:
  static std::optional<std::vector<double>> arguments(const std::string& text, const std::string& name) {
    const std::size_t at = text.find(name);
    if (at == std::string::npos) return std::nullopt;
    std::vector<double> values;
    const char* p = text.c_str() + at + name.size();
    for (;;) {
      char* end = nullptr;
      values.push_back(std::strtod(p, &end));
      if (end == p || *end != ',') return values;
      p = end + 1;
    }
  }

  double machine(std::size_t a, double value) const { return (value + system_[a] + local_[a]) / kScale; }

  void straight(char kind, const std::vector<double>& values) {
    Step step{kind, {}, {}};
    for (std::size_t a = 0; a < 3; ++a) step.end[a] = machine(a, values[a]);
    bool moves = false;
    for (std::size_t a = 0; a < 3; ++a) moves = moves || std::abs(step.end[a] - position_[a]) > kTolerance;
    position_ = step.end;
    if (moves && recording_) programs.back().push_back(step);
  }

  void add_arc(const std::vector<double>& values) {
    constexpr std::array<std::array<std::size_t, 3>, 3> kAxes{{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};
    const auto [a, b, c] = kAxes[plane_];
    Step step{values[4] < 0.0 ? 'c' : 'a', {}, {machine(a, values[2]), machine(b, values[3])}};
    step.end[a] = machine(a, values[0]);
    step.end[b] = machine(b, values[1]);
    step.end[c] = machine(c, values[5]);
    position_ = step.end;
    if (recording_) programs.back().push_back(step);
  }

  std::array<double, 3> system_{};
  std::array<double, 3> local_{};
  std::array<double, 3> position_{};
  std::size_t plane_ = 0;
  bool recording_ = false;  // between the messages "begin" and "end"
};

std::vector<std::vector<Step>> steps_of_rs274(const std::vector<Program>& programs, std::string& complaint) {
  std::string name = (std::filesystem::temp_directory_path() / "kerf-differential-XXXXXX").string();
  const int descriptor = ::mkstemp(name.data());
  if (descriptor < 0) return {};
  ::close(descriptor);
  std::ofstream file(name);
  file << "G21 G40 G49 G80 G94\n";
  for (const Program& program : programs) file << program.rs274;
  file << "M2\n";
  file.close();
  Listing listing;
  std::FILE* pipe = ::popen(fmt::format("rs274 -g {} 2>&1", name).c_str(), "r");
  if (pipe == nullptr) return {};
  std::array<char, 1024> buffer{};
  std::string last;
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
    const std::string text(buffer.data());
    last = text;
    listing.line(text);
  }
  if (::pclose(pipe) != 0) complaint = "rs274 failed: " + last;
  ::unlink(name.c_str());
  return std::move(listing.programs);
}

bool same(const Step& a, const Step& b) {
  bool equal = a.kind == b.kind;
  for (std::size_t i = 0; i < 3; ++i) equal = equal && std::abs(a.end[i] - b.end[i]) <= kTolerance;
  if (a.kind != 'c' && a.kind != 'a') return equal;
  for (std::size_t i = 0; i < 2; ++i) equal = equal && std::abs(a.center[i] - b.center[i]) <= kTolerance;
  return equal;
}

std::string text_of(const Step& step) {
  return fmt::format("{} {:.7f} {:.7f} {:.7f} centre {:.7f} {:.7f}", step.kind, step.end[0], step.end[1],
                     step.end[2], step.center[0], step.center[1]);
}

/// Empty when both agree.
std::string difference(const std::vector<Step>& kerf, const std::vector<Step>& rs274) {
  for (std::size_t i = 0; i < std::min(kerf.size(), rs274.size()); ++i) {
    if (!same(kerf[i], rs274[i]))
      return fmt::format("move {}\n  kerf  {}\n  rs274 {}", i + 1, text_of(kerf[i]), text_of(rs274[i]));
  }
  if (kerf.size() == rs274.size()) return {};
  return fmt::format("kerf gives {} moves, rs274 {}", kerf.size(), rs274.size());
}

/// Compares a batch; the number of moves, or nothing when there was a difference.
std::optional<std::size_t> compare_batch(std::uint64_t first_seed, int count) {
  std::vector<Program> programs;
  for (int i = 0; i < count; ++i) programs.push_back(Writer(first_seed + static_cast<unsigned>(i)).write());
  std::string complaint;
  const auto expected = steps_of_rs274(programs, complaint);
  if (!complaint.empty() || expected.size() != programs.size()) {
    fmt::print("rs274, seeds from {}: {} ({} of {} programs)\n", first_seed, complaint, expected.size(),
               count);
    return std::nullopt;
  }
  std::size_t moves = 0;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    std::string why;
    const auto steps = steps_of_kerf(programs[i], why);
    if (steps) why = difference(*steps, expected[i]);
    if (!why.empty()) {
      fmt::print("seed {}: {}\n{}\n", first_seed + i, why, programs[i].melsec);
      return std::nullopt;
    }
    moves += steps->size();
  }
  return moves;
}

int compare(int programs, std::uint64_t seed) {
  std::size_t moves = 0;
  for (int done = 0; done < programs; done += kBatch) {
    const auto batch = compare_batch(seed + static_cast<unsigned>(done), std::min(kBatch, programs - done));
    if (!batch) return 1;
    moves += *batch;
  }
  fmt::print("{} programs, {} moves, seeds {} to {}: the same\n", programs, moves, seed,
             seed + static_cast<unsigned>(programs) - 1);
  return 0;
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
  const int programs = argc > 1 ? std::atoi(argv[1]) : 2000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  return kerf::compare(programs, seed);
}
