// The three loads of LOAD-001 by fifteen real stations with a console in a terminal; for the second half of each with a
// mirror of every station (LOAD-004): how long a key takes to its screen, what the server costs, how late the ticks
// are, how old the mirror's tiles get. Beside them the floors of the same run and shape (load_floor.cpp): fifteen bare
// stations at a bare echo, and a bare beat on every processor, all the time (late_ticks.hpp).
//
//   bench_load [SECONDS]   per load, default 20; LOAD-003 wants 600 in all: bench_load 200
#include <array>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>

#include "figure.hpp"
#include "harness/classroom.hpp"
#include "late_ticks.hpp"
#include "process_figures.hpp"
#include "typist.hpp"

namespace cnclab::bench {
namespace {

/// When each station pressed the key that its mirror has not shown yet, in ns; 0: none.
using Pressed = std::array<std::atomic<std::int64_t>, kStations + 1>;

std::int64_t now_ns() { return Clock::now().time_since_epoch().count(); }

/// A console's view of one station: its screens as they come. A tile's age is counted from the key on, so that what the
/// server needs is part of it.
class Tile {
 public:
  Tile(std::uint16_t port, int station) : line_(port), station_(station) {}

  bool open(const std::string& password) {
    v1::ClientMessage hello, login, watch;
    hello.mutable_hello()->set_version(kProtocolVersion);
    hello.mutable_hello()->set_kind(v1::CLIENT_KIND_INSTRUCTOR);
    line_.send(hello);
    login.mutable_login()->set_user("lehrer");
    login.mutable_login()->set_password(password);
    line_.send(login);
    for (auto message = line_.read(10s); message; message = line_.read(10s)) {
      if (!message->has_login()) continue;
      watch.mutable_request()->set_number(1);
      watch.mutable_request()->mutable_watch()->set_station(static_cast<std::uint32_t>(station_));
      line_.send(watch);
      return message->login().result() == v1::LOGIN_RESULT_OK;
    }
    return false;
  }

  void follow(Pressed& pressed, const std::atomic<bool>& is_over) {
    const std::uint64_t before = line_.received_bytes();
    while (!is_over) {
      const auto message = line_.read(100ms);
      if (!message) continue;
      v1::ClientMessage answer;
      if (message->has_beat()) {
        answer.mutable_alive()->set_beat(message->beat().number());
      } else if (message->has_screen()) {
        answer.mutable_screen_ack()->set_number(message->screen().number());
        if (const auto at = pressed[static_cast<std::size_t>(station_)].exchange(0))
          ages_ms.push_back(static_cast<double>(now_ns() - at) / 1e6);
      } else {
        continue;
      }
      line_.send(answer);
    }
    bytes = line_.received_bytes() - before;
  }

  Times ages_ms;
  std::uint64_t bytes = 0;

 private:
  Line line_;
  int station_;
};

struct Load {
  const char* name;
  int typing;  ///< the others run their programs and turn the potentiometer
};

/// What all stations and tiles measured.
struct Measured {
  Times keys_us, ages_ms;
  std::uint64_t mirrored_bytes = 0;
};

harness::Launch floor_program(std::vector<std::string> arguments) {
  return {harness::programs_folder() / "load_floor", std::move(arguments), {}, {}};
}

/// Fifteen bare stations in processes of their own, ten keys a second each.
Times floor_keys_us(std::chrono::seconds time) {
  harness::ChildProcess server(floor_program({"serve"}));
  const auto port = server.read_line(harness::Deadline(5s));
  if (!port) throw std::runtime_error("the bare server did not start");
  std::vector<harness::ChildProcess> stations;
  for (int i = 0; i < kStations; ++i) stations.emplace_back(floor_program({"type", *port}));
  std::mutex mutex;
  Times all;
  std::vector<std::jthread> students;
  const auto end = Clock::now() + time;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    students.emplace_back([&, i] {
      Times mine;
      for (auto next = Clock::now() + static_cast<int>(i) * kBetweenKeys / kStations; next < end;
           next += kBetweenKeys) {
        std::this_thread::sleep_until(next);
        const auto before = Clock::now();
        if (!stations[i].write("key\n") || !stations[i].read_line(harness::Deadline(5s)))
          throw std::runtime_error("a bare station ended");
        mine.push_back(std::chrono::duration<double, std::micro>(Clock::now() - before).count());
      }
      const std::lock_guard lock(mutex);
      all.insert(all.end(), mine.begin(), mine.end());
    });
  }
  students.clear();
  return all;
}

/// One student: ten keys a second until the end. The station says `ok` when its screen contains the effect.
Times work(harness::StationProcess& seat, int station, bool types, Clock::time_point end, Pressed& pressed) {
  seat.key(types ? "MENU EINGABE ENTER ENTER" : "MENU AUTOMAT ENTER ENTER START");
  Times times;
  auto next = Clock::now() + station * kBetweenKeys / kStations;
  for (std::uint32_t i = 0; next < end; ++i, next += kBetweenKeys) {
    std::this_thread::sleep_until(next);
    pressed[static_cast<std::size_t>(station)] = now_ns();
    const auto before = Clock::now();
    seat.expect_ok(types ? (i % 5 == 4 ? "key CLEAR" : "key 1") : fmt::format("pot {}", 60 + i % 40));
    times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - before).count());
  }
  seat.key(types ? "MENU" : "STOP");
  std::this_thread::sleep_for(1s);  // the axes come to rest
  return times;
}

/// The console that an instructor looks at, on a terminal that is read all the time.
void look_at_console(harness::Classroom& room, const std::atomic<bool>& is_over) {
  harness::Terminal console(
      {.program = harness::programs_folder() / "cnclab-instructor",
       .arguments = {"--server", room.server().address(), "--user", "lehrer", "--password-file",
                     room.passwords().file_of("lehrer").string(), "--fingerprint", room.server().fingerprint()},
       .environment = {},
       .rows = 24,
       .columns = 80});
  console.wait_for("q Ende");
  for (; !is_over; std::this_thread::sleep_for(20ms)) console.update();
}

using Seats = std::vector<harness::StationProcess>;

Measured measure(harness::Classroom& room, Seats& seats, const Load& load, std::chrono::seconds time,
                 bool is_mirrored) {
  Measured all;
  std::mutex mutex;
  Pressed pressed{};
  std::atomic<bool> is_over = false;
  const auto end = Clock::now() + time;
  const auto port = room.server().port();
  std::jthread console([&] { look_at_console(room, is_over); });
  std::vector<std::jthread> tiles, students;
  for (int station = 1; station <= kStations; ++station) {
    students.emplace_back([&, station] {
      harness::StationProcess& seat = seats[static_cast<std::size_t>(station - 1)];
      const Times mine = work(seat, station, station <= load.typing, end, pressed);
      const std::lock_guard lock(mutex);
      all.keys_us.insert(all.keys_us.end(), mine.begin(), mine.end());
    });
    if (!is_mirrored) continue;
    tiles.emplace_back([&, station, password = room.passwords().password_of("lehrer")] {
      Tile tile(port, station);
      if (!tile.open(password)) throw std::runtime_error("the console did not get in");
      tile.follow(pressed, is_over);
      const std::lock_guard lock(mutex);
      all.ages_ms.insert(all.ages_ms.end(), tile.ages_ms.begin(), tile.ages_ms.end());
      all.mirrored_bytes += tile.bytes;
    });
  }
  students.clear();
  is_over = true;
  tiles.clear();
  return all;
}

/// floor_p99_us   of the bare stations
void run(harness::Classroom& room, Seats& seats, const Load& load, std::chrono::seconds time, double floor_p99_us) {
  const pid_t server = room.server().pid();
  const double cpu_before = cpu_seconds(server);
  const double late_before = room.instructor().status()["ticks"]["late"];
  const auto start = Clock::now();
  Measured measured = measure(room, seats, load, time / 2, false);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const double cpu_percent = 100 * (cpu_seconds(server) - cpu_before) / seconds;
  Measured mirrored = measure(room, seats, load, time - time / 2, true);
  const double mirrored_seconds = std::chrono::duration<double>(Clock::now() - start).count() - seconds;
  const auto ticks = room.instructor().status()["ticks"];
  const auto figure = [&](const char* what, double value, const char* unit) {
    print_figure(fmt::format("load_{}_{}", load.name, what), value, unit);
  };
  figure("key_to_screen_us_p50", percentile(measured.keys_us, 0.50), "us");
  figure("key_to_screen_us_p99", percentile(measured.keys_us, 0.99), "us");
  figure("key_to_screen_to_floor_p99", percentile(measured.keys_us, 0.99) / floor_p99_us, "1");
  figure("server_cpu_percent", cpu_percent, "%");
  figure("server_rss_mib", rss_mib(server), "MiB");
  figure("late_ticks", ticks["late"].get<double>() - late_before, "1");
  figure("longest_tick_delay_ms", ticks["longest_ms"], "ms");
  constexpr double kBitsPerByte = 8, kKilo = 1000;
  figure("mirror_kbit_per_s", static_cast<double>(mirrored.mirrored_bytes) * kBitsPerByte / mirrored_seconds / kKilo,
         "kbit/s");
  figure("mirror_tile_age_ms_p95", percentile(mirrored.ages_ms, 0.95), "ms");
}

void run_all(std::chrono::seconds time) {
  BareBeats beats(harness::programs_folder() / "load_floor");
  harness::Classroom room;
  const std::string endless = "P0001N001G11F2000N002G01X+20000Y+10000N003G01X-20000Y-10000N004G20P0001N002%";
  for (int i = 1; i <= kStations; ++i) room.add_student(student_name(i), {endless});
  Seats seats;
  for (int i = 1; i <= kStations; ++i) seats.push_back(room.seat(i, student_name(i)));
  auto echo = ping_pong();
  print_percentiles("tcp_tls_pingpong_us", echo, "us");
  auto floor = floor_keys_us(std::min(time, 20s));
  print_percentiles("load_floor_key_to_screen_us", floor, "us");
  for (const Load& load : {Load{"typing", 15}, {"running", 0}, {"mixed", 8}})
    run(room, seats, load, time, percentile(floor, 0.99));
  const WallTimes ticks = very_late_ticks(room.server().log());
  print_figure("load_very_late_ticks", static_cast<double>(ticks.size()), "1");
  print_figure("load_very_late_ticks_unexplained", static_cast<double>(count_unexplained(ticks, beats.end())), "1");
}

}  // namespace
}  // namespace cnclab::bench

int main(int argc, char** argv) try {
  constexpr int kSeconds = 20;
  cnclab::bench::run_all(std::chrono::seconds(argc > 1 ? std::max(1, std::atoi(argv[1])) : kSeconds));
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "bench_load: {}\n", error.what());
  return 1;
}
