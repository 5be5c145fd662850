// How many blocks a second the interpreter executes: 100 000 blocks G01, as programs of 999 chained by G20.
#include <benchmark/benchmark.h>

#include <chrono>
#include <string>

#include "figure.hpp"
#include "language/tape.hpp"
#include "program/interpreter.hpp"

namespace cnclab {
namespace {

constexpr int kBlocks = 100'000;
constexpr int kPerProgram = 999;

/// A zigzag, so that no block is like the one before; the last block of each program jumps to the next.
std::string zigzag() {
  std::string tape;
  int left = kBlocks;
  for (int program = 1; left > 0; ++program) {
    tape += fmt::format("P{:04}\n", program);
    const int here = std::min(left, kPerProgram);
    for (int n = 1; n <= here; ++n) {
      if (n == kPerProgram)
        tape += fmt::format("N{:03}G20P{:04}N001\n", n, program + 1);
      else
        tape += fmt::format("N{:03}G01X{}Y{}F1000\n", n, n % 2 == 0 ? "+100" : "-100", n % 3 == 0 ? "+50" : "-25");
    }
    left -= here;
  }
  return tape + "%\n";
}

program::ProgramSet programs_of(const std::string& text) {
  program::ProgramSet set;
  for (auto& read : language::read_tape(text, language::Reading::file).programs) set.put(std::move(read.program));
  return set;
}

int execute(const program::ProgramSet& programs) {
  auto interpreter = program::Interpreter::begin(programs, {}, {});
  if (!interpreter) return 0;
  std::vector<geometry::PathItem> items;
  int blocks = 0;
  while (!interpreter->ended()) {
    items.clear();
    if (!interpreter->step(items)) break;
    ++blocks;
  }
  benchmark::DoNotOptimize(items.data());
  return blocks;
}

void read_and_execute(benchmark::State& state) {
  const std::string text = zigzag();
  const auto programs = programs_of(text);
  int blocks = 0;
  for (auto _ : state) blocks += execute(programs);
  state.SetItemsProcessed(blocks);
}
BENCHMARK(read_and_execute)->Name("interpreter/100000_G01")->Unit(benchmark::kMillisecond);

void read_text(benchmark::State& state) {
  const std::string text = zigzag();
  for (auto _ : state) benchmark::DoNotOptimize(language::read_tape(text, language::Reading::file));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * kBlocks);
}
BENCHMARK(read_text)->Name("tape_reader/100000_G01")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cnclab

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  const auto programs = cnclab::programs_of(cnclab::zigzag());
  std::vector<double> rates;
  for (int run = 0; run < 5; ++run) {
    const auto start = std::chrono::steady_clock::now();
    const int blocks = cnclab::execute(programs);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    rates.push_back(blocks / time.count());
  }
  cnclab::bench::print_figure("interpreter_blocks_per_second", cnclab::bench::percentile(rates, 0.5), "1/s");
}
