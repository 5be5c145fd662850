// A full classroom against the real server: from key to screen with 15 stations typing, memory and load with 15
// programs running; beside the floor, the same frames echoed by a bare Asio server (LOAD-001).
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <mutex>
#include <thread>

#include "cnclab/v1/envelope.pb.h"
#include "echo_server.hpp"
#include "figure.hpp"
#include "harness/classroom.hpp"
#include "line.hpp"
#include "shared/frame.hpp"
#include "shared/key.hpp"

namespace cnclab {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr int kStations = 15;
constexpr int kKeys = 200;            ///< per station
constexpr auto kBetweenKeys = 100ms;  ///< 10 keys/s

/// What one station measured, µs each.
using Times = std::vector<double>;

/// A station that types: keeps its screen acknowledged and times each key until the screen that contains it.
class Typist {
 public:
  Typist(std::uint16_t port, int station) : line_(port), station_(station) {}

  bool log_in(const std::string& user, const std::string& password) {
    v1::ClientMessage hello, login;
    hello.mutable_hello()->set_version(kProtocolVersion);
    hello.mutable_hello()->set_kind(v1::CLIENT_KIND_STATION);
    line_.send(hello);
    login.mutable_login()->set_user(user);
    login.mutable_login()->set_password(password);
    login.mutable_login()->set_station(static_cast<std::uint32_t>(station_));
    line_.send(login);
    while (const auto message = line_.read(10s))
      if (message->has_login()) return message->login().result() == v1::LOGIN_RESULT_OK;
    return false;
  }

  /// Presses one key and waits for its effect.
  double press(Key key) {
    const auto start = Clock::now();
    v1::ClientMessage message;
    auto& event = *message.mutable_key();
    event.set_number(++number_);
    event.add_keys(static_cast<v1::Key>(key));
    event.set_pressed(true);
    event.mutable_seen()->set_beat(beat_);
    event.mutable_seen()->set_state(state_);
    line_.send(message);
    while (handled_ < number_)
      if (!follow(5s)) throw std::runtime_error("no screen came within 5 s");
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
  }

  /// Reads and acknowledges what comes until the time is over.
  void idle_until(Clock::time_point end) {
    while (Clock::now() < end) {
      const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
      if (rest <= 0ms || !follow(rest)) return;
    }
  }

 private:
  bool follow(std::chrono::milliseconds limit) {
    const auto message = line_.read(limit);
    if (!message) return false;
    v1::ClientMessage answer;
    if (message->has_beat()) {
      beat_ = message->beat().number();
      answer.mutable_alive()->set_beat(beat_);
    } else if (message->has_screen()) {
      handled_ = std::max(handled_, message->screen().handled_key());
      state_ = message->screen().state();
      answer.mutable_screen_ack()->set_number(message->screen().number());
    } else {
      return true;
    }
    line_.send(answer);
    return true;
  }

  bench::Line line_;
  int station_;
  std::uint64_t number_ = 0, handled_ = 0, beat_ = 0, state_ = 0;
};

Times type_in_classroom(harness::Classroom& classroom) {
  std::mutex mutex;
  Times all;
  {
    std::vector<std::jthread> threads;
    for (int station = 1; station <= kStations; ++station) {
      threads.emplace_back([&, station] {
        const std::string name = fmt::format("schueler{:02}", station);
        std::string password;
        {
          const std::lock_guard lock(mutex);
          password = classroom.passwords().password_of(name);
        }
        Typist typist(classroom.server().port(), station);
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

/// The same load on the echo server: a key-sized frame there, a screen-sized one back.
Times ping_pong() {
  v1::ServerMessage screen;
  auto& row = *screen.mutable_screen()->add_rows();
  row.add_spans()->set_text(std::string(80, 'x'));
  const bench::EchoServer server(frame(screen));
  std::mutex mutex;
  Times all;
  {
    std::vector<std::jthread> threads;
    for (int station = 1; station <= kStations; ++station) {
      threads.emplace_back([&, station] {
        bench::Line line(server.port());
        v1::ClientMessage key;
        key.mutable_key()->set_number(1);
        key.mutable_key()->add_keys(v1::KEY_1);
        key.mutable_key()->set_pressed(true);
        key.mutable_key()->mutable_seen()->set_beat(123'456);
        Times mine;
        auto next = Clock::now() + station * kBetweenKeys / kStations;
        for (int i = 0; i < kKeys; ++i) {
          std::this_thread::sleep_until(next);
          next += kBetweenKeys;
          const auto start = Clock::now();
          line.send(key);
          if (!line.read(5s)) throw std::runtime_error("the echo ended");
          mine.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
        }
        const std::lock_guard lock(mutex);
        all.insert(all.end(), mine.begin(), mine.end());
      });
    }
  }
  return all;
}

/// Seconds of processor time that a process has used.
double cpu_seconds(pid_t pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string text((std::istreambuf_iterator<char>(file)), {});
  std::istringstream fields(text.substr(text.rfind(')') + 2));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double rss_mib(pid_t pid) {
  std::ifstream file(fmt::format("/proc/{}/status", pid));
  for (std::string line; std::getline(file, line);)
    if (line.rfind("VmRSS:", 0) == 0) return std::stod(line.substr(6)) / 1024;
  return 0;
}

/// Fifteen programs on fifteen training machines; share of one core over some seconds.
double run_in_classroom(harness::Classroom& classroom) {
  std::vector<harness::StationProcess> seats;
  for (int station = 1; station <= kStations; ++station)
    seats.push_back(classroom.seat(station, fmt::format("schueler{:02}", station)));
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
  for (int i = 1; i <= kStations; ++i) classroom.add_student(fmt::format("schueler{:02}", i), {endless});
  auto floor = ping_pong();
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
