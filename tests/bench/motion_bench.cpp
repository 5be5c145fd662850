// How long a tick takes and how many blocks per second the look-ahead plans.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "machine/channel.hpp"
#include "machine/simulated_machine.hpp"

namespace {

using namespace cnclab;
using Clock = std::chrono::steady_clock;

constexpr machine::Epoch kLease{1};
constexpr double kTick_s = 1e-3;

/// A part's outline as programs have it: lines of some millimetres, every fourth block an arc, on a ring.
std::vector<geometry::PathItem> outline(int blocks) {
  std::vector<geometry::PathItem> items;
  geometry::Point at{40, 0, 0, 0};
  for (int i = 0; i < blocks; ++i) {
    const double angle = (i + 1) * 0.07;
    const double radius = 40 + 3 * std::sin(i * 0.9);
    const geometry::Point to{radius * std::cos(angle), radius * std::sin(angle), 0.5 * std::sin(i * 0.1), 0};
    geometry::PathItem item;
    item.source = {1, static_cast<std::uint16_t>(i % 999 + 1)};
    item.sequence = static_cast<std::uint64_t>(i) + 1;
    item.ends_block = true;
    item.what = geometry::Line{at, to, 1500, false};
    if (i % 4 == 3) {
      const geometry::Point middle{(at.x + to.x) / 2, (at.y + to.y) / 2, 0, 0};
      item.what = geometry::Arc{at, to, middle, geometry::Turn::counterclockwise, geometry::Plane::xy, 1500};
    }
    items.push_back(item);
    at = to;
  }
  return items;
}

/// Nanoseconds of each tick of a run that never ends before the measurement does.
std::vector<double> tick_times_ns(int ticks) {
  const machine::MachineData data;
  machine::SimulatedMachine iron(data);
  machine::Channel channel(iron, data);
  channel.grant(kLease, machine::kNeverExpires);
  channel.tick(1, kTick_s);
  const auto items = outline(30'000);
  motion::Planner* planner = channel.begin_run(kLease, {40, 0, 0, 0});
  for (const auto& item : items) benchmark::DoNotOptimize(planner->append(item));
  planner->plan();
  benchmark::DoNotOptimize(channel.command(machine::Go{kLease}));
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(ticks));
  for (int i = 0; i < ticks; ++i) {
    const auto begin = Clock::now();
    channel.tick(i + 2, kTick_s);
    times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
  }
  if (!channel.snapshot().started) std::abort();
  return times;
}

double planned_per_second() {
  const auto items = outline(60'000);
  const auto begin = Clock::now();
  motion::SegmentQueue queue;
  motion::Planner planner(queue, {});
  int waiting = 0;
  for (const auto& item : items) {
    benchmark::DoNotOptimize(planner.append(item));
    if (++waiting % 100 == 0) planner.plan();
  }
  planner.plan();
  return static_cast<double>(items.size()) / std::chrono::duration<double>(Clock::now() - begin).count();
}

void tick(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(tick_times_ns(20'000));
  state.SetItemsProcessed(state.iterations() * 20'000);
}
BENCHMARK(tick)->Unit(benchmark::kMillisecond);

void plan(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(planned_per_second());
  state.SetItemsProcessed(state.iterations() * 60'000);
}
BENCHMARK(plan)->Unit(benchmark::kMillisecond);

void print_figures() {
  std::vector<double> times = tick_times_ns(200'000);
  std::ranges::sort(times);
  std::vector<double> rates;
  for (int i = 0; i < 5; ++i) rates.push_back(planned_per_second());
  std::ranges::sort(rates);
  std::printf("tick_ns_median %.0f ns\n", times[times.size() / 2]);
  std::printf("tick_ns_p99 %.0f ns\n", times[times.size() * 99 / 100]);
  std::printf("planner_blocks_per_second %.0f 1/s\n", rates[rates.size() / 2]);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  print_figures();
  return 0;
}
