// GRAFIK: what a test run of 1000 blocks on a part of 120 × 80 × 30 mm costs beside the bare path of the same blocks,
// how soon its first picture is on a station's screen, and what fifteen of them at once take of the server's memory.
#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <mutex>
#include <thread>

#include "drawing/graphic_view.hpp"
#include "figure.hpp"
#include "harness/classroom.hpp"
#include "language/tape.hpp"
#include "process_figures.hpp"
#include "testrun/test_run.hpp"
#include "typist.hpp"

namespace cnclab::bench {
namespace {

constexpr int kBlocks = 1000;
constexpr int kRounds = 20;

constexpr int kPerProgram = 500;

/// 1000 blocks in two programs; `block(n)` writes block n, from 2, without N.
template <typename WriteBlock>
std::string two_programs(std::string_view tool, WriteBlock block) {
  std::string tape = fmt::format("P0000\nT001{}\nP0001\nN001G11F3000S1000T01M03\nN002G00X-60000Y-40000Z+1000\n", tool);
  for (int n = 2; n < kBlocks; ++n) {
    const int number = n % kPerProgram + 1;
    if (number == 1) tape += "P0002\n";
    tape += fmt::format("N{:03}{}\n", number, n == kPerProgram - 1 ? "G20P0002N001" : block(n));
  }
  return tape + "%\n";
}

/// The block is milled away in layers, to and fro with a cutter of 10 mm.
std::string layers() {
  constexpr int kWaysPerLayer = 32;
  return two_programs("R+5000L+0", [](int n) -> std::string {
    const int way = (n - 2) % kWaysPerLayer;
    if (way == 0) return "G01Z-1500";
    if (way % 2 == 0) return (n - 2) / kWaysPerLayer % 2 == 0 ? "G01Y+5000" : "G01Y-5000";
    return way % 4 == 1 ? "G01X+120000" : "G01X-120000";
  });
}

/// The dearest: full circles of 60 mm with a cutter of 40 mm, each a little deeper.
std::string circles() {
  return two_programs("R+20000L+0", [](int n) -> std::string {
    if (n == 2) return "G01X+60000Y+10000";
    return n % 2 == 0 ? "G02X+0Y+0I+0J+30000" : "G01Z-50";
  });
}

testrun::TestOrder order_of(const std::string& tape) {
  testrun::TestOrder order;
  for (auto& read : language::read_tape(tape, language::Reading::file).programs)
    order.programs.put(std::move(read.program));
  order.workpiece = drawing::standard_workpiece({});
  order.travel = testrun::travel_about({}, order.data);
  return order;
}

double cpu_ms() { return 1000 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::size_t heap_bytes() {
  const auto heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

/// The whole run in the portions in which GRAFIK plays it, each with its picture.
double test_run_ms(const testrun::TestOrder& order) {
  constexpr std::uint64_t kPortion = 200;
  const double before = cpu_ms();
  auto test = testrun::TestRun::begin(order);
  std::size_t dots = 0;
  while (test && !test->has_ended()) {
    test->advance(kPortion);
    dots += draw_scene(test->scene(), {.view = drawing::View::iso}).row_text(0).size();
  }
  const double used = cpu_ms() - before;
  if (!test || test->blocks() != kBlocks || dots == 0) throw std::runtime_error("the test run did not play all blocks");
  return used;
}

/// The floor: the path of the same blocks, seen by nobody.
double bare_ms(const testrun::TestOrder& order) {
  const double before = cpu_ms();
  auto source = program::PathSource::begin(order.programs, order.settings, order.start);
  std::vector<geometry::PathItem> items;
  while (source && !source->ended()) {
    items.clear();
    if (!source->step(items)) break;
  }
  return cpu_ms() - before;
}

void measure_run(std::string_view name, const std::string& tape) {
  const testrun::TestOrder order = order_of(tape);
  Times runs, floors;
  for (int round = 0; round < kRounds; ++round) {
    runs.push_back(test_run_ms(order));
    floors.push_back(bare_ms(order));
  }
  print_figure(fmt::format("graphics_1000_{}_cpu_ms", name), percentile(runs, 0.5), "ms");
  print_figure(fmt::format("graphics_1000_{}_bare_cpu_ms", name), percentile(floors, 0.5), "ms");
}

/// Fifteen at once, each to its end: what lies on the heap then.
void measure_memory(const std::string& tape) {
  constexpr double kBytesPerMib = 1024 * 1024;
  const testrun::TestOrder order = order_of(tape);
  const std::size_t before = heap_bytes();
  std::size_t most = 0;
  std::vector<testrun::TestRun> tests;
  for (int station = 0; station < kStations; ++station)
    if (auto test = testrun::TestRun::begin(order)) tests.push_back(std::move(*test));
  while (!std::ranges::all_of(tests, &testrun::TestRun::has_ended)) {
    for (testrun::TestRun& test : tests) test.advance(20);
    most = std::max(most, heap_bytes() - before);
  }
  print_figure("graphics_heap_mib_each_of_15", static_cast<double>(most) / kStations / kBytesPerMib, "MiB");
}

/// From START to the screen that shows how far the tool has come, ms.
double first_picture_ms(harness::StationProcess& seat) {
  seat.key("MENU GRAFIK ENTER");
  const auto start = Clock::now();
  seat.key("START");
  seat.wait_for("Weg ");
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

using Seats = std::vector<harness::StationProcess>;

Times first_pictures_of_all(Seats& seats) {
  std::mutex mutex;
  Times all;
  std::vector<std::jthread> students;
  for (harness::StationProcess& seat : seats)
    students.emplace_back([&] {
      const double mine = first_picture_ms(seat);
      seat.wait_for("100 %  X-Y");
      const std::lock_guard lock(mutex);
      all.push_back(mine);
    });
  students.clear();
  return all;
}

void measure_classroom(const std::string& tape) {
  harness::Classroom room;
  Seats seats;
  for (int i = 1; i <= kStations; ++i) room.add_student(student_name(i), {tape});
  for (int i = 1; i <= kStations; ++i) seats.push_back(room.seat(i, student_name(i)));
  const pid_t server = room.server().pid();
  const double before = rss_mib(server);
  Times alone;
  for (int round = 0; round < kRounds; ++round) alone.push_back(first_picture_ms(seats.front()));
  print_percentiles("graphics_first_picture_ms", alone, "ms");
  Times together;
  for (int round = 0; round < kRounds; ++round) {
    const Times times = first_pictures_of_all(seats);
    together.insert(together.end(), times.begin(), times.end());
  }
  print_percentiles("graphics_first_picture_of_15_ms", together, "ms");
  print_figure("graphics_server_mib_each_of_15", (peak_rss_mib(server) - before) / kStations, "MiB");
}

}  // namespace
}  // namespace cnclab::bench

int main() try {
  using namespace cnclab;
  const std::string tape = bench::layers();
  bench::measure_run("lines", tape);
  bench::measure_run("circles", bench::circles());
  bench::measure_memory(tape);
  bench::measure_classroom(tape);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "bench_graphics: {}\n", error.what());
  return 1;
}
