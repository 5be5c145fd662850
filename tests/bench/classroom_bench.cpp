// A full classroom against the real server: from key to screen with 15 stations typing, memory and load with 15
// programs running; beside the floor, the same frames echoed by a bare Asio server (LOAD-001).
#include <mutex>
#include <thread>

#include "figure.hpp"
#include "harness/classroom.hpp"
#include "process_figures.hpp"
#include "typist.hpp"

namespace cnclab {
namespace {

using bench::Clock;
using bench::cpu_seconds;
using bench::kBetweenKeys;
using bench::kKeys;
using bench::kStations;
using bench::rss_mib;
using bench::Times;
using namespace std::chrono_literals;

Times type_in_classroom(harness::Classroom& classroom) {
  std::mutex mutex;
  Times all;
  {
    std::vector<std::jthread> threads;
    for (int station = 1; station <= kStations; ++station) {
      threads.emplace_back([&, station] {
        const std::string name = bench::student_name(station);
        std::string password;
        {
          const std::lock_guard lock(mutex);
          password = classroom.passwords().password_of(name);
        }
        bench::Typist typist(classroom.server().port(), station);
        if (!typist.log_in(name, password)) throw std::runtime_error(name + " could not log in");
        typist.press(Key::EINGABE);
        Times mine;
        auto next = Clock::now() + station * kBetweenKeys / kStations;
        for (int i = 0; i < kKeys; ++i) {
          typist.idle_until(next);
          next += kBetweenKeys;
          mine.push_back(typist.press(i % 5 == 4 ? Key::CLEAR : Key::D1));
        }
        const std::lock_guard lock(mutex);
        all.insert(all.end(), mine.begin(), mine.end());
      });
    }
  }
  return all;
}

/// Fifteen programs on fifteen training machines; share of one core over some seconds.
double run_in_classroom(harness::Classroom& classroom) {
  std::vector<harness::StationProcess> seats;
  for (int station = 1; station <= kStations; ++station)
    seats.push_back(classroom.seat(station, bench::student_name(station)));
  for (auto& seat : seats) seat.expect_ok("key MENU AUTOMAT ENTER ENTER START");
  const pid_t pid = classroom.server().pid();
  const double before = cpu_seconds(pid);
  const auto start = Clock::now();
  std::this_thread::sleep_for(10s);
  const std::chrono::duration<double> time = Clock::now() - start;
  const double used = cpu_seconds(pid) - before;
  for (auto& seat : seats) seat.expect_ok("key STOP");
  return 100 * used / time.count();
}

}  // namespace
}  // namespace cnclab

int main() try {
  using namespace cnclab;
  harness::Classroom classroom;
  const std::string endless = "P0001N001G11F2000N002G01X+20000Y+10000N003G01X-20000Y-10000N004G20P0001N002%";
  for (int i = 1; i <= kStations; ++i) classroom.add_student(bench::student_name(i), {endless});
  auto floor = bench::ping_pong();
  auto keys = type_in_classroom(classroom);
  bench::print_percentiles("tcp_tls_pingpong_us", floor, "us");
  bench::print_percentiles("key_to_screen_us", keys, "us");
  const double load = run_in_classroom(classroom);
  bench::print_figure("server_rss_mib_15_stations", rss_mib(classroom.server().pid()), "MiB");
  bench::print_figure("server_cpu_percent_15_running", load, "%");
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "bench_classroom: {}\n", error.what());
  return 1;
}
