// What a tick costs, how many blocks per second the look-ahead plans, and how far the workpiece keeps ahead of time.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "figure.hpp"
#include "machine/channel.hpp"
#include "machine/milling.hpp"
#include "machine/recorder.hpp"
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

/// A straight row of ways that are shorter than a tick at F MAX: many joints in each tick.
std::vector<geometry::PathItem> short_ways(int blocks, double way_mm) {
  std::vector<geometry::PathItem> items;
  for (int i = 0; i < blocks; ++i) {
    geometry::PathItem item;
    item.sequence = static_cast<std::uint64_t>(i) + 1;
    item.ends_block = true;
    item.what = geometry::Line{{i * way_mm, 0, 0, 0}, {(i + 1) * way_mm, 0, 0, 0}, 3000, false};
    items.push_back(item);
  }
  return items;
}

/// Everything that can be switched on beside a run.
struct Extras {
  bool trace = false, cuts = false, recorder = false;
  double override_ratio = 1;
};

/// Nanoseconds of each tick of a run that never ends before the measurement does.
std::vector<double> tick_times_ns(const std::vector<geometry::PathItem>& items, const geometry::Point& start, int ticks,
                                  const Extras& extras) {
  machine::MachineData data;
  for (const int travel : {3, 4, 5}) benchmark::DoNotOptimize(data.set(travel, 9'000'000));
  machine::SimulatedMachine iron(data);
  machine::MachineRecorder recorder(iron);
  machine::Channel channel(extras.recorder ? static_cast<machine::Machine&>(recorder) : iron, data);
  machine::CutFeed feed;
  if (extras.cuts) channel.feed_cuts(&feed);
  channel.record_trace(extras.trace);
  channel.set_override(extras.override_ratio);
  channel.grant(kLease, machine::kNeverExpires);
  channel.tick(1, kTick_s);
  motion::Planner* planner = channel.begin_run(kLease, start);
  for (const auto& item : items) benchmark::DoNotOptimize(planner->append(item));
  planner->plan();
  benchmark::DoNotOptimize(channel.command(machine::Go{kLease}));
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(ticks));
  std::vector<machine::TracePoint> trace;
  for (int i = 0; i < ticks; ++i) {
    const auto begin = Clock::now();
    channel.tick(i + 2, kTick_s);
    times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
    if (i % 1000 != 0) continue;
    trace.clear();
    benchmark::DoNotOptimize(channel.drain_trace(trace));
    while (feed.ring.pop()) {
    }
  }
  if (!channel.snapshot().started) std::abort();
  return times;
}

/// Seconds to plan so many blocks, which are consumed as they come.
double planning_s(int blocks) {
  constexpr int kPart = 60'000;
  constexpr std::size_t kAhead = 8192;
  const auto items = outline(kPart);
  motion::SegmentQueue queue;
  motion::Planner planner(queue, {});
  const auto begin = Clock::now();
  for (int i = 0; i < blocks; ++i) {
    benchmark::DoNotOptimize(planner.append(items[static_cast<std::size_t>(i % kPart)]));
    if (i % 100 == 99) planner.plan();
    while (queue.waiting() > kAhead) queue.pop();
  }
  planner.plan();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Seconds of milling at F1000 per second of work: slots along X, one beside the other.
double milling_speed(double radius_mm, double cell_mm) {
  constexpr double kFeed_mm_per_tick = 1000.0 / 60 * kTick_s;
  constexpr int kTicks = 60'000;
  machine::Milling milling({{120, 80, 30}, cell_mm});
  machine::ToolPoint point{.radius_mm = radius_mm, .begins_run = true, .spindle_on = true};
  milling.take(point);
  point.begins_run = false;
  double x = 0, direction = 1;
  const auto begin = Clock::now();
  for (int i = 0; i < kTicks; ++i) {
    x += direction * kFeed_mm_per_tick;
    if (std::abs(x) > 55) direction = -direction;
    point.mm = {x, std::fmod(i * 0.001, 60) - 30, -2 - i * 1e-5};
    milling.take(point);
  }
  milling.flush();
  return kTicks * kTick_s / std::chrono::duration<double>(Clock::now() - begin).count();
}

void tick(benchmark::State& state) {
  const auto items = outline(30'000);
  for (auto _ : state) benchmark::DoNotOptimize(tick_times_ns(items, {40, 0, 0, 0}, 20'000, {}));
  state.SetItemsProcessed(state.iterations() * 20'000);
}
BENCHMARK(tick)->Unit(benchmark::kMillisecond);

void plan(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(planning_s(60'000));
  state.SetItemsProcessed(state.iterations() * 60'000);
}
BENCHMARK(plan)->Unit(benchmark::kMillisecond);

void print_tick_figures() {
  const auto print = [](std::string_view name, std::vector<double> times) {
    bench::print_figure(fmt::format("{}_median", name), bench::percentile(times, 0.5), "ns");
    bench::print_figure(fmt::format("{}_p99", name), bench::percentile(times, 0.99), "ns");
  };
  const geometry::Point ring{40, 0, 0, 0};
  const auto part = outline(60'000);
  print("tick_ns", tick_times_ns(part, ring, 200'000, {}));
  print("tick_everything_on_ns",
        tick_times_ns(part, ring, 200'000, {.trace = true, .cuts = true, .recorder = true, .override_ratio = 0.7}));
  print("tick_short_ways_ns", tick_times_ns(short_ways(60'000, 0.01), {}, 11'000, {}));
  print("tick_short_ways_potentiometer_ns",
        tick_times_ns(short_ways(60'000, 0.01), {}, 11'000, {.override_ratio = 0.7}));
}

void print_figures() {
  print_tick_figures();
  std::vector<double> rates;
  for (int i = 0; i < 5; ++i) rates.push_back(60'000 / planning_s(60'000));
  bench::print_figure("planner_blocks_per_second", bench::percentile(rates, 0.5), "1/s");
  std::vector<double> ratios;
  for (int i = 0; i < 5; ++i) ratios.push_back(planning_s(1'000'000) / planning_s(100'000));
  bench::print_figure("planner_million_to_hundred_thousand", bench::percentile(ratios, 0.5), "times");
  bench::print_figure("workpiece_real_time_r5", milling_speed(5, 0.25), "times");
  bench::print_figure("workpiece_real_time_r20", milling_speed(20, 0.25), "times");
  bench::print_figure("workpiece_real_time_fine", milling_speed(5, 0.05), "times");
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  print_figures();
  return 0;
}
