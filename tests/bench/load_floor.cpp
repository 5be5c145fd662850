// The floor of bench_load in its own shape: processes, pipes, TLS and a beat, without any control behind them.
//
//   load_floor serve       the bare echo server: prints its port, ends with its standard input
//   load_floor type PORT   one bare station: for each line of standard input a key goes there and a screen comes back:
//                          "ok"
//   load_floor beat CPU    the bare beat of 1 ms on one processor: at the end of standard input "TICKS LATE
//   LONGEST_MS",
//                          and on a line of its own when it was late: milliseconds since 1970, in their order
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "typist.hpp"

namespace cnclab::bench {
namespace {

void wait_for_end_of_input() {
  char byte = 0;
  while (read(STDIN_FILENO, &byte, 1) > 0) {
  }
}

void serve() {
  const EchoServer server(screen_sized_frame());
  std::cout << server.port() << std::endl;
  wait_for_end_of_input();
}

void type(std::uint16_t port) {
  Line line(port);
  const v1::ClientMessage key = one_key();
  for (std::string command; std::getline(std::cin, command);) {
    line.send(key);
    if (!line.read(5s)) throw std::runtime_error("the echo ended");
    std::cout << "ok" << std::endl;
  }
}

std::int64_t wall_ms() {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(since_1970).count();
}

bool has_input_ended() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, 0) > 0;
}

struct Beats {
  std::uint64_t ticks = 0;
  std::int64_t longest_ns = 0;
  std::vector<std::int64_t> late_at_ms;  ///< of those late by more than a period
};

/// As the server's tick thread waits, at its priority where the system grants one, and does nothing.
Beats beat_until_input_ends(int processor) {
  constexpr int kPriority = 60;
  constexpr std::int64_t kPeriod_ns = 1'000'000, kSecond_ns = 1'000'000'000;
  const sched_param priority{.sched_priority = kPriority};
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
  prctl(PR_SET_TIMERSLACK, 1);
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(processor, &only);
  sched_setaffinity(0, sizeof only, &only);
  const auto now_ns = [] { return Clock::now().time_since_epoch().count(); };
  std::int64_t due_ns = now_ns();
  Beats beats;
  while (!has_input_ended()) {
    due_ns += kPeriod_ns;
    const timespec due{.tv_sec = due_ns / kSecond_ns, .tv_nsec = due_ns % kSecond_ns};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr);
    const std::int64_t delay_ns = now_ns() - due_ns;
    ++beats.ticks;
    if (delay_ns > kPeriod_ns) beats.late_at_ms.push_back(wall_ms());
    beats.longest_ns = std::max(beats.longest_ns, delay_ns);
    due_ns = std::max(due_ns, due_ns + delay_ns - kPeriod_ns);  // lost time is not made up for, as in the server
  }
  return beats;
}

void beat(int processor) {
  const Beats beats = beat_until_input_ends(processor);
  fmt::print("{} {} {:.3f}\n{}\n", beats.ticks, beats.late_at_ms.size(), static_cast<double>(beats.longest_ns) / 1e6,
             fmt::join(beats.late_at_ms, " "));
  std::fflush(stdout);
}

}  // namespace
}  // namespace cnclab::bench

int main(int argc, char** argv) try {
  using namespace cnclab::bench;
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "serve") {
    serve();
  } else if (what == "type" && argc > 2) {
    type(static_cast<std::uint16_t>(std::atoi(argv[2])));
  } else if (what == "beat" && argc > 2) {
    beat(std::atoi(argv[2]));
  } else {
    fmt::print(stderr, "load_floor: serve, type PORT or beat CPU; bench_load starts it\n");
    return 2;
  }
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "load_floor: {}\n", error.what());
  return 1;
}
