// Speed of the language stage: reading blocks, executing them, and executing them under radius compensation.
// Target on one core: 5 million blocks of three axes with four decimals a second, read and executed.

#include <benchmark/benchmark.h>
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "dialect/setup.hpp"
#include "execute/interpreter.hpp"
#include "syntax/block_reader.hpp"
#include "toolpath/toolpath.hpp"

namespace {

using namespace kerf;

constexpr int kBlocks = 100'000;

/// A wavy line inside 50 mm, `format` writes one block of it.
template <class Format>
std::shared_ptr<const Source> wave(const std::string& head, Format format) {
  std::string text = "%\nG21G90G17\nS3000F1000.0\nM03\n" + head;
  for (int i = 0; i < kBlocks; ++i) {
    const double t = 1e-3 * i;
    text += format(25.0 + 20.0 * std::sin(t), 25.0 + 20.0 * std::cos(0.7 * t), -1.0 + std::sin(3.0 * t));
  }
  text += "M05\nM02\n%\n";
  return Source::from_text("wave", text);
}

std::string xyz(double x, double y, double z) {
  return fmt::format("X{:.4f}Y{:.4f}Z{:.4f}\n", x, y, z);
}

Controller dgshape() {
  SetupOptions options;
  options.dialect = "dgshape";
  options.assignments = {"tools.1.radius=0.001"};
  return *make_controller(options);
}

void read_blocks(benchmark::State& state) {
  const auto source = wave("G01\n", xyz);
  Block block;
  for (auto _ : state) {
    BlockReader reader(source);
    while (reader.next(block, false) == BlockReader::Result::block) benchmark::DoNotOptimize(block);
  }
  state.SetItemsProcessed(state.iterations() * kBlocks);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(source->text().size()));
}
BENCHMARK(read_blocks)->Unit(benchmark::kMillisecond);

/// Counts the moves, so that a program that stops early cannot look fast.
void execute(benchmark::State& state, const std::shared_ptr<const Source>& source) {
  const Controller controller = dgshape();
  for (auto _ : state) {
    Interpreter interpreter(controller.rules, source, controller.interpreter_options);
    Toolpath<Interpreter> toolpath(interpreter, controller.machine, controller.toolpath_policy);
    int moves = 0;
    while (const Action* action = toolpath.next()) moves += std::holds_alternative<Move>(action->what);
    if (moves < kBlocks - 1) state.SkipWithError("the program stopped early");
  }
  state.SetItemsProcessed(state.iterations() * kBlocks);
}

void execute_coordinates(benchmark::State& state) {
  execute(state, wave("G01\n", xyz));
}
BENCHMARK(execute_coordinates)->Unit(benchmark::kMillisecond);

/// A sequence number and a G code in every block, as many post-processors write them.
void execute_numbered_blocks(benchmark::State& state) {
  int n = 0;
  execute(state, wave("", [&n](double x, double y, double z) {
            return fmt::format("N{}G01X{:.4f}Y{:.4f}Z{:.4f}\n", ++n % 99999, x, y, z);
          }));
}
BENCHMARK(execute_numbered_blocks)->Unit(benchmark::kMillisecond);

void execute_radius_compensation(benchmark::State& state) {
  execute(state, wave("G01G41D1\n", xyz));
}
BENCHMARK(execute_radius_compensation)->Unit(benchmark::kMillisecond);

}  // namespace
