// How many blocks a second the language takes: read, executed, compensated, and as a whole process of the tool.
// 100 000 blocks G01, as programs of 999 chained by G20.
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "figure.hpp"
#include "language/tape.hpp"
#include "program/path_source.hpp"

namespace cnclab {
namespace {

constexpr int kBlocks = 100'000;
constexpr int kPerProgram = 999;

/// Blocks in programs of 999; the last block of each jumps to the next. `block(n)` writes block n, from 0, without N.
template <typename WriteBlock>
std::string chained(int blocks, WriteBlock block) {
  std::string tape;
  int left = blocks;
  for (int program = 1; left > 0; ++program) {
    tape += fmt::format("P{:04}\n", program);
    const int here = std::min(left, kPerProgram);
    for (int n = 1; n <= here; ++n) {
      if (n == kPerProgram)
        tape += fmt::format("N{:03}G20P{:04}N001\n", n, program + 1);
      else
        tape += fmt::format("N{:03}{}\n", n, block((program - 1) * kPerProgram + n - 1));
    }
    left -= here;
  }
  return tape + "%\n";
}

/// A zigzag, so that no block is like the one before.
std::string zigzag(int blocks = kBlocks) {
  return chained(blocks, [](int n) {
    return fmt::format("G01X{}Y{}F1000", n % 2 == 0 ? "-100" : "+100", (n + 1) % 3 == 0 ? "+50" : "-25");
  });
}

/// Polygons with 360 sides of 0.1 mm, run round and round; under G42 the tool of 0.005 mm keeps outside.
std::string polygons() {
  return "P0000T001R+5L+0\n" + chained(kBlocks, [](int n) -> std::string {
           if (n == 0) return "G11F1000T01";
           if (n == 1) return "G42";
           const double angle = n * std::numbers::pi / 180;
           return fmt::format("G01X{:+}Y{:+}", std::lround(100 * std::cos(angle)), std::lround(100 * std::sin(angle)));
         });
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

/// From text to the path of the tool's centre; blocks executed, 0 where something is wrong.
int text_to_path(const std::string& text) {
  auto source = program::PathSource::begin(programs_of(text), {}, {});
  if (!source) return 0;
  std::vector<geometry::PathItem> items;
  int blocks = 0;
  while (!source->ended()) {
    items.clear();
    if (!source->step(items)) return 0;
    ++blocks;
  }
  benchmark::DoNotOptimize(items.data());
  return blocks;
}

/// The middle of five runs.
template <typename Run>
void print_rate(std::string_view name, Run run) {
  std::vector<double> rates;
  for (int round = 0; round < 5; ++round) {
    const auto start = std::chrono::steady_clock::now();
    const int blocks = run();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    rates.push_back(blocks / time.count());
  }
  bench::print_figure(name, bench::percentile(rates, 0.5), "1/s");
}

/// `cnclab-tool path FILE` as a process, its output thrown away.
int tool_path(const std::filesystem::path& file, int blocks) {
  const auto tool = std::filesystem::canonical("/proc/self/exe").parent_path() / "cnclab-tool";
  const std::string command = fmt::format("'{}' path '{}' > /dev/null", tool.string(), file.string());
  return std::system(command.c_str()) == 0 ? blocks : 0;
}

std::filesystem::path bench_file() {
  return std::filesystem::temp_directory_path() / fmt::format("cnclab-bench-{}.cnc", getpid());
}

/// To be called before this process grows: a child's peak counts from what its parent holds.
void print_tool_memory() {
  const auto file = bench_file();
  std::ofstream(file) << zigzag();
  static_cast<void>(tool_path(file, kBlocks));
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children);
  const double text_kib = static_cast<double>(std::filesystem::file_size(file)) / 1024;
  bench::print_figure("tool_path_mib_beyond_text", (static_cast<double>(children.ru_maxrss) - text_kib) / 1024, "MiB");
  std::filesystem::remove(file);
}

void print_tool_rate() {
  constexpr int kMany = 10 * kBlocks;
  const auto file = bench_file();
  std::ofstream(file) << zigzag(kMany);
  print_rate("tool_path_blocks_per_second", [&] { return tool_path(file, kMany); });
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace cnclab

int main(int argc, char** argv) {
  using namespace cnclab;
  print_tool_memory();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  const std::string straight = zigzag(), beside = polygons();
  const auto programs = programs_of(straight);
  print_rate("interpreter_blocks_per_second", [&] { return execute(programs); });
  print_rate("text_to_path_blocks_per_second", [&] { return text_to_path(straight); });
  print_rate("text_to_path_g42_blocks_per_second", [&] { return text_to_path(beside); });
  print_tool_rate();
}
